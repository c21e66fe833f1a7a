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

/// At full spacing.
float height_of(const std::vector<input::Binding>& group) {
    return gap + heading + row * static_cast<float>(group.size());
}

/// `fit`: factor on the spacing of lines.
void draw_group(Canvas& canvas, ImVec2 at, float fit, const std::vector<input::Binding>& group) {
    float y = at.y + fit * gap;
    canvas.text({at.x, y}, std::string(group.front().group), canvas.fonts().text, palette::accent);
    y += fit * heading;
    for (const input::Binding& binding : group) {
        canvas.text({at.x, y}, std::string(binding.what), canvas.fonts().small, palette::label);
        canvas.text({at.x + what_width, y}, input::desk_controls(binding), canvas.fonts().small, palette::value);
        canvas.text({at.x + what_width + desk_width, y}, std::string(input::control_name(binding.gamepad)),
                    canvas.fonts().small, palette::value);
        y += fit * row;
    }
}

} // namespace

void draw_help(const ImguiLayer& layer) {
    Canvas canvas(*ImGui::GetForegroundDrawList(), layer);
    const std::vector<std::vector<input::Binding>> all = groups();

    // Two columns as even as whole groups make them, and lines closer together where the window is low.
    float total = 0.0F;
    for (const auto& group : all) {
        total += height_of(group);
    }
    std::size_t split = 0;
    float first = 0.0F;
    float longer = total;
    float sum = 0.0F;
    for (std::size_t i = 0; i < all.size(); ++i) {
        sum += height_of(all[i]);
        if (std::max(sum, total - sum) < longer) {
            longer = std::max(sum, total - sum);
            first = sum;
            split = i + 1;
        }
    }
    const float fit = std::min(1.0F, (canvas.height() - 2.0F * padding - 8.0F) / longer);
    const float height = fit * std::max(first, total - first) + 2.0F * padding;
    const float width = 2.0F * column_width + 3.0F * padding;
    const ImVec2 corner{0.5F * (canvas.width() - width), 0.5F * (canvas.height() - height)};
    canvas.plate(corner, {corner.x + width, corner.y + height}, IM_COL32(6, 11, 15, 235));

    float y = corner.y + padding;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool second = i >= split;
        y = i == split ? corner.y + padding : y;
        draw_group(canvas, {corner.x + padding + (second ? column_width + padding : 0.0F), y}, fit, all[i]);
        y += fit * height_of(all[i]);
    }
}

} // namespace engine
