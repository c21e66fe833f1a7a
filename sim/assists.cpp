#include "sim/assists.h"

#include "sim/approach.h"
#include "sim/autopilot.h"
#include "sim/propellant.h"
#include "sim/steering.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// Below this the ship counts as at rest: a few roundings of Lambda, gamma - 1 is 1e-28.
constexpr Rapidity rapidity_at_rest{1e-14};

/// c per clock unit: how an unlimited vehicle brakes.
constexpr double unlimited_braking = 1.0;

bool flies_by_autopilot(const ControlFrame& control) {
    return control.has(ControlFrame::autopilot) && !control.has(ControlFrame::brake);
}

/// Motion in the frame that the pilot means: the world's, or the target's.
BoostAndRotation motion_meant(const VehicleState& before, const ControlFrame& control) {
    const bool about_target = control.has(ControlFrame::about_target) && before.guidance.has_target != 0;
    const InertialObject at_rest;
    const Lorentz<Goal, World> frame = goal_from_world(about_target ? before.guidance.target : at_rest);
    return split({(frame * before.world_from_vehicle).spin});
}

glm::dvec3 ahead(const BoostAndRotation& motion) {
    return glm::transpose(motion.boosted_from_head) * motion.along;
}

glm::dvec3 braking_thrust(const BoostAndRotation& motion, const glm::dvec3& reach, double tick) {
    if (motion.xi < rapidity_at_rest) {
        return glm::dvec3(0.0);
    }
    const glm::dvec3 along = ahead(motion);
    return -std::min(largest_thrust(along, reach, unlimited_braking), motion.xi.value / tick) * along;
}

glm::dvec3 cruising_thrust(const BoostAndRotation& motion, Rapidity cruise, const glm::dvec3& demanded,
                           const glm::dvec3& reach, double tick) {
    const bool moving = !(motion.xi < rapidity_at_rest);
    const glm::dvec3 along = moving ? ahead(motion) : glm::dvec3(0.0, 0.0, -1.0);
    const double missing = (cruise.value - motion.xi.value) / tick;
    const double most = largest_thrust(along, reach);
    const glm::dvec3 across = moving ? demanded - along * glm::dot(demanded, along) : glm::dvec3(0.0);
    return glm::clamp(across, -reach, reach) + std::clamp(missing, -most, most) * along;
}

glm::dvec3 hands_turn(const VehicleState& before, const ControlFrame& control) {
    glm::dvec3 turn = control.angular_velocity;
    for (int i = 0; i < 3 && control.has(ControlFrame::undamped); ++i) {
        turn[i] = turn[i] == 0.0 ? before.angular_velocity[i] : turn[i];
    }
    return turn;
}

/// Where the nose is wanted, vehicle axes; zero when nowhere.
glm::dvec3 wanted_nose(const VehicleState& before, const ControlFrame& control) {
    const Pointing pointing = control.pointing();
    if (pointing == Pointing::prograde || pointing == Pointing::retrograde) {
        const BoostAndRotation motion = motion_meant(before, control);
        const glm::dvec3 along = motion.xi < rapidity_at_rest ? glm::dvec3(0.0) : ahead(motion);
        return pointing == Pointing::prograde ? along : -along;
    }
    if ((pointing == Pointing::target_seen || pointing == Pointing::target_now) && before.guidance.has_target != 0) {
        const Lorentz<World, Head> facing_ahead{before.world_from_vehicle.spin};
        const Sighting target = sighting(far_event(before), facing_ahead, before.guidance.target);
        return target.distance == 0.0 ? glm::dvec3(0.0)
                                      : (pointing == Pointing::target_seen ? target.seen : target.now);
    }
    return glm::dvec3(0.0);
}

glm::dvec3 demanded_turn(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control) {
    if (control.pointing() == Pointing::hold_heading) {
        return glm::dvec3(0.0);
    }
    if (control.angular_velocity == glm::dvec3(0.0)) {
        const glm::dvec3 nose = wanted_nose(before, control);
        if (nose != glm::dvec3(0.0)) {
            return turn_towards(settings, nose);
        }
    }
    return hands_turn(before, control);
}

/// The thrust that the propellant still gives for a tick, and what is spent after it.
void burn_propellant(AssistedDrive& assisted, const VehicleState& before, const VehicleSettings& settings) {
    const glm::dvec3& a = assisted.drive.proper_acceleration;
    const double tick = 1.0 / settings.tick_rate;
    const double wanted = std::hypot(a.x, a.y, a.z) * tick;
    const double left = rapidity_left(settings, before).value;
    if (wanted > left) {
        assisted.drive.proper_acceleration *= left / wanted;
        assisted.rapidity_spent = rapidity_budget(settings);
        if (is_flying(assisted.guidance.phase)) {
            assisted.guidance.phase = AutopilotPhase::no_propellant;
        }
    } else {
        assisted.rapidity_spent = before.rapidity_spent + Rapidity(wanted);
    }
}

} // namespace

AssistedDrive assisted_drive(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control) {
    const glm::dvec3 reach = thrust_reach(settings, control);
    const double tick = 1.0 / settings.tick_rate;
    AssistedDrive result;
    result.guidance = before.guidance;
    bool hands_fly = true;
    if (flies_by_autopilot(control)) {
        if (before.guidance.phase == AutopilotPhase::off || is_flying(before.guidance.phase)) {
            hands_fly = false;
            const AutopilotTick flown = fly_autopilot(before, settings, control);
            result.guidance = flown.guidance;
            result.drive = {flown.proper_acceleration, flown.angular_velocity};
        }
    } else {
        result.guidance.phase = AutopilotPhase::off;
        result.guidance.peak = glm::dvec3(0.0);
        result.guidance.schedule = {};
    }
    if (hands_fly) {
        glm::dvec3& thrust = result.drive.proper_acceleration;
        thrust = control.proper_acceleration;
        if (control.has(ControlFrame::brake)) {
            thrust = braking_thrust(motion_meant(before, control), reach, tick);
        } else if (control.has(ControlFrame::cruise)) {
            thrust = cruising_thrust(motion_meant(before, control), before.guidance.cruise, thrust, reach, tick);
        }
        result.drive.angular_velocity = demanded_turn(before, settings, control);
    }
    result.drive.proper_acceleration = glm::clamp(result.drive.proper_acceleration, -reach, reach);
    result.drive.angular_velocity = limited_turn(before, settings, result.drive.angular_velocity);
    burn_propellant(result, before, settings);
    return result;
}

} // namespace sim
