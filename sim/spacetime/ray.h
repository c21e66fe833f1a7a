#pragma once

#include "sim/spacetime/asymptotics.h"
#include "sim/spacetime/tetrad.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>

/// One ray of light, followed from an eye into the past through any spacetime, by rk4_step.
namespace sim {

/// How a ray ended.
enum class RayOutcome : std::uint8_t {
    escaped,          ///< it comes from infinity
    captured,         ///< it would come from a horizon: nothing is seen there
    hit_object,       ///< the visitor stopped it
    step_limit,       ///< more steps than allowed
    left_chart,       ///< where the spacetime's chart ends, or no finite numbers
    constraint_drift, ///< H strayed from 0 by more than allowed
};

/// Name of an outcome, fit for a table.
std::string_view name_of(RayOutcome outcome);

/// How a ray is followed.
struct RaySettings {
    double step = 0.05; ///< of the spacetime's own parameter, > 0; halving it divides the error by 16
    std::uint32_t step_limit = 100000;
    double tail_error = 1e-13;    ///< rad; bending that is left when a ray counts as escaped
    double escape_radius = 0.0;   ///< chart length; no ray counts as escaped before: further out than all objects
    double drift_limit = 1e-3;    ///< of |H| relative to (p^t)^2
    double blueshift_limit = 1e7; ///< of p^t since the eye: more means a horizon
    bool nothing_near_horizon =
        true; ///< no object can be met inside the innermost orbit of light: captures are called early
};

/// One step of a ray, from nearer to further from the eye. x^mu(s) between the ends is the cubic Hermite through both
/// (error of order step^4, as the ray's own): s from 0 at `from` to `length` at `to`.
struct RaySegment {
    GeodesicState<double> from; ///< x^mu, p_mu; the photon's own momentum, future-directed, -p.u = 1 for the eye
    GeodesicState<double> to;
    Components<double> from_tangent; ///< dx^mu/ds away from the eye (into the past)
    Components<double> to_tangent;
    double length;         ///< in s, > 0
    bool straight = false; ///< through flat space: the momentum stays, x^mu is linear in s

    /// x^mu at `share` of the step, 0 to 1.
    Components<double> at(double share) const {
        const double u = share, v = 1.0 - share;
        return (v * v * (1.0 + 2.0 * u)) * from.position + (u * u * (1.0 + 2.0 * v)) * to.position +
               (u * v * v * length) * from_tangent - (u * u * v * length) * to_tangent;
    }
};

enum class Visit : std::uint8_t { go_on, stop };

/// Visits nothing.
struct NoVisitor {};

/// What became of a ray.
struct RayResult {
    RayOutcome outcome = RayOutcome::step_limit;
    Asymptotics infinity;      ///< where it comes from and nu there (the eye's is 1); meaningful when escaped
    GeodesicState<double> end; ///< last event and momentum
    std::uint32_t steps = 0;
    std::uint32_t reversed_steps = 0; ///< the first of them, that many, went through the time-reversed chart
    double hamiltonian_drift = 0.0;   ///< |H|/(p^t)^2 at the end
    /// |change| of Spacetime::conserved_names, relative where they were above 1: at the end, or where an escaping ray
    /// was last within 1/10 of the escape radius, for further out the rounding of x grows into x p_y - y p_x.
    std::array<double, 4> drifts{};
    double error = std::numeric_limits<double>::quiet_NaN(); ///< estimated, of the direction, rad; see with_error

    /// nu_eye/nu_infinity = lambda_infinity/lambda_eye = 1/D.
    double frequency_ratio() const { return 1.0 / infinity.frequency; }
};

/// Angle between two unit vectors, without cancellation near 0 and pi.
inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = a - b, s = a + b;
    return 2.0 * std::atan2(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z));
}

/// Where a ray from this eye counts as escaped.
template <class Spacetime>
double escape_radius(const Spacetime& spacetime, const Components<double>& eye, const RaySettings& settings) {
    return std::max(settings.escape_radius, spacetime.flat_beyond(spacetime.remoteness(eye), settings.tail_error));
}

/// Below which remoteness a ray that is on its way in comes from a horizon; 0 where there is none.
template <class Spacetime>
double capture_radius(const Spacetime& spacetime, const RaySettings& settings) {
    if constexpr (requires { spacetime.radii; }) {
        return spacetime.radii.capture_radius(settings.nothing_near_horizon);
    } else {
        return 0.0;
    }
}

/// The square of the chart's |p_i|: what tells of blueshift without measuring it.
template <class T>
T momentum2(const GeodesicState<T>& state) {
    const auto& p = state.momentum;
    return p.x * p.x + p.y * p.y + p.z * p.z;
}

/// A spacetime with a second chart, in which its rays' equations look the same (sim::time_reversed).
template <class Spacetime>
concept TimeReversible = requires(const Spacetime& spacetime, const GeodesicState<double>& state) {
    spacetime.time_reversed(state);
};

/// Whether a ray that starts so is on its way in to a hole, into the past, so that its first part belongs into the
/// time-reversed chart: until it no longer comes nearer.
template <class Spacetime>
bool starts_reversed(const Spacetime& spacetime, const GeodesicState<double>& start) {
    if constexpr (TimeReversible<Spacetime>) {
        const auto& x = start.position;
        const Components<double> v = hamilton_equations(spacetime, start).position;
        return spacetime.reversible(x) && x.x * v.x + x.y * v.y + x.z * v.z > 0.0;
    } else {
        return false;
    }
}

/// The state in the other of a spacetime's two charts; unchanged where there is one only.
template <class Spacetime, class T>
GeodesicState<T> in_other_chart(const Spacetime& spacetime, const GeodesicState<T>& state) {
    if constexpr (TimeReversible<Spacetime>) {
        return spacetime.time_reversed(state);
    } else {
        return state;
    }
}

/// The result of a ray that ends at `state`. `measured`: where the conserved quantities are compared.
template <class Spacetime>
RayResult ray_result(const Spacetime& spacetime, RayOutcome outcome, const GeodesicState<double>& start,
                     const GeodesicState<double>& measured, const GeodesicState<double>& state,
                     const RaySettings& settings) {
    RayResult result;
    result.outcome = outcome;
    result.end = state;
    if (outcome == RayOutcome::escaped) {
        result.infinity = spacetime.asymptotics(state);
    }
    const double frequency = hamilton_equations(spacetime, state).position.t;
    result.hamiltonian_drift = std::abs(hamiltonian(spacetime, state)) / (frequency * frequency);
    const auto before = spacetime.conserved(start);
    const auto after = spacetime.conserved(measured);
    for (std::size_t i = 0; i < before.size(); ++i) {
        result.drifts[i] = std::abs(after[i] - before[i]) / std::max(std::abs(before[i]), 1.0);
    }
    // Not "greater": a drift that is no number is a drift.
    if (outcome == RayOutcome::escaped && !(result.hamiltonian_drift <= settings.drift_limit)) {
        result.outcome = RayOutcome::constraint_drift;
    }
    return result;
}

/// Follows the photon `start` (x^mu, p_mu at the eye; -p.u = 1 there) into the past. `visit(const RaySegment&)` is
/// called for every step and may stop the ray (hit_object). With a visitor all steps are in the spacetime's own chart;
/// without one, the way in to a hole goes through the time-reversed chart: a third of the steps at the same error.
template <class Spacetime, class Visitor = NoVisitor>
RayResult follow_ray(const Spacetime& spacetime, const GeodesicState<double>& start, const RaySettings& settings,
                     Visitor&& visit = {}) {
    constexpr bool visited = !std::is_same_v<std::remove_cvref_t<Visitor>, NoVisitor>;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double far = escape_radius(spacetime, start.position, settings);
    const double caught = capture_radius(spacetime, settings);
    const double blueshift2 =
        Spacetime::may_have_horizon ? settings.blueshift_limit * settings.blueshift_limit * momentum2(start) : infinity;
    bool reversed = !visited && starts_reversed(spacetime, start);
    GeodesicState<double> state = reversed ? in_other_chart(spacetime, start) : start;
    GeodesicState<double> measured = start;
    double remoteness = spacetime.remoteness(start.position);
    std::uint32_t steps = 0;
    std::uint32_t reversed_steps = 0;
    // The last place that the spacetime's own chart knows too: what falls through the horizon of the other leaves it.
    GeodesicState<double> known = state;
    const auto finish = [&](RayOutcome outcome) {
        const GeodesicState<double> end = reversed ? in_other_chart(spacetime, known) : state;
        RayResult result =
            ray_result(spacetime, outcome, start, outcome == RayOutcome::escaped ? measured : end, state, settings);
        result.end = end;
        result.steps = steps;
        result.reversed_steps = reversed_steps;
        return result;
    };
    while (steps < settings.step_limit) {
        const GeodesicState<double> next = geodesic_step(spacetime, state, -settings.step);
        ++steps;
        const double next_remoteness = spacetime.remoteness(next.position);
        const double p2 = momentum2(next);
        if (!(p2 < infinity && next_remoteness < infinity)) {
            return finish(RayOutcome::left_chart);
        }
        if constexpr (visited) {
            const RaySegment segment{state, next, -1.0 * rate_in_own_parameter(spacetime, state).position,
                                     -1.0 * rate_in_own_parameter(spacetime, next).position, settings.step};
            if (visit(segment) == Visit::stop) {
                state = next;
                return finish(RayOutcome::hit_object);
            }
        }
        const bool inwards = next_remoteness < remoteness;
        reversed_steps += reversed ? 1 : 0;
        if (reversed && !inwards) {
            state = in_other_chart(spacetime, next);
            reversed = false;
        } else {
            state = next;
        }
        if (reversed && spacetime.region(next.position) == Region::outside) {
            known = next;
        }
        remoteness = next_remoteness;
        if (remoteness > far) {
            return finish(RayOutcome::escaped);
        }
        if ((remoteness < caught && inwards) || p2 > blueshift2) {
            return finish(RayOutcome::captured);
        }
        if (remoteness < 0.1 * far && !reversed) {
            measured = state;
        }
    }
    return finish(RayOutcome::step_limit);
}

/// The ray that an eye at `event` with `tetrad` sees from the unit direction `seen` (right, up, back).
template <class Spacetime, class Visitor = NoVisitor>
RayResult trace_ray(const Spacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                    const glm::dvec3& seen, const RaySettings& settings, Visitor&& visit = {}) {
    return follow_ray(spacetime, seen_photon(spacetime, event, tetrad, seen), settings, std::forward<Visitor>(visit));
}

/// As trace_ray, with `error`: the ray is followed with the step and with half of it, and the halved one's direction is
/// off by about 1/15 of how far the two differ (order 4); reported is twice that. Infinite when the outcomes differ.
template <class Spacetime>
RayResult trace_ray_with_error(const Spacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                               const glm::dvec3& seen, const RaySettings& settings) {
    const RayResult coarse = trace_ray(spacetime, event, tetrad, seen, settings);
    RaySettings halved = settings;
    halved.step *= 0.5;
    RayResult fine = trace_ray(spacetime, event, tetrad, seen, halved);
    if (fine.outcome != coarse.outcome || fine.infinity.side != coarse.infinity.side) {
        fine.error = std::numeric_limits<double>::infinity();
    } else if (fine.outcome == RayOutcome::escaped) {
        fine.error = 2.0 / 15.0 * angle_between(fine.infinity.direction, coarse.infinity.direction);
    }
    return fine;
}

} // namespace sim
