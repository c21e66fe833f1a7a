#pragma once

#include <imgui.h>

#include <optional>

namespace engine {

/// A slider whose value counts when the hand lets go; shows `present` otherwise.
inline std::optional<float> released_slider(const char* label, std::optional<float>& held, float present, float least,
                                            float most, const char* format,
                                            ImGuiSliderFlags scale = ImGuiSliderFlags_Logarithmic) {
    float value = held.value_or(present);
    ImGui::SliderFloat(label, &value, least, most, format,
                       scale | ImGuiSliderFlags_NoRoundToFormat | ImGuiSliderFlags_AlwaysClamp);
    const bool released = ImGui::IsItemDeactivatedAfterEdit();
    held = ImGui::IsItemActive() ? std::optional(value) : std::nullopt;
    return released ? std::optional(value) : std::nullopt;
}

} // namespace engine
