#include "engine/fly/loaded_scene.h"
#include "engine/fly/window_flight.h"
#include "sim/bad_input.h"

namespace engine {

void WindowFlight::draw_panel() {
    Flight& flight = recorded_->flight();
    const Panel::Changes changes =
        panel_.draw(imgui_, picture_, cockpit_.comfort(),
                    {flight.speed_of_light(), scenario_.clock_unit_seconds, scenario_.clock_unit_name, flight.vehicle(),
                     scenario_.reflectance_model, scenario_.microwave_background});
    if (changes.reflectance_model || changes.microwave_background) {
        scenario_.reflectance_model = changes.reflectance_model.value_or(scenario_.reflectance_model);
        scenario_.microwave_background = changes.microwave_background.value_or(scenario_.microwave_background);
        if (probe_) {
            probe_.emplace(scenario_);
        }
        renderer_ = render::Renderer(loaded_scene(scenario_), {options_.method}); // a second's pause
    }
    if (is_replay()) {
        if (changes.speed_of_light || changes.vehicle) {
            notices_.show("a replay flies as it was recorded");
        }
        return;
    }
    if (changes.speed_of_light) {
        flight.set_speed_of_light(*changes.speed_of_light);
        navigation_.rescale(flight);
        hands_.set_metres_per_light_unit(flight.metres_per_light_unit());
    }
    if (changes.vehicle) {
        flight.set_vehicle(*changes.vehicle, changes.what);
        hands_.set_vehicle(*changes.vehicle);
    }
}

void WindowFlight::switch_probe() {
    if (probe_) {
        probe_.reset();
        return;
    }
    try {
        probe_.emplace(scenario_);
        show_instruments_ = true;
        notices_.show("point at what you want to know the spectrum of");
    } catch (const sim::BadInput& error) {
        notices_.show(error.what(), 8.0);
    }
}

} // namespace engine
