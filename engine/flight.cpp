#include "engine/flight.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <fmt/core.h>
#include <utility>

namespace engine {
namespace {

/// Turns a camera's axes (-z ahead, y up) so that it looks along a unit vector with world up as near up as can be.
glm::dquat orientation_along(const glm::dvec3& look) {
    const bool vertical = std::abs(look.y) > 1.0 - 1e-12;
    const glm::dvec3 up = vertical ? glm::dvec3(0.0, 0.0, look.y > 0.0 ? 1.0 : -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::quatLookAtRH(look, up);
}

} // namespace

sim::VehicleState starting_state(const content::Scenario& scenario) {
    const auto motion = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(scenario.start_beta)),
                                                             glm::normalize(scenario.start_heading));
    sim::VehicleState state;
    state.event.space = scenario.start_position / scenario.metres_per_light_unit();
    // The nose turns in the boosted frame as a head turns in the vehicle: the same product.
    state.world_from_vehicle = {
        sim::world_from_head(motion, orientation_along(glm::normalize(scenario.start_look))).spin};
    return state;
}

FlightChange starting_change(const content::Scenario& scenario) {
    return {"start", starting_state(scenario), scenario.vehicle, scenario.metres_per_light_unit()};
}

Flight::Flight(const content::Scenario& scenario, std::unique_ptr<TickSink> sink)
    : vehicle_(scenario.vehicle), metres_per_light_unit_(scenario.metres_per_light_unit()),
      clock_unit_seconds_(scenario.clock_unit_seconds), before_(starting_state(scenario)), after_(before_),
      sink_(std::move(sink)) {}

void Flight::keep_world_line() {
    world_line_ = std::make_shared<sim::ShipWorldLine>(after_);
}

void Flight::keep_world_line(sim::ShipWorldLine flown) {
    world_line_ = std::make_shared<sim::ShipWorldLine>(std::move(flown));
}

void Flight::begin_at(const FlightChange& start) {
    before_ = after_ = start.state;
    vehicle_ = start.vehicle;
    metres_per_light_unit_ = start.metres_per_light_unit;
}

void Flight::show(const FlightMoment& moment) {
    before_ = moment.before;
    after_ = moment.after;
    control_before_ = moment.control_before;
    control_ = moment.control;
    vehicle_ = moment.vehicle;
    metres_per_light_unit_ = moment.metres_per_light_unit;
}

bool Flight::tick(input::Pilot& pilot) {
    if (!stop_.empty()) {
        return false;
    }
    const std::optional<sim::ControlFrame> demand = pilot.control(after_.tick);
    if (!demand) {
        return false;
    }
    const sim::VehicleState next = sim::advance(after_, vehicle_, *demand);
    if (!sim::is_in_range(next)) {
        stop_for_good();
        return false;
    }
    before_ = std::exchange(after_, next);
    control_before_ = std::exchange(control_, *demand);
    if (world_line_) {
        world_line_->extend(after_);
    }
    if (sink_) {
        sink_->on_tick(control_, after_);
    }
    if (const std::optional<sim::FlightEvent> event = log_.watch(before_, after_, vehicle_)) {
        events_.push_back(*event);
        if (sink_) {
            sink_->on_event(*event);
        }
    }
    return true;
}

void Flight::stop_for_good() {
    stop_ = fmt::format("stopped at tick {}: the next takes the ship beyond rapidity {:g}, the end of what is computed",
                        after_.tick, sim::largest_rapidity.value);
    before_ = after_; // pictures between the ticks stand still, too
    tell_change(stop_);
}

sim::VehicleState FlightMoment::between() const {
    if (after.tick == before.tick || fraction <= 0.0) {
        return before;
    }
    if (fraction >= 1.0) {
        return after;
    }
    return sim::step(sim::snap_turned(before, vehicle, control), sim::ProperTime(fraction / vehicle.tick_rate),
                     {after.felt_acceleration, after.angular_velocity});
}

glm::dquat FlightMoment::head() const {
    return glm::slerp(control_before.vehicle_from_head, control.vehicle_from_head, fraction);
}

FlightMoment Flight::moment(double fraction) const {
    return {before_, after_, control_before_, control_, vehicle_, metres_per_light_unit_, fraction};
}

sim::VehicleState Flight::between(double fraction) const {
    return moment(fraction).between();
}

glm::dquat Flight::head_between(double fraction) const {
    return moment(fraction).head();
}

void Flight::set_speed_of_light(double metres_per_second) {
    const double factor = speed_of_light() / metres_per_second;
    const sim::Event last_step = sim::displacement(sim::far_event(after_), sim::far_event(before_));
    // Places are in light clock units, which change; the world's clock goes on.
    sim::FarEvent here = sim::scaled(sim::far_event(after_), factor);
    here.origin.t = after_.event.t;
    here.offset.t = after_.event_offset.t;
    sim::move_to(after_, here);
    sim::move_to(before_, sim::displaced(here, last_step));
    after_.guidance.target.position_at_zero *= factor;
    before_.guidance.target.position_at_zero *= factor;
    metres_per_light_unit_ = metres_per_second * clock_unit_seconds_;
    if (world_line_) {
        keep_world_line();
    }
    tell_change(fmt::format("speed of light = {:g} m/s", metres_per_second));
}

void Flight::set_vehicle(const sim::VehicleSettings& vehicle, const std::string& what) {
    vehicle_ = vehicle;
    tell_change(what);
}

void Flight::set_target(const sim::InertialObject& target, const std::string& name) {
    sim::Guidance& guidance = after_.guidance;
    guidance.target = target;
    guidance.has_target = 1;
    guidance.phase = sim::AutopilotPhase::off;
    tell_change("target = " + name);
}

void Flight::set_cruise(sim::Rapidity cruise) {
    after_.guidance.cruise = cruise;
    tell_change(fmt::format("cruise rapidity = {:g}", cruise.value));
}

void Flight::tell_change(const std::string& what) {
    if (sink_) {
        sink_->on_change({what, after_, vehicle_, metres_per_light_unit_});
    }
}

} // namespace engine
