#pragma once

#include <imgui.h>

/// The colours of the instruments.
namespace engine::palette {

constexpr ImU32 value = IM_COL32(236, 244, 247, 255);
constexpr ImU32 label = IM_COL32(178, 197, 206, 255);
constexpr ImU32 line = IM_COL32(205, 226, 234, 190);
constexpr ImU32 accent = IM_COL32(122, 212, 230, 255);
constexpr ImU32 warning = IM_COL32(255, 190, 92, 255);
constexpr ImU32 shadow = IM_COL32(0, 0, 0, 175);
constexpr ImU32 recording = IM_COL32(240, 82, 72, 255);

} // namespace engine::palette
