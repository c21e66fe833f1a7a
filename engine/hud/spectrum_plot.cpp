#include "engine/hud/spectrum_plot.h"

#include "engine/hud/canvas.h"
#include "engine/hud/palette.h"
#include "engine/probe_text.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace engine {
namespace {

// Points.
constexpr float plate_width = 396.0F;
constexpr float plot_left = 56.0F; ///< room for the vertical scale's labels
constexpr float plot_width = 318.0F;
constexpr float plot_height = 144.0F;
constexpr float strip_height = 7.0F;
constexpr float padding = 18.0F;
constexpr float row = 17.0F;

ImU32 colour_of(double nm, int alpha) {
    const glm::vec3 bytes = glm::round(255.0F * pure_colour(nm));
    return IM_COL32(static_cast<int>(bytes.r), static_cast<int>(bytes.g), static_cast<int>(bytes.b), alpha);
}

/// Where on the plot's axis a wavelength lies, 0 to 1 within it.
double along(double nm) {
    return std::log(nm / HudProbe::first_nm) / std::log(HudProbe::last_nm / HudProbe::first_nm);
}

/// The visible colours between two heights, each at `scale` times its own wavelength; what is off the plot is cut.
void draw_colours(Canvas& canvas, ImVec2 corner, double scale, float top, float bottom, int alpha) {
    constexpr int strips = 48;
    const double step = (last_visible_nm - first_visible_nm) / strips;
    const auto place = [&](double nm) {
        return corner.x + plot_width * static_cast<float>(std::clamp(along(scale * nm), 0.0, 1.0));
    };
    for (int i = 0; i < strips; ++i) {
        const double nm = first_visible_nm + i * step;
        if (place(nm + step) > place(nm)) {
            canvas.bar({place(nm), corner.y + top}, {place(nm + step), corner.y + bottom},
                       colour_of(nm + 0.5 * step, alpha));
        }
    }
}

void draw_scales(Canvas& canvas, ImVec2 corner, const RadianceAxis& axis) {
    struct Mark {
        double nm;
        const char* label;
    };
    constexpr std::array marks{Mark{100.0, "100 nm"}, Mark{300.0, "300"}, Mark{1000.0, "1 \u00B5m"}, Mark{3000.0, "3"},
                               Mark{10000.0, "10 \u00B5m"}};
    constexpr ImU32 faint = IM_COL32(205, 226, 234, 45);
    const float foot = corner.y + plot_height;
    for (const Mark& mark : marks) {
        const float x = corner.x + plot_width * static_cast<float>(along(mark.nm));
        canvas.stroke({x, corner.y}, {x, foot}, faint, 1.0F);
        canvas.stroke({x, foot}, {x, foot + 4.0F}, palette::line, 1.0F);
        canvas.text({x, foot + 5.0F}, mark.label, canvas.fonts().small, palette::label, Align::centre);
    }
    for (int below = 0; below <= RadianceAxis::decades; below += 2) {
        const float y = corner.y + plot_height * static_cast<float>(below) / RadianceAxis::decades;
        canvas.stroke({corner.x, y}, {corner.x + plot_width, y}, below == RadianceAxis::decades ? palette::line : faint,
                      1.0F);
        canvas.text({corner.x - 6.0F, y - 8.0F}, axis.label(below), canvas.fonts().small, palette::label, Align::right);
    }
}

void draw_curve(Canvas& canvas, ImVec2 corner, const std::vector<double>& curve, const RadianceAxis& axis,
                ImU32 colour) {
    const float foot = corner.y + plot_height;
    const auto place = [&](std::size_t i) {
        return ImVec2{corner.x + plot_width * static_cast<float>(i) / static_cast<float>(curve.size() - 1),
                      foot - plot_height * static_cast<float>(axis.height(curve[i]))};
    };
    // What lies on the foot is off the scale: drawn are the stretches above it, from foot to foot.
    std::vector<ImVec2> stretch;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const ImVec2 point = place(i);
        const bool off = point.y >= foot;
        if (off && stretch.size() == 1) {
            stretch.clear();
        }
        stretch.push_back(point);
        if (stretch.size() > 1 && (off || i + 1 == curve.size())) {
            canvas.curve(stretch, colour, 1.8F);
            stretch = {point};
        }
    }
}

} // namespace

PlotPlace spectrum_plot_place(const Canvas& canvas, const HudProbe& probe) {
    constexpr float top = 52.0F;
    const float text_height = row * static_cast<float>(probe.lines.size() + 1);
    return {canvas.width() - plate_width - 24.0F, top, top + plot_height + text_height + 80.0F};
}

void draw_spectrum_plot(Canvas& canvas, const HudProbe& probe) {
    const ImVec2 at{canvas.width() * static_cast<float>(probe.x), canvas.height() * static_cast<float>(probe.y)};
    canvas.circle(at, 5.0F, palette::value, 1.2F);
    canvas.line({at.x - 12.0F, at.y}, {at.x - 5.0F, at.y}, palette::value, 1.2F);
    canvas.line({at.x + 5.0F, at.y}, {at.x + 12.0F, at.y}, palette::value, 1.2F);

    const PlotPlace place = spectrum_plot_place(canvas, probe);
    const float x = place.left;
    canvas.plate({x, place.top}, {x + plate_width, place.bottom}, IM_COL32(6, 11, 15, 246));
    float y = place.top + 10.0F;
    for (const std::string& line : probe.lines) {
        canvas.text({x + padding, y}, line, canvas.fonts().small, palette::value);
        y += row;
    }
    canvas.text({x + padding, y + 4.0F}, probe.unit, canvas.fonts().small, palette::label);
    const ImVec2 corner{x + plot_left, y + row + 16.0F};
    draw_colours(canvas, corner, 1.0, 0.0F, plot_height, 95);
    draw_colours(canvas, corner, 1.0 / probe.wavelength_ratio, plot_height - strip_height, plot_height, 255);
    const RadianceAxis axis(std::max(*std::max_element(probe.emitted.begin(), probe.emitted.end()),
                                     *std::max_element(probe.received.begin(), probe.received.end())));
    draw_scales(canvas, corner, axis);
    draw_curve(canvas, corner, probe.emitted, axis, palette::label);
    draw_curve(canvas, corner, probe.received, axis, palette::accent);
    const float foot = corner.y + plot_height + 28.0F;
    float next = x + padding;
    next += canvas.text({next, foot}, "emitted", canvas.fonts().small, palette::label) + 14.0F;
    canvas.text({next, foot}, "received", canvas.fonts().small, palette::accent);
    canvas.text({x + plate_width - padding, foot}, "foot: where what is seen was emitted", canvas.fonts().small,
                palette::label, Align::right);
}

} // namespace engine
