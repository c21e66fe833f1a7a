#include "engine/hud/pane_marks.h"

#include "engine/hud/canvas.h"
#include "engine/hud/legend.h"
#include "engine/hud/palette.h"
#include "engine/hud/spectrum_plot.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <optional>

namespace engine {
namespace {

// Points: the bands of the instruments, which marks keep out of.
constexpr float upper_band = 40.0F;

/// A pane in points.
struct PaneFrame {
    float left;
    float top;
    float width;
    float height;
    float focal; ///< points a unit tangent

    PaneFrame(const Canvas& canvas, const HudPane& pane)
        : left(canvas.width() * static_cast<float>(pane.left)), top(canvas.height() * static_cast<float>(pane.top)),
          width(canvas.width() * static_cast<float>(pane.width)),
          height(canvas.height() * static_cast<float>(pane.height)),
          focal(0.5F * width / static_cast<float>(std::tan(0.5 * pane.horizontal_field_of_view))) {}

    ImVec2 centre() const { return {left + 0.5F * width, top + 0.5F * height}; }
};

/// Where a direction in head axes is in the pane, if it is in view and clear of the instruments.
std::optional<ImVec2> place_of(const Canvas& canvas, const PaneFrame& pane, const glm::dvec3& d) {
    if (d.z > -1e-3) {
        return std::nullopt;
    }
    const ImVec2 centre = pane.centre();
    const ImVec2 at{centre.x + pane.focal * static_cast<float>(d.x / -d.z),
                    centre.y - pane.focal * static_cast<float>(d.y / -d.z)};
    const bool inside = at.x > pane.left + 12.0F && at.x < pane.left + pane.width - 12.0F && at.y > pane.top + 12.0F &&
                        at.y < pane.top + pane.height - 12.0F && at.y > upper_band &&
                        at.y < canvas.height() - readouts_height;
    return inside ? std::optional(at) : std::nullopt;
}

/// The nose: a waterline.
void draw_nose(Canvas& canvas, ImVec2 p) {
    canvas.line({p.x - 22.0F, p.y}, {p.x - 9.0F, p.y}, palette::line, 1.3F);
    canvas.line({p.x + 9.0F, p.y}, {p.x + 22.0F, p.y}, palette::line, 1.3F);
    canvas.disc(p, 1.6F, palette::value);
}

/// Where the ship is going: a ring with wings.
void draw_motion(Canvas& canvas, ImVec2 p) {
    canvas.circle(p, 8.0F, palette::accent, 1.4F);
    canvas.line({p.x - 17.0F, p.y}, {p.x - 8.0F, p.y}, palette::accent, 1.4F);
    canvas.line({p.x + 8.0F, p.y}, {p.x + 17.0F, p.y}, palette::accent, 1.4F);
    canvas.line({p.x, p.y - 14.0F}, {p.x, p.y - 8.0F}, palette::accent, 1.4F);
}

/// Where it comes from: a ring with a cross.
void draw_wake(Canvas& canvas, ImVec2 p) {
    canvas.circle(p, 8.0F, palette::accent, 1.2F);
    canvas.line({p.x - 4.0F, p.y - 4.0F}, {p.x + 4.0F, p.y + 4.0F}, palette::accent, 1.2F);
    canvas.line({p.x - 4.0F, p.y + 4.0F}, {p.x + 4.0F, p.y - 4.0F}, palette::accent, 1.2F);
}

/// Out of view: a chevron that points to it.
void draw_chevron(Canvas& canvas, const PaneFrame& pane, const glm::dvec3& motion) {
    const double across = std::hypot(motion.x, motion.y);
    const float ux = across > 0.0 ? static_cast<float>(motion.x / across) : 1.0F;
    const float uy = across > 0.0 ? static_cast<float>(-motion.y / across) : 0.0F;
    const float radius = 0.36F * std::fmin(pane.width, pane.height);
    const ImVec2 tip{pane.centre().x + radius * ux, pane.centre().y + radius * uy};
    canvas.triangle(tip, {tip.x - 14.0F * ux - 6.0F * uy, tip.y - 14.0F * uy + 6.0F * ux},
                    {tip.x - 14.0F * ux + 6.0F * uy, tip.y - 14.0F * uy - 6.0F * ux}, palette::accent);
}

void draw_markers(Canvas& canvas, const HudModel& model, const PaneFrame& pane) {
    if (const auto nose = place_of(canvas, pane, model.nose_in_head)) {
        draw_nose(canvas, *nose);
    }
    const glm::dvec3& motion = model.motion_in_head;
    if (glm::length(motion) == 0.0) {
        return;
    }
    if (const auto ahead = place_of(canvas, pane, motion)) {
        draw_motion(canvas, *ahead);
    } else if (const auto behind = place_of(canvas, pane, -motion)) {
        draw_wake(canvas, *behind);
    } else {
        draw_chevron(canvas, pane, motion);
    }
}

/// Whether a legend with this lower left corner would lie under the probe's plot.
bool under_the_plot(const Canvas& canvas, const HudModel& model, float left, float bottom) {
    if (!model.probe) {
        return false;
    }
    const PlotPlace plot = spectrum_plot_place(canvas, *model.probe);
    return left + legend_width > plot.left && bottom > plot.top && bottom - legend_height < plot.bottom;
}

} // namespace

void draw_panes(Canvas& canvas, const HudModel& model) {
    for (const HudPane& shown : model.panes) {
        const PaneFrame pane(canvas, shown);
        draw_markers(canvas, model, pane);
        const bool lowest = shown.top + shown.height > 0.999;
        const float bottom = pane.top + pane.height - (lowest ? readouts_height + model.above_readouts + 8.0F : 12.0F);
        if (const auto legend = legend_of(shown.display, model.readings.rapidity, shown.exposure_stops_used)) {
            const float left = pane.left + 16.0F;
            if (!under_the_plot(canvas, model, left, bottom)) { // it is back when the probe is off
                draw_legend(canvas, *legend, left, bottom);
            }
        }
        if (model.panes.size() > 1) {
            const float y = pane.top + (shown.top == 0.0 ? upper_band : 8.0F);
            canvas.text({pane.left + 24.0F, y}, shown.name, canvas.fonts().text, palette::accent);
        }
        if (shown.left > 0.0) {
            canvas.line({pane.left, pane.top}, {pane.left, pane.top + pane.height}, palette::line);
        }
        if (shown.top > 0.0) {
            canvas.line({pane.left, pane.top}, {pane.left + pane.width, pane.top}, palette::line);
        }
    }
}

} // namespace engine
