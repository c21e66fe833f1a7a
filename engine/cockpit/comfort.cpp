#include "engine/cockpit/comfort.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace engine {

float TurnVignette::advance(double turn_rate, float strength, double elapsed_seconds) {
    const double wanted = std::min(std::abs(turn_rate) / full_rate, 1.0);
    const double constant = wanted > share_ ? closing_seconds : opening_seconds;
    share_ += (1.0 - std::exp(-elapsed_seconds / constant)) * (wanted - share_);
    if (wanted == 0.0 && share_ < 1e-3) {
        share_ = 0.0; // open: the picture is untouched again
    }
    return strength * static_cast<float>(share_);
}

void draw_comfort_settings(ComfortSettings& comfort) {
    ImGui::SliderFloat("narrow in turns", &comfort.vignette, 0.0F, 1.0F, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    ImGui::SliderFloat("brightest", &comfort.brightest, ComfortSettings::darkest_limit, 1.0F, "%.2f of the display",
                       ImGuiSliderFlags_AlwaysClamp);
    ImGui::Checkbox("turn by steps", &comfort.snap_turn);
    ImGui::SliderFloat("step", &comfort.snap_degrees, ComfortSettings::smallest_snap, ComfortSettings::largest_snap,
                       "%.0f degrees", ImGuiSliderFlags_AlwaysClamp);
    ImGui::Checkbox("steady horizon", &comfort.steady_horizon);
}

} // namespace engine
