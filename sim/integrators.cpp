#include "sim/integrators.h"

#include "sim/rk4.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace sim {
namespace {

using Axes = std::array<FourVector<World>, 4>;

/// The sum of components times the three space axes.
FourVector<World> along_axes(const glm::dvec3& v, const Axes& e) {
    return v.x * e[1] + v.y * e[2] + v.z * e[3];
}

/// v without its part along the unit axis e, whose square is `sign`.
FourVector<World> without(const FourVector<World>& v, const FourVector<World>& e, double sign) {
    return v - (sign * dot(v, e)) * e;
}

/// A root of z; the one with a positive real part.
Complex square_root(Complex z) {
    const double magnitude = std::hypot(z.re, z.im);
    const double re = std::sqrt(0.5 * (magnitude + z.re));
    return {re, 0.5 * z.im / re};
}

} // namespace

TetradState operator+(const TetradState& p, const TetradState& q) {
    TetradState sum{p.event + q.event, {}};
    for (std::size_t i = 0; i < sum.axes.size(); ++i) {
        sum.axes[i] = p.axes[i] + q.axes[i];
    }
    return sum;
}

TetradState operator*(double s, const TetradState& p) {
    TetradState product{s * p.event, {}};
    for (std::size_t i = 0; i < product.axes.size(); ++i) {
        product.axes[i] = s * p.axes[i];
    }
    return product;
}

TetradState rk4_tetrad_step(const TetradState& before, ProperTime duration, const Drive& drive) {
    const auto derivative = [&drive](const TetradState& state) {
        const Axes& e = state.axes;
        const glm::dvec3& a = drive.proper_acceleration;
        TetradState rate{e[0], {along_axes(a, e)}};
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 unit(0.0);
            unit[i] = 1.0;
            rate.axes[static_cast<std::size_t>(i) + 1] =
                a[i] * e[0] + along_axes(glm::cross(drive.angular_velocity, unit), e);
        }
        return rate;
    };
    return rk4_step(before, duration.value, derivative);
}

TetradState orthonormal(const TetradState& state) {
    TetradState result = state;
    Axes& e = result.axes;
    e[0] = (1.0 / std::sqrt(-dot(e[0], e[0]))) * e[0];
    for (std::size_t i = 1; i < e.size(); ++i) {
        e[i] = without(e[i], e[0], -1.0);
        for (std::size_t j = 1; j < i; ++j) {
            e[i] = without(e[i], e[j], 1.0);
        }
        e[i] = (1.0 / std::sqrt(dot(e[i], e[i]))) * e[i];
    }
    return result;
}

SpinState rk4_spin_step(const SpinState& before, ProperTime duration, const Drive& drive) {
    const EquationOfMotion equation{before.spin, half_generator(drive)};
    const Motion change = rk4_step(Motion{}, duration.value, equation);
    return {before.event + change.displacement, before.spin + change.spin_change};
}

SpinState scaled_to_unit_determinant(const SpinState& state) {
    const Complex root = square_root(determinant(state.spin));
    const Complex inverse = (1.0 / norm2(root)) * conj(root);
    const SpinMatrix& m = state.spin;
    return {state.event, {inverse * m.a, inverse * m.b, inverse * m.c, inverse * m.d}};
}

SpinState smallest_corrected(const SpinState& state) {
    return {state.event, state.spin + smallest_correction(state.spin, determinant(state.spin))};
}

} // namespace sim
