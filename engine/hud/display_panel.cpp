#include "engine/hud/display_panel.h"

#include "engine/hud/hud_model.h"
#include "engine/panes.h"

#include <array>
#include <fmt/core.h>
#include <imgui.h>

namespace engine {
namespace {

constexpr std::array modes{render::Mode::geometry, render::Mode::doppler, render::Mode::searchlight,
                           render::Mode::full};

struct NamedView {
    render::View view;
    const char* name;
};
constexpr std::array views{NamedView{render::View::natural, "light"}, NamedView{render::View::doppler, "D"},
                           NamedView{render::View::rings, "D in rings"},
                           NamedView{render::View::luminance, "luminance"}};

void choose_view(const char* label, render::View& chosen) {
    if (ImGui::BeginCombo(label, views.at(static_cast<std::size_t>(chosen)).name)) {
        for (const NamedView& view : views) {
            if (ImGui::Selectable(view.name, view.view == chosen)) {
                chosen = view.view;
            }
        }
        ImGui::EndCombo();
    }
}

void choose_mode(const char* label, render::Mode& chosen) {
    if (ImGui::BeginCombo(label, mode_name(chosen).c_str())) {
        for (const render::Mode mode : modes) {
            if (ImGui::Selectable(mode_name(mode).c_str(), mode == chosen)) {
                chosen = mode;
            }
        }
        ImGui::EndCombo();
    }
}

} // namespace

void draw_display_settings(PictureSettings& picture) {
    choose_view("shown", picture.display.view);
    ImGui::Checkbox("lines of equal value", &picture.display.iso_lines);
    ImGui::SliderFloat("glare", &picture.display.bloom, 0.0F, 0.5F, "%.2f of the light", ImGuiSliderFlags_AlwaysClamp);
    auto panes = static_cast<int>(picture.other_panes.size()) + 1;
    if (ImGui::SliderInt("panes", &panes, 1, static_cast<int>(most_panes), "%d", ImGuiSliderFlags_AlwaysClamp)) {
        picture.other_panes.resize(static_cast<std::size_t>(panes) - 1, Pane{picture.mode, render::View::natural});
    }
    for (std::size_t i = 0; i < picture.other_panes.size(); ++i) {
        Pane& pane = picture.other_panes[i];
        choose_mode(fmt::format("pane {}", i + 2).c_str(), pane.mode);
        choose_view(fmt::format("shown in {}", i + 2).c_str(), pane.view);
    }
}

} // namespace engine
