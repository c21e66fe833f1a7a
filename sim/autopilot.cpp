#include "sim/autopilot.h"

#include "sim/approach.h"
#include "sim/propellant.h"
#include "sim/steering.h"
#include "sim/trip.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {
namespace {

/// At rest at the target: so many ticks' thrust is missing. A few roundings of Lambda where those are more.
constexpr double arrived_ticks = 1e-8;
constexpr double rest = 1e-14;
/// So much beyond the limit a thrust may be asked for; it is not given.
constexpr double rounding = 1e-9;
/// A ship that must turn to thrust burns when its nose is this near to the burn's direction, radians.
constexpr double aligned = 0.03;

class Autopilot {
  public:
    Autopilot(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control)
        : before_(before), settings_(settings), boosted_(control.has(ControlFrame::boost)),
          reach_(thrust_reach(settings, control)), thrust_(trip_acceleration(settings, boosted_)),
          tick_(1.0 / settings.tick_rate), from_(approach(before, before.guidance.target)) {
        result_.guidance = before.guidance;
    }

    AutopilotTick fly() {
        Guidance& guidance = result_.guidance;
        if (guidance.phase == AutopilotPhase::off) {
            begin();
        }
        if (is_flying(guidance.phase) && !arrive()) {
            fly_phase();
        }
        return result_;
    }

  private:
    void begin() {
        const TripForecast plan = plan_trip(before_, settings_, boosted_);
        result_.guidance.peak = plan.trip.peak;
        result_.guidance.schedule = plan.trip.schedule;
        result_.guidance.phase = plan.problem == TripProblem::no_target               ? AutopilotPhase::no_target
                                 : plan.problem == TripProblem::too_little_propellant ? AutopilotPhase::no_propellant
                                                                                      : plan.phase;
    }

    void fly_phase() {
        switch (result_.guidance.phase) {
        case AutopilotPhase::stopping:
            stop();
            break;
        case AutopilotPhase::accelerating:
            accelerate();
            break;
        case AutopilotPhase::coasting:
            coast();
            break;
        default:
            brake();
        }
    }

    /// Light clock units from the target that count as there.
    double near() const { return arrived_ticks * thrust_ * tick_ * tick_ + rest * tick_; }

    bool arrive() {
        const double distance = glm::length(from_.way);
        const double speed = from_.motion.xi.value;
        const bool there = distance <= near() && speed <= std::max(rest, arrived_ticks * thrust_ * tick_);
        if (there) {
            result_.guidance.phase = AutopilotPhase::arrived;
        }
        return there;
    }

    void stop() {
        const double xi = from_.motion.xi.value;
        if (xi < rest) {
            begin();
            return;
        }
        thrust(-std::min(thrust_, xi / tick_) * ahead(), true);
    }

    /// Aims the first burn again, and flies a tick of it.
    void accelerate() {
        Guidance& guidance = result_.guidance;
        TripTask task;
        task.way = from_.way;
        task.velocity = from_.four_velocity.space;
        task.tick = tick_;
        const std::optional<Trip> trip = solve_trip(task, guidance.schedule, guidance.peak);
        if (!trip || trip->first.value > thrust_ * tick_ * guidance.schedule.first ||
            trip->second.value > thrust_ * tick_ * guidance.schedule.second) {
            begin(); // the limits have changed, or the target
            return;
        }
        guidance.peak = trip->peak;
        const BoostAndRotation burn = relative(guidance.peak);
        TripSchedule& schedule = guidance.schedule;
        if (schedule.wait > 0.0) {
            schedule.wait -= 1.0;
            point(burn.along);
            return;
        }
        thrust(burn.xi.value / (tick_ * schedule.first) * burn.along, true);
        schedule.first -= 1.0;
        if (schedule.first == 0.0) {
            guidance.phase = schedule.coast > 0.0 ? AutopilotPhase::coasting : AutopilotPhase::braking;
        }
    }

    void coast() {
        point(-ahead());
        result_.guidance.schedule.coast -= 1.0;
        if (result_.guidance.schedule.coast <= 0.0) {
            result_.guidance.phase = AutopilotPhase::braking;
        }
    }

    /// n ticks of even thrust xi / (n tick) stop the ship after n tick (cosh xi - 1) / xi. What is missing or too much
    /// of the distance is made up by a thrust that changes evenly over the n ticks, the least that does it (3 / (n + 1)
    /// of what one tick would need); it is found anew every tick.
    void brake() {
        TripSchedule& schedule = result_.guidance.schedule;
        const double n = schedule.second;
        const double xi = from_.motion.xi.value;
        if (n < 1.0 || xi == 0.0) {
            begin();
            return;
        }
        const glm::dvec3& u = from_.four_velocity.space;
        const double half = std::sinh(0.5 * xi);
        const double covered = 2.0 * half * half / xi; // of a clock unit of ship time, on average
        const double growth = (std::sinh(xi) - covered) / xi;
        const double missing = glm::dot(from_.way, from_.motion.along) - n * tick_ * covered;
        // At high speed most of the distance is covered within 1 / thrust: what is missing must be made up sooner.
        const double share = std::min(1.0, 3.0 / (n + 1.0) + 3.0 * thrust_ * tick_);
        const double braking = xi / (n * tick_) - (n > 1.0 ? share * missing / (n * tick_ * tick_ * growth) : 0.0);
        // Across the line of sight the ship is slow, and Newton's: the same, where no distance is missing.
        const glm::dvec3 sight = glm::normalize(from_.way);
        const glm::dvec3 across = u - sight * glm::dot(u, sight);
        const glm::dvec3 steer = (n > 1.0 ? -(4.0 * n - 2.0) / (n * (n + 1.0)) : -1.0) / tick_ * across;
        const glm::dvec3 square = steer - from_.motion.along * glm::dot(steer, from_.motion.along);
        if (!(std::hypot(braking, glm::length(square)) <= thrust_ * (1.0 + rounding))) {
            begin();
            return;
        }
        // The thrust of a ship that turns in a tick is not quite what it was: steady at the end.
        const double steady = 3.0 + slowest_stop();
        thrust(-braking * ahead() + glm::transpose(from_.motion.boosted_from_head) * square, n > steady);
        schedule.second -= 1.0;
        if (n == 1.0 && std::abs(missing) <= near() && glm::length(across) <= near() / tick_) {
            result_.guidance.phase = AutopilotPhase::arrived;
        }
    }

    /// Unit vector of the motion, vehicle axes.
    glm::dvec3 ahead() const { return glm::transpose(from_.motion.boosted_from_head) * from_.motion.along; }

    /// The frame that moves with gamma beta `peak` as the vehicle sees it: rapidity and direction, vehicle axes. From
    /// the product of the frames, which does not cancel as four-velocities do.
    BoostAndRotation relative(const glm::dvec3& peak) const {
        const double length = glm::length(peak);
        const Lorentz<Goal, Boosted> at_peak =
            length > 0.0 ? boost<Goal, Boosted>(Rapidity(std::asinh(length)), peak / length) : Lorentz<Goal, Boosted>{};
        return split({(inverse(from_.goal_from_vehicle) * at_peak).spin});
    }

    static double angle_to_nose(const glm::dvec3& direction) {
        return std::atan2(std::hypot(direction.x, direction.y), -direction.z);
    }

    /// Ticks that it takes to stop turning.
    double slowest_stop() const {
        const glm::dvec3 ticks = glm::abs(before_.angular_velocity) / (settings_.maximum_turn_acceleration * tick_);
        return std::ceil(std::max({ticks.x, ticks.y, ticks.z}));
    }

    void point(const glm::dvec3& towards) {
        result_.angular_velocity = limited_turn(before_, settings_, turn_towards(settings_, towards));
    }

    /// Thrust in vehicle axes, as far as the ship can; the nose follows it.
    void thrust(const glm::dvec3& wanted, bool follow) {
        const double magnitude = glm::length(wanted);
        if (magnitude == 0.0) {
            return;
        }
        const glm::dvec3 along = wanted / magnitude;
        if (follow) {
            point(along);
        }
        if (follow && must_turn_to_thrust(settings_) && angle_to_nose(along) > aligned) {
            return;
        }
        const double possible = std::min(magnitude, largest_thrust(along, reach_));
        result_.proper_acceleration = before_turning(possible * along, result_.angular_velocity, ProperTime(tick_));
    }

    const VehicleState& before_;
    const VehicleSettings& settings_;
    bool boosted_;
    glm::dvec3 reach_;
    double thrust_;
    double tick_;
    Approach from_;
    AutopilotTick result_;
};

} // namespace

AutopilotTick fly_autopilot(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control) {
    return Autopilot(before, settings, control).fly();
}

std::string_view phase_name(AutopilotPhase phase) {
    switch (phase) {
    case AutopilotPhase::off:
        return "off";
    case AutopilotPhase::stopping:
        return "coming to rest first";
    case AutopilotPhase::accelerating:
        return "accelerating";
    case AutopilotPhase::coasting:
        return "coasting";
    case AutopilotPhase::braking:
        return "braking";
    case AutopilotPhase::arrived:
        return "arrived at rest";
    case AutopilotPhase::no_target:
        return "no target is chosen";
    case AutopilotPhase::no_propellant:
        return "too little propellant";
    }
    return "";
}

} // namespace sim
