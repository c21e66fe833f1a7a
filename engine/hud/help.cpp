#include "engine/hud/canvas.h"
#include "engine/hud/instruments.h"
#include "engine/hud/palette.h"
#include "input/bindings.h"

#include <algorithm>
#include <string>
#include <vector>

namespace engine {
namespace {

// Points.
constexpr float row = 19.0F;
constexpr float heading = 25.0F;
constexpr float gap = 10.0F; ///< above a heading
constexpr float padding = 22.0F;
constexpr float what_width = 180.0F;
constexpr float desk_width = 130.0F;
constexpr float gamepad_width = 115.0F;
constexpr float column_width = what_width + desk_width + gamepad_width;

/// The table by its groups, each a heading with its lines.
std::vector<std::vector<input::Binding>> groups() {
    std::vector<std::vector<input::Binding>> all;
    for (const input::Binding& binding : input::bindings()) {
        if (all.empty() || all.back().front().group != binding.group) {
            all.emplace_back();
        }
        all.back().push_back(binding);
    }
    return all;
}

float height_of(const std::vector<input::Binding>& group) {
    return gap + heading + row * static_cast<float>(group.size());
}

void draw_group(Canvas& canvas, ImVec2 at, const std::vector<input::Binding>& group) {
    float y = at.y + gap;
    canvas.text({at.x, y}, std::string(group.front().group), canvas.fonts().text, palette::accent);
    y += heading;
    for (const input::Binding& binding : group) {
        canvas.text({at.x, y}, std::string(binding.what), canvas.fonts().small, palette::label);
        canvas.text({at.x + what_width, y}, input::desk_controls(binding), canvas.fonts().small, palette::value);
        canvas.text({at.x + what_width + desk_width, y}, std::string(input::control_name(binding.gamepad)),
                    canvas.fonts().small, palette::value);
        y += row;
    }
}

} // namespace

void draw_help(const ImguiLayer& layer) {
    Canvas canvas(*ImGui::GetForegroundDrawList(), layer);
    const std::vector<std::vector<input::Binding>> all = groups();

    // Two columns: groups go to the first until it holds half of the lines.
    float total = 0.0F;
    for (const auto& group : all) {
        total += height_of(group);
    }
    std::size_t split = 0;
    float first = 0.0F;
    while (split < all.size() && first + 0.5F * height_of(all[split]) < 0.5F * total) {
        first += height_of(all[split++]);
    }
    const float height = std::max(first, total - first) + 2.0F * padding;
    const float width = 2.0F * column_width + 3.0F * padding;
    const ImVec2 corner{0.5F * (canvas.width() - width), 0.5F * (canvas.height() - height)};
    canvas.plate(corner, {corner.x + width, corner.y + height}, IM_COL32(6, 11, 15, 235));

    float y = corner.y + padding;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool second = i >= split;
        y = i == split ? corner.y + padding : y;
        draw_group(canvas, {corner.x + padding + (second ? column_width + padding : 0.0F), y}, all[i]);
        y += height_of(all[i]);
    }
}

} // namespace engine
