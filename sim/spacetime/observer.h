#pragma once

#include "sim/spacetime/tetrad.h"

#include <cstdint>
#include <optional>

/// Four-velocities of the observers that textbooks know, u^mu in the chart, at any event of any spacetime.
namespace sim {

/// Kinds of observers. They are asked for by name.
enum class ObserverKind : std::uint8_t {
    at_rest,               ///< u along d_t: hovers
    zero_angular_momentum, ///< u along d_t + omega d_phi with L_z = 0: turns with space (ZAMO)
    circular_orbit,        ///< u along d_t + Omega d_phi and geodesic: orbits about z in the plane z = 0, prograde
    free_fall,             ///< from rest at infinity, where there is one; else the chart's own free fall
};

/// u^mu with u.u = -1 along the given vector; nothing where that is not time-like.
template <class Spacetime>
std::optional<Components<double>> unit_velocity(const Spacetime& spacetime, const Components<double>& event,
                                                const Components<double>& along) {
    const double norm = contract(along, spacetime.metric(event) * along);
    if (!(norm < 0.0)) {
        return std::nullopt;
    }
    return (1.0 / std::sqrt(-norm)) * along;
}

/// g(d_t, d_t), g(d_t, d_phi), g(d_phi, d_phi) for the Killing vectors of a stationary spacetime with the axis z.
template <class Spacetime, class T>
std::array<T, 3> killing_products(const Spacetime& spacetime, const Components<T>& event) {
    const SymmetricTensor<T> g = spacetime.metric(event);
    const Components<T> turn{T(0.0), -event.y, event.x, T(0.0)};
    const Components<T> lowered = g * turn;
    return {g(0, 0), lowered.t, contract(turn, lowered)};
}

/// The angular velocity dphi/dt of a circular geodesic about z through an event of the plane z = 0; `sense` +1 or -1.
/// Root of d_r(g_tt + 2 Omega g_t_phi + Omega^2 g_phi_phi) = 0, by automatic differentiation.
template <class Spacetime>
double circular_angular_velocity(const Spacetime& spacetime, const Components<double>& event, double sense) {
    using D = Dual<double, 1>;
    const double r = std::hypot(event.x, event.y);
    Components<D> x{event.t, event.x, event.y, event.z};
    x.x.slope[0] = event.x / r;
    x.y.slope[0] = event.y / r;
    const auto [tt, tphi, phiphi] = killing_products(spacetime, x);
    const double a = phiphi.slope[0], b = tphi.slope[0], c = tt.slope[0];
    return (-b + sense * std::sqrt(b * b - a * c)) / a;
}

/// The four-velocity of an observer at an event; nothing where that kind cannot be (at rest inside a horizon, an orbit
/// within the orbit of light or off the plane z = 0).
template <class Spacetime>
std::optional<Components<double>> observer_velocity(const Spacetime& spacetime, const Components<double>& event,
                                                    ObserverKind kind) {
    const auto turning = [&](double omega) {
        return unit_velocity(spacetime, event, {1.0, -omega * event.y, omega * event.x, 0.0});
    };
    switch (kind) {
    case ObserverKind::at_rest:
        return turning(0.0);
    case ObserverKind::zero_angular_momentum: {
        const auto [tt, tphi, phiphi] = killing_products(spacetime, event);
        return turning(phiphi > 0.0 ? -tphi / phiphi : 0.0);
    }
    case ObserverKind::circular_orbit:
        if (!(std::abs(event.z) <= 1e-12 * std::hypot(event.x, event.y))) {
            return std::nullopt;
        }
        return turning(circular_angular_velocity(spacetime, event, 1.0));
    case ObserverKind::free_fall:
        return spacetime.inverse_metric(event) * spacetime.falling_covelocity(event);
    }
    return std::nullopt;
}

} // namespace sim
