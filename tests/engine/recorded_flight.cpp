#include "recorded_flight.h"

namespace recorded_flight {

content::Scenario scenario() {
    content::Scenario scenario;
    scenario.name = "nowhere";
    scenario.title = "An empty place";
    scenario.vehicle.maximum_acceleration = {0.5, 0.5, 2.0};
    scenario.vehicle.maximum_turn_rate = glm::dvec3(3.0);
    return scenario;
}

engine::FlightChange start(const content::Scenario& scenario) {
    engine::FlightChange start{"start", {}, scenario.vehicle, scenario.metres_per_light_unit()};
    start.state.event.space = {0.1, -0.2, 0.3};
    start.state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(0.7), {0.6, 0.0, -0.8});
    return start;
}

sim::ControlFrame RestlessHand::next() {
    std::uniform_real_distribution<double> demand(-2.5, 2.5);
    std::uniform_int_distribution<int> dice(0, 99);
    if (dice(random_) < 60) {
        held_.angular_velocity = {demand(random_), demand(random_), -0.0};
    }
    if (dice(random_) < 5) {
        held_.proper_acceleration = {demand(random_), 0.0, demand(random_)};
    }
    if (dice(random_) < 2) {
        held_.head_position.y = 1e-9 * demand(random_);
        held_.head_velocity.x = 0.1 * demand(random_);
        held_.buttons = static_cast<std::uint32_t>(dice(random_) % 16);
    }
    return held_;
}

void Flight::fly(sim::Tick ticks) {
    for (sim::Tick i = 0; i < ticks; ++i) {
        const sim::ControlFrame control = hand_.next();
        state_ = sim::advance(state_, settings_, control);
        sink_.on_tick(control, state_);
    }
}

void Flight::change() {
    settings_.maximum_acceleration *= 0.5;
    state_.event.space *= 3.0;
    metres_per_light_unit_ /= 3.0;
    sink_.on_change({"speed of light = 1e8 m/s", state_, settings_, metres_per_light_unit_});
}

sim::VehicleState record(const std::filesystem::path& file, sim::Tick ticks) {
    const content::Scenario place = scenario();
    engine::Recorder recorder(file, engine::describe_flight(place), start(place));
    Flight flight(recorder, start(place));
    flight.fly(ticks / 2);
    flight.change();
    flight.fly(ticks - ticks / 2);
    recorder.close();
    if (!recorder.trouble().empty()) {
        throw std::runtime_error(recorder.trouble());
    }
    return flight.state();
}

} // namespace recorded_flight
