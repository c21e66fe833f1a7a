#include "engine/hud/voyage_panel.h"

#include "engine/hud/imgui_layer.h"
#include "engine/hud/panel_window.h"
#include "engine/hud/readouts.h"
#include "engine/hud/released_slider.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace engine {
namespace {

std::optional<std::size_t> choose_target(const VoyagePanel::Present& present) {
    std::optional<std::size_t> chosen;
    if (ImGui::BeginCombo("target", present.target ? present.destinations[*present.target].c_str() : "none")) {
        for (std::size_t i = 0; i < present.destinations.size(); ++i) {
            if (ImGui::Selectable(present.destinations[i].c_str(), present.target == i)) {
                chosen = i;
            }
        }
        ImGui::EndCombo();
    }
    return chosen;
}

void draw_log(const VoyagePanel::Present& present) {
    ImGui::TextDisabled("log: ship's clock, world's clock");
    constexpr std::size_t most_lines = 8;
    const std::size_t from = present.events.size() - std::min(present.events.size(), most_lines);
    for (std::size_t i = from; i < present.events.size(); ++i) {
        const sim::FlightEvent& event = present.events[i];
        const std::string text = fmt::format("{}: {}, {}", sim::event_name(event.kind),
                                             clock_text(event.ship_clock.value, present.clock_unit),
                                             clock_text(event.world_clock.value, present.clock_unit));
        ImGui::TextUnformatted(text.c_str());
    }
}

} // namespace

VoyagePanel::Changes VoyagePanel::draw(const ImguiLayer& layer, const Present& present) {
    Changes changes;
    const float scale = layer.scale();
    ImGui::SetNextWindowPos({440.0F * scale, 60.0F * scale}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({390.0F * scale, 0.0F}, ImGuiCond_FirstUseEver);
    ImGui::Begin("voyage", nullptr, panel_window_flags);
    ImGui::PushItemWidth(200.0F * scale);
    changes.target = choose_target(present);
    if (const auto cruise = released_slider("rapidity to hold", held_cruise_, static_cast<float>(present.cruise), 0.0F,
                                            10.0F, "%.3f", ImGuiSliderFlags_None)) {
        changes.cruise = static_cast<double>(*cruise);
    }
    const double turn = present.vehicle.maximum_turn_acceleration.y;
    constexpr double most = 1000.0; // per clock unit squared; the slider's end stands for a ship without a limit
    const std::string unit = fmt::format("%.3g rad/{}^2", present.clock_unit);
    if (const auto value = released_slider("turn acceleration", held_turn_, static_cast<float>(std::min(turn, most)),
                                           0.01F, static_cast<float>(most), unit.c_str())) {
        changes.vehicle = present.vehicle;
        changes.vehicle->maximum_turn_acceleration = glm::dvec3(static_cast<double>(*value));
        changes.what = fmt::format("turn acceleration at most {:g} rad/{}^2", *value, present.clock_unit);
    }
    draw_log(present);
    ImGui::PopItemWidth();
    ImGui::End();
    return changes;
}

} // namespace engine
