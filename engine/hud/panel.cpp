#include "engine/hud/panel.h"

#include "engine/hud/display_panel.h"
#include "engine/hud/hud_model.h"
#include "engine/hud/imgui_layer.h"
#include "engine/hud/panel_window.h"
#include "engine/hud/readouts.h"
#include "engine/hud/released_slider.h"

#include <glm/common.hpp>

#include <array>
#include <cmath>
#include <fmt/core.h>
#include <numbers>

namespace engine {
namespace {

constexpr std::array modes{render::Mode::geometry, render::Mode::doppler, render::Mode::searchlight,
                           render::Mode::full};

double finite_or_one(double limit) {
    return std::isfinite(limit) ? limit : 1.0;
}

/// All three limits scaled so that `reference` becomes `value`; a vehicle without limits gets `value` on every axis.
glm::dvec3 scaled_limits(const glm::dvec3& limits, double reference, double value) {
    return std::isfinite(reference) ? limits * (value / reference) : glm::dvec3(value);
}

void draw_picture(PictureSettings& picture) {
    ImGui::TextDisabled("picture");
    if (ImGui::BeginCombo("mode", mode_name(picture.mode).c_str())) {
        for (const render::Mode mode : modes) {
            if (ImGui::Selectable(mode_name(mode).c_str(), mode == picture.mode)) {
                picture.mode = mode;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::Checkbox("automatic exposure", &picture.exposure.automatic);
    ImGui::SliderFloat(picture.exposure.automatic ? "compensation" : "exposure", &picture.exposure.stops, -12.0F, 12.0F,
                       "%+.1f stops");
    bool filmic = !picture.exposure.linear_curve;
    if (ImGui::Checkbox("filmic curve", &filmic)) {
        picture.exposure.linear_curve = !filmic;
    }
    constexpr double degrees = 180.0 / std::numbers::pi;
    auto field = static_cast<float>(picture.horizontal_field_of_view * degrees);
    if (ImGui::SliderFloat("field of view", &field, 10.0F, 150.0F, "%.0f degrees", ImGuiSliderFlags_AlwaysClamp)) {
        picture.horizontal_field_of_view = static_cast<double>(field) / degrees;
    }
    draw_display_settings(picture);
}

/// The model chosen for RGB reflectances, once when it changes.
std::optional<content::ReflectanceModel> draw_reflectance(content::ReflectanceModel present) {
    std::optional<content::ReflectanceModel> chosen;
    const auto& names = content::reflectance_model_names;
    const auto index = static_cast<std::size_t>(present);
    if (ImGui::BeginCombo("reflectances", names.at(index))) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(names.at(i), i == index) && i != index) {
                chosen = static_cast<content::ReflectanceModel>(i);
            }
        }
        ImGui::EndCombo();
    }
    return chosen;
}

} // namespace

Panel::Changes Panel::draw(const ImguiLayer& layer, PictureSettings& picture, ComfortSettings& comfort,
                           const Present& present) {
    Changes changes;
    const float scale = layer.scale();
    ImGui::SetNextWindowPos({24.0F * scale, 60.0F * scale}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({390.0F * scale, 0.0F}, ImGuiCond_FirstUseEver);
    ImGui::Begin("settings", nullptr, panel_window_flags);
    ImGui::PushItemWidth(200.0F * scale);
    draw_picture(picture);
    changes.reflectance_model = draw_reflectance(present.reflectance_model);
    bool microwaves = present.microwave_background;
    if (ImGui::Checkbox("microwave background", &microwaves)) {
        changes.microwave_background = microwaves;
    }
    ImGui::Spacing();
    ImGui::TextDisabled("comfort");
    draw_comfort_settings(comfort);
    ImGui::Spacing();
    ImGui::TextDisabled("world");
    changes.speed_of_light = draw_speed_of_light(present.speed_of_light);
    ImGui::Spacing();
    ImGui::TextDisabled("vehicle");
    draw_vehicle(present, changes);
    ImGui::PopItemWidth();
    ImGui::End();
    return changes;
}

std::optional<double> Panel::draw_speed_of_light(double present) {
    const std::optional<float> value =
        released_slider("speed of light", held_speed_, static_cast<float>(present), 1.0F, 299792458.0F, "%.4g m/s");
    ImGui::TextDisabled("1 m/s to 299,792,458; keeps the rapidity: the picture stays");
    return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
}

void Panel::draw_vehicle(const Present& present, Changes& changes) {
    const sim::VehicleSettings& vehicle = present.vehicle;
    const double thrust = vehicle.maximum_acceleration.z;
    const double g = g_from_acceleration(1.0, present.speed_of_light, present.clock_unit_seconds);
    const std::string unit = fmt::format("%.3g c/{} ({})", present.clock_unit, g_text(finite_or_one(thrust) * g));
    const auto shown = [](double limit) { return static_cast<float>(finite_or_one(limit)); };
    if (const auto value = released_slider("thrust ahead", held_thrust_, shown(thrust), 0.01F, 100.0F, unit.c_str())) {
        changes.vehicle = vehicle;
        changes.vehicle->maximum_acceleration =
            scaled_limits(vehicle.maximum_acceleration, thrust, static_cast<double>(*value));
        changes.what = fmt::format("thrust ahead at most {:g} c/{}", *value, present.clock_unit);
    }
    const double turn = vehicle.maximum_turn_rate.y;
    const std::string turn_unit = fmt::format("%.3g rad/{}", present.clock_unit);
    if (const auto value = released_slider("turn", held_turn_, shown(turn), 0.01F, 100.0F, turn_unit.c_str())) {
        changes.vehicle = vehicle;
        changes.vehicle->maximum_turn_rate =
            scaled_limits(vehicle.maximum_turn_rate, turn, static_cast<double>(*value));
        changes.what = fmt::format("turn rate at most {:g} rad/{}", *value, present.clock_unit);
    }
    if (const auto value =
            released_slider("boost", held_boost_, static_cast<float>(vehicle.boost_factor), 1.0F, 100.0F, "x %.3g")) {
        changes.vehicle = vehicle;
        changes.vehicle->boost_factor = static_cast<double>(*value);
        changes.what = fmt::format("boost factor {:g}", *value);
    }
}

} // namespace engine
