#include "engine/hud/canvas.h"
#include "engine/hud/instruments.h"
#include "engine/hud/palette.h"
#include "input/bindings.h"

#include <algorithm>
#include <array>

namespace engine {

void draw_help(const ImguiLayer& layer) {
    Canvas canvas(*ImGui::GetForegroundDrawList(), layer);
    constexpr float row = 19.0F;
    constexpr float heading = 27.0F;
    constexpr std::array<float, 3> columns{0.0F, 105.0F, 210.0F}; ///< desk, gamepad, what; points
    constexpr float column_width = 390.0F;

    // Two newspaper columns: a new group begins the second once half of the lines are set.
    float total = 0.0F;
    std::string_view group;
    for (const input::Binding& binding : input::bindings()) {
        total += row + (binding.group != group ? heading : 0.0F);
        group = binding.group;
    }
    const float half = 0.5F * total + heading;
    const float height = std::min(half + 60.0F, canvas.height());
    const float left = 0.5F * canvas.width() - column_width;
    const float top = 0.5F * (canvas.height() - height);
    canvas.plate({left - 24.0F, top}, {left + 2.0F * column_width + 12.0F, top + height}, IM_COL32(8, 13, 17, 225));

    float x = left;
    float y = top + 14.0F;
    group = {};
    for (const input::Binding& binding : input::bindings()) {
        if (binding.group != group) {
            group = binding.group;
            if (x == left && y - top > half - 2.0F * heading) {
                x += column_width + 12.0F;
                y = top + 14.0F;
            }
            y += 6.0F;
            canvas.text({x, y}, std::string(group), canvas.fonts().text, palette::accent);
            y += heading - 6.0F;
        }
        canvas.text({x + columns[0], y}, input::desk_controls(binding), canvas.fonts().small, palette::value);
        canvas.text({x + columns[1] + 30.0F, y}, std::string(input::control_name(binding.gamepad)),
                    canvas.fonts().small, palette::label);
        canvas.text({x + columns[2] + 30.0F, y}, std::string(binding.what), canvas.fonts().small, palette::value);
        y += row;
    }
}

} // namespace engine
