#include "engine/fly/window_flight.h"
#include "sim/autopilot.h"

#include <fmt/core.h>

/// The window's part of flying somewhere on purpose: targets, the autopilot's word, the panel beside the settings.
namespace engine {

/// An autopilot that is done, or gives up, is switched off, and says why.
void WindowFlight::hear_autopilot() {
    const sim::AutopilotPhase phase = recorded_->flight().state().guidance.phase;
    const bool on = (hands_.switches() & sim::ControlFrame::autopilot) != 0;
    if (on && !script_ && !is_replay() && phase != sim::AutopilotPhase::off && !sim::is_flying(phase)) {
        hands_.switch_off(sim::ControlFrame::autopilot);
        notices_.show(fmt::format("the autopilot hands back: {}", sim::phase_name(phase)), 8.0);
    }
}

void WindowFlight::handle_voyage(input::Action action) {
    using sim::ControlFrame;
    Flight& flight = recorded_->flight();
    const bool chooses = action == input::Action::target_next || action == input::Action::target_in_view ||
                         action == input::Action::cruise;
    if (chooses && is_replay()) {
        notices_.show("a replay flies as it was recorded");
        return;
    }
    const bool targets = !navigation_.destinations().empty();
    switch (action) {
    case input::Action::target_next:
        navigation_.choose_next(flight);
        break;
    case input::Action::target_in_view:
        navigation_.choose_in_view(flight, flight.state(), hands_.vehicle_from_head(), {0.0, 0.0, -1.0});
        break;
    case input::Action::autopilot: // the hands turn that switch themselves; one of the two flies
        hands_.switch_off(ControlFrame::brake);
        break;
    case input::Action::brake_switch:
        hands_.switch_off(ControlFrame::autopilot);
        break;
    case input::Action::cruise:
        flight.set_cruise(sim::rapidity(flight.state().world_from_vehicle));
        break;
    default:
        return;
    }
    if (!targets && (chooses || action == input::Action::autopilot) && action != input::Action::cruise) {
        notices_.show("nowhere to go: this scenario has neither beacons nor stars");
    }
}

void WindowFlight::draw_voyage_panel() {
    Flight& flight = recorded_->flight();
    std::vector<std::string> names;
    for (const content::Destination& destination : navigation_.destinations()) {
        names.push_back(destination.name);
    }
    const VoyagePanel::Changes changes =
        voyage_panel_.draw(imgui_, {names, navigation_.target(flight), flight.state().guidance.cruise.value,
                                    scenario_.clock_unit_name, flight.vehicle(), flight.events()});
    if (is_replay()) {
        if (changes.target || changes.cruise || changes.vehicle) {
            notices_.show("a replay flies as it was recorded");
        }
        return;
    }
    if (changes.target) {
        navigation_.choose(flight, *changes.target);
    }
    if (changes.cruise) {
        flight.set_cruise(sim::Rapidity(*changes.cruise));
    }
    if (changes.vehicle) {
        flight.set_vehicle(*changes.vehicle, changes.what);
        hands_.set_vehicle(*changes.vehicle);
    }
}

} // namespace engine
