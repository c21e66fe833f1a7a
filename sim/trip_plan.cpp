#include "sim/approach.h"
#include "sim/flight_script.h"
#include "sim/propellant.h"
#include "sim/trip.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

/// The autopilot's trip before it is flown.
namespace sim {
namespace {

/// Part of the propellant that a trip leaves for corrections.
constexpr double reserve = 1e-3;

TripTask task_of(const Approach& from, const VehicleSettings& settings, bool boosted) {
    TripTask task;
    task.way = from.way;
    task.velocity = from.four_velocity.space;
    const double thrust = trip_acceleration(settings, boosted);
    task.acceleration = first_burn_share * thrust;
    task.braking = braking_share(settings) * thrust;
    task.tick = 1.0 / settings.tick_rate;
    return task;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Ticks that a turn takes, with a few to settle.
double ticks_to_turn(const VehicleSettings& settings, const glm::dvec3& from, const glm::dvec3& to) {
    constexpr double settling = 4.0;
    return std::ceil(turn_duration(settings, angle_between(from, to)) * settings.tick_rate) + settling;
}

/// The trip with the turns that a ship which must turn to thrust has to wait for; they depend on the burns, and these
/// on them.
std::optional<Trip> solve_with_turns(TripTask& task, const Approach& from, const VehicleSettings& settings) {
    std::optional<Trip> trip = solve_trip(task);
    constexpr int rounds = 5; // turns are short against trips: each round gains at least a digit
    for (int i = 0; i < rounds && trip && must_turn_to_thrust(settings); ++i) {
        const double peak = glm::length(trip->peak);
        if (peak == 0.0) {
            break;
        }
        const Lorentz<Goal, Vehicle> at_peak = boost<Goal, Vehicle>(Rapidity(std::asinh(peak)), trip->peak / peak);
        const BoostAndRotation burn = split({(inverse(from.goal_from_vehicle) * at_peak).spin});
        const Lorentz<Goal, Vehicle> after = from.goal_from_vehicle * boost<Vehicle, Vehicle>(burn.xi, burn.along);
        const BoostAndRotation motion = split({after.spin});
        const glm::dvec3 motion_in_vehicle = glm::transpose(motion.boosted_from_head) * motion.along;
        task.wait = ticks_to_turn(settings, {0.0, 0.0, -1.0}, burn.along);
        task.coast = ticks_to_turn(settings, burn.along, -motion_in_vehicle);
        trip = solve_trip(task);
    }
    return trip;
}

/// Coasts for as many ticks as it takes to bring the burns within `budget`.
std::optional<Trip> solve_within(TripTask& task, const Trip& unlimited, double budget) {
    double low = task.coast;
    double step = std::max(unlimited.schedule.total(), 16.0);
    std::optional<Trip> best;
    while (!best && task.coast < longest_trip_ticks) {
        task.coast = low + step;
        const std::optional<Trip> trip = solve_trip(task);
        if (trip && trip->spent().value <= budget) {
            best = trip;
        } else {
            low = task.coast;
            step *= 2.0;
        }
    }
    for (double high = task.coast; best && high - low > 1.0;) {
        task.coast = std::floor(0.5 * (low + high));
        const std::optional<Trip> trip = solve_trip(task);
        if (trip && trip->spent().value <= budget) {
            best = trip;
            high = task.coast;
        } else {
            low = task.coast;
        }
    }
    return best;
}

double gamma_in_world(const InertialObject& target, const glm::dvec3& u) {
    const FourVector<Goal> four_velocity{std::sqrt(1.0 + glm::dot(u, u)), u};
    return (inverse(goal_from_world(target)) * four_velocity).t;
}

} // namespace

bool must_turn_to_thrust(const VehicleSettings& settings) {
    const glm::dvec3& a = settings.maximum_acceleration;
    return std::min(a.x, a.y) < 0.999 * a.z;
}

double trip_acceleration(const VehicleSettings& settings, bool boosted) {
    const double ahead = (boosted ? settings.boost_factor : 1.0) * settings.maximum_acceleration.z;
    const double limit = must_turn_to_thrust(settings)
                             ? ahead
                             : std::min({settings.maximum_acceleration.x, settings.maximum_acceleration.y,
                                         settings.maximum_acceleration.z}) *
                                   (boosted ? settings.boost_factor : 1.0);
    return std::isfinite(limit) ? limit : 1.0;
}

double braking_share(const VehicleSettings& settings) {
    // A nose that is still turning costs some of the burn.
    return must_turn_to_thrust(settings) ? 0.97 : 0.9999;
}

double turn_duration(const VehicleSettings& settings, double angle) {
    const double rate = std::min(settings.maximum_turn_rate.x, settings.maximum_turn_rate.y);
    const double change = std::min(settings.maximum_turn_acceleration.x, settings.maximum_turn_acceleration.y);
    if (std::isinf(rate) && std::isinf(change)) {
        return 0.0;
    }
    if (std::isinf(change)) {
        return angle / rate;
    }
    return angle * change < rate * rate ? 2.0 * std::sqrt(angle / change) : angle / rate + rate / change;
}

TripForecast plan_trip(const VehicleState& state, const VehicleSettings& settings, bool boosted) {
    TripForecast plan;
    if (state.guidance.has_target == 0) {
        plan.problem = TripProblem::no_target;
        return plan;
    }
    const InertialObject& target = state.guidance.target;
    Approach from = approach(state, target);
    TripTask task = task_of(from, settings, boosted);
    plan.phase = AutopilotPhase::accelerating;
    std::optional<Trip> trip = solve_with_turns(task, from, settings);
    double goal_time = 0.0;
    double budget = rapidity_left(settings, state).value * (1.0 - reserve);
    if (!trip) {
        plan.phase = AutopilotPhase::stopping;
        const double xi = from.motion.xi.value;
        plan.stopping_ticks = std::ceil(xi * settings.tick_rate / task.acceleration);
        const double half = std::tanh(0.5 * xi) / task.acceleration;
        goal_time = half * (from.four_velocity.t + 1.0);
        from.way -= half * from.four_velocity.space;
        from.four_velocity = {1.0, glm::dvec3(0.0)};
        from.goal_from_vehicle = {};
        budget -= xi;
        task = task_of(from, settings, boosted);
        trip = solve_with_turns(task, from, settings);
        plan.rapidity_spent = Rapidity(xi);
    }
    if (trip && trip->spent().value > budget) {
        trip = budget > 0.0 ? solve_within(task, *trip, budget) : std::nullopt;
    }
    if (!trip) {
        plan.problem = TripProblem::too_little_propellant;
        return plan;
    }
    plan.trip = *trip;
    const double ticks = plan.stopping_ticks + trip->schedule.total();
    plan.ship_time = ProperTime(ticks / settings.tick_rate);
    goal_time += trip->goal_time;
    const Approach start = approach(state, target);
    plan.world_time = CoordinateTime((inverse(goal_from_world(target)) * FourVector<Goal>{goal_time, start.way}).t);
    plan.peak_gamma = std::max({gamma_in_world(target, trip->peak), gamma_in_world(target, start.four_velocity.space),
                                gamma_in_world(target, glm::dvec3(0.0))});
    plan.rapidity_spent = plan.rapidity_spent + trip->spent();
    plan.mass_ratio = mass_ratio(settings, plan.rapidity_spent);
    if (trip->second > largest_rapidity) {
        plan.problem = TripProblem::too_fast;
    } else if (ticks > longest_trip_ticks) {
        plan.problem = TripProblem::too_slow;
    }
    return plan;
}

} // namespace sim
