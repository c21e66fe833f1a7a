#pragma once

#include "content/scene_desc.h"
#include "render/render_frame.h"
#include "sim/quantities.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace engine {

class Canvas;
class ImageText;

/// What the colours and lines of an analysed picture stand for: a bar with marks.
struct Legend {
    struct Mark {
        double place = 0.0; ///< along the bar, in [0, 1]
        std::string label;
    };
    std::string title;
    std::vector<glm::vec3> colours; ///< encoded sRGB, evenly from the bar's left to its right
    std::vector<Mark> marks;        ///< iso-lines lie here
};

/// None for a natural picture without lines. `exposure_stops`: the whole exposure of the picture.
std::optional<Legend> legend_of(const render::Display& display, sim::Rapidity rapidity, double exposure_stops);

/// What draw_legend covers, points.
inline constexpr float legend_width = 432.0F;
inline constexpr float legend_height = 62.0F;

/// Draws it into a pane of the instruments whose lower left corner is given; points.
void draw_legend(Canvas& canvas, const Legend& legend, float left, float bottom);

/// Draws it into the lower left corner of a picture.
void stamp_legend(content::Image& image, const Legend& legend, const ImageText& text);

/// Writes a pane's name into its upper left corner.
void stamp_name(content::Image& image, const std::string& name, const ImageText& text);

} // namespace engine
