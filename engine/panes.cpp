#include "engine/panes.h"

#include "engine/hud/hud_model.h"

#include <cmath>

namespace engine {

std::vector<Pane> panes_of(const PictureSettings& picture) {
    std::vector<Pane> panes{{picture.mode, picture.display.view}};
    panes.insert(panes.end(), picture.other_panes.begin(), picture.other_panes.end());
    return panes;
}

std::vector<PaneArea> pane_areas(std::size_t count, int width, int height) {
    const std::size_t rows = count == most_panes ? 2 : 1;
    const std::size_t columns = count / rows;
    const auto cut = [](std::size_t i, std::size_t parts, int length) {
        return static_cast<int>(i) * length / static_cast<int>(parts);
    };
    std::vector<PaneArea> areas;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const int left = cut(column, columns, width);
            const int top = cut(row, rows, height);
            areas.push_back({left, top, cut(column + 1, columns, width) - left, cut(row + 1, rows, height) - top});
        }
    }
    return areas;
}

render::RenderFrame pane_frame(render::RenderFrame whole, const Pane& pane, std::size_t index, const PaneArea& area) {
    const double half_height = std::tan(0.5 * whole.eye.horizontal_field_of_view) * whole.eye.height / whole.eye.width;
    if (area.width != whole.eye.width || area.height != whole.eye.height) {
        whole.eye.horizontal_field_of_view = 2.0 * std::atan(half_height * area.width / area.height);
    }
    whole.eye.width = area.width;
    whole.eye.height = area.height;
    whole.mode = pane.mode;
    whole.display.view = pane.view;
    whole.pane = index;
    return whole;
}

std::string pane_name(const Pane& pane) {
    switch (pane.view) {
    case render::View::natural:
        break;
    case render::View::doppler:
        return "D in false colour";
    case render::View::rings:
        return "D in rings";
    case render::View::luminance:
        return mode_name(pane.mode) + ": luminance";
    }
    return mode_name(pane.mode);
}

} // namespace engine
