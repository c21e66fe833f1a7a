#pragma once

#include <imgui.h>

/// The colours of the instruments.
namespace engine::palette {

constexpr ImU32 value = IM_COL32(236, 244, 247, 255);
constexpr ImU32 label = IM_COL32(150, 172, 182, 255);
constexpr ImU32 line = IM_COL32(190, 215, 224, 150);
constexpr ImU32 accent = IM_COL32(122, 212, 230, 255);
constexpr ImU32 warning = IM_COL32(255, 190, 92, 255);
constexpr ImU32 shadow = IM_COL32(0, 0, 0, 150);
constexpr ImU32 recording = IM_COL32(240, 82, 72, 255);

} // namespace engine::palette
