#pragma once

#include <imgui.h>

namespace engine {

/// How the pilot's panels behave. Without NoNavInputs the Tab that opens a panel would also begin to type into its
/// first field, and no key would fly the ship, close the panel or quit from then on.
inline constexpr ImGuiWindowFlags panel_window_flags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNavInputs;

} // namespace engine
