#include "engine/hud/spectrum_plot.h"

#include "engine/hud/canvas.h"
#include "engine/hud/palette.h"
#include "engine/probe_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace engine {
namespace {

// Points.
constexpr float plate_width = 352.0F;
constexpr float plot_width = 312.0F;
constexpr float plot_height = 128.0F;
constexpr float padding = 18.0F;
constexpr float row = 17.0F;

constexpr double decades_shown = 8.0;

/// Roughly what a pure wavelength looks like, for the visible band's ground.
ImU32 colour_of(double nm) {
    const auto hump = [nm](double centre, double width) { return std::exp(-std::pow((nm - centre) / width, 2.0)); };
    const double red = hump(620.0, 55.0) + 0.35 * hump(420.0, 22.0);
    const double green = hump(540.0, 45.0);
    const double blue = hump(455.0, 35.0);
    const auto byte = [](double v) { return static_cast<int>(std::lround(255.0 * std::min(v, 1.0))); };
    return IM_COL32(byte(red), byte(green), byte(blue), 110);
}

/// Where on the plot's axis a wavelength lies, in [0, 1].
float along(double nm) {
    return static_cast<float>(std::log(nm / HudProbe::first_nm) / std::log(HudProbe::last_nm / HudProbe::first_nm));
}

void draw_ground(Canvas& canvas, ImVec2 corner) {
    constexpr int strips = 48;
    const double step = (last_visible_nm - first_visible_nm) / strips;
    for (int i = 0; i < strips; ++i) {
        const double nm = first_visible_nm + i * step;
        canvas.bar({corner.x + plot_width * along(nm), corner.y},
                   {corner.x + plot_width * along(nm + step), corner.y + plot_height}, colour_of(nm + 0.5 * step));
    }
    struct Mark {
        double nm;
        const char* label;
    };
    constexpr std::array marks{Mark{100.0, "100 nm"}, Mark{300.0, "300"}, Mark{1000.0, "1 \u00B5m"}, Mark{3000.0, "3"},
                               Mark{10000.0, "10 \u00B5m"}};
    canvas.line({corner.x, corner.y + plot_height}, {corner.x + plot_width, corner.y + plot_height}, palette::line);
    for (const Mark& mark : marks) {
        const float x = corner.x + plot_width * along(mark.nm);
        canvas.line({x, corner.y + plot_height}, {x, corner.y + plot_height + 4.0F}, palette::line);
        canvas.text({x, corner.y + plot_height + 6.0F}, mark.label, canvas.fonts().small, palette::label,
                    Align::centre);
    }
}

void draw_curve(Canvas& canvas, ImVec2 corner, const std::vector<double>& curve, double most, ImU32 colour) {
    const auto place = [&](std::size_t i) {
        const double decades = curve[i] > 0.0 ? std::log10(curve[i] / most) : -decades_shown;
        const double height = std::clamp(1.0 + decades / decades_shown, 0.0, 1.0);
        return ImVec2{corner.x + plot_width * static_cast<float>(i) / static_cast<float>(curve.size() - 1),
                      corner.y + plot_height * static_cast<float>(1.0 - height)};
    };
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const ImVec2 from = place(i - 1);
        const ImVec2 to = place(i);
        if (from.y < corner.y + plot_height || to.y < corner.y + plot_height) {
            canvas.stroke(from, to, colour, 1.8F);
        }
    }
}

} // namespace

PlotPlace spectrum_plot_place(const Canvas& canvas, const HudProbe& probe) {
    constexpr float top = 52.0F;
    const float text_height = row * static_cast<float>(probe.lines.size());
    return {canvas.width() - plate_width - 24.0F, top, top + plot_height + text_height + 76.0F};
}

void draw_spectrum_plot(Canvas& canvas, const HudProbe& probe) {
    const ImVec2 at{canvas.width() * static_cast<float>(probe.x), canvas.height() * static_cast<float>(probe.y)};
    canvas.circle(at, 5.0F, palette::value, 1.2F);
    canvas.line({at.x - 12.0F, at.y}, {at.x - 5.0F, at.y}, palette::value, 1.2F);
    canvas.line({at.x + 5.0F, at.y}, {at.x + 12.0F, at.y}, palette::value, 1.2F);

    const PlotPlace place = spectrum_plot_place(canvas, probe);
    const float x = place.left;
    canvas.plate({x, place.top}, {x + plate_width, place.bottom}, IM_COL32(6, 11, 15, 215));
    float y = place.top + 10.0F;
    for (const std::string& line : probe.lines) {
        canvas.text({x + padding, y}, line, canvas.fonts().small, palette::value);
        y += row;
    }
    const ImVec2 corner{x + 0.5F * (plate_width - plot_width), y + 10.0F};
    draw_ground(canvas, corner);
    const double most = std::max({*std::max_element(probe.emitted.begin(), probe.emitted.end()),
                                  *std::max_element(probe.received.begin(), probe.received.end()), 1e-300});
    draw_curve(canvas, corner, probe.emitted, most, palette::label);
    draw_curve(canvas, corner, probe.received, most, palette::accent);
    const float foot = corner.y + plot_height + 26.0F;
    const float width = canvas.text({x + padding, foot}, "emitted", canvas.fonts().small, palette::label);
    canvas.text({x + padding + width + 14.0F, foot}, "received", canvas.fonts().small, palette::accent);
    canvas.text({x + plate_width - padding, foot}, "eight decades of radiance", canvas.fonts().small, palette::label,
                Align::right);
}

} // namespace engine
