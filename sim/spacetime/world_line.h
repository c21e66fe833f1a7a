#pragma once

#include "sim/spacetime/tetrad.h"

/// Ships and bodies in curved spacetime: thrusting observers with a tetrad (PHYSICS 7).
namespace sim {

/// An observer at one moment of their proper time. With thrust a and turn w in the tetrad's components (right, up,
/// back; what the pilot feels and commands):
///   D e_0/dtau = a^i e_i,   D e_i/dtau = a^i e_0 + (w x e)_i,
/// D the covariant derivative. w = 0 is Fermi and Walker's transport (gyroscopes keep pointing), a = 0 a geodesic.
struct WorldLineState {
    Components<double> event;
    Tetrad tetrad;

    friend WorldLineState operator+(const WorldLineState& a, const WorldLineState& b) {
        WorldLineState sum{a.event + b.event, {}};
        for (std::size_t i = 0; i < 4; ++i) {
            sum.tetrad.legs[i] = a.tetrad.legs[i] + b.tetrad.legs[i];
        }
        return sum;
    }
    friend WorldLineState operator*(double s, const WorldLineState& a) {
        WorldLineState product{s * a.event, {}};
        for (std::size_t i = 0; i < 4; ++i) {
            product.tetrad.legs[i] = s * a.tetrad.legs[i];
        }
        return product;
    }
};

/// d/dtau of the state.
template <class Spacetime>
WorldLineState world_line_rate(const Spacetime& spacetime, const WorldLineState& state, const glm::dvec3& thrust,
                               const glm::dvec3& turn) {
    using D = Dual<double, 4>;
    Components<D> x;
    for (int mu = 0; mu < 4; ++mu) {
        x[mu] = D::variable(state.event[mu], mu);
    }
    const SymmetricTensor<D> g = spacetime.metric(x);
    const SymmetricTensor<double> inverse_g = spacetime.inverse_metric(state.event);
    const auto& e = state.tetrad.legs;
    const Components<double>& u = e[0];
    // Gamma^mu_{ab} u^a v^b = g^{mu nu} (d_a g_{nu b} + d_b g_{nu a} - d_nu g_{ab})/2 u^a v^b.
    const auto connection = [&](const Components<double>& v) {
        Components<double> lowered;
        for (int a = 0; a < 4; ++a) {
            for (int b = 0; b < 4; ++b) {
                const D& gab = g(a, b);
                for (int nu = 0; nu < 4; ++nu) {
                    const double slope = gab.slope[static_cast<std::size_t>(nu)];
                    // d_nu g_{ab} serves once as each of the three terms.
                    lowered[a] += 0.5 * slope * (u[nu] * v[b] + v[nu] * u[b]);
                    lowered[nu] -= 0.5 * slope * u[a] * v[b];
                }
            }
        }
        return inverse_g * lowered;
    };
    const std::array<double, 3> a{thrust.x, thrust.y, thrust.z};
    WorldLineState rate;
    rate.event = u;
    rate.tetrad.legs[0] = a[0] * e[1] + a[1] * e[2] + a[2] * e[3] - connection(u);
    rate.tetrad.legs[1] = a[0] * u + turn.z * e[2] - turn.y * e[3] - connection(e[1]);
    rate.tetrad.legs[2] = a[1] * u + turn.x * e[3] - turn.z * e[1] - connection(e[2]);
    rate.tetrad.legs[3] = a[2] * u + turn.y * e[1] - turn.x * e[2] - connection(e[3]);
    return rate;
}

/// Largest |e_a.e_b - eta_ab|.
template <class Spacetime>
double orthonormality_drift(const Spacetime& spacetime, const WorldLineState& state) {
    const SymmetricTensor<double> g = spacetime.metric(state.event);
    double largest = 0.0;
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
            const double eta = a != b ? 0.0 : a == 0 ? -1.0 : 1.0;
            largest = std::max(largest, std::abs(contract(state.tetrad.legs[a], g * state.tetrad.legs[b]) - eta));
        }
    }
    return largest;
}

/// One fixed step of proper time by rk4_step with constant thrust and turn, then the smallest correction that brings
/// the tetrad back to orthonormal: each pair gives way by half of what is wrong between them.
template <class Spacetime>
WorldLineState advance_observer(const Spacetime& spacetime, const WorldLineState& state, const glm::dvec3& thrust,
                                const glm::dvec3& turn, double proper_time) {
    WorldLineState next = rk4_step(
        state, proper_time, [&](const WorldLineState& at) { return world_line_rate(spacetime, at, thrust, turn); });
    const SymmetricTensor<double> g = spacetime.metric(next.event);
    const auto legs = next.tetrad.legs;
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
            const double sign = b == 0 ? -1.0 : 1.0;
            const double wrong = contract(legs[a], g * legs[b]) - (a == b ? sign : 0.0);
            next.tetrad.legs[a] = next.tetrad.legs[a] - (0.5 * sign * wrong) * legs[b];
        }
    }
    return next;
}

} // namespace sim
