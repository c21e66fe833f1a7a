#include "engine/hud/legend.h"

#include "engine/hud/canvas.h"
#include "engine/hud/image_text.h"
#include "engine/hud/palette.h"
#include "engine/hud/readouts.h"
#include "render/colour/display.h"
#include "render/colour/false_colour_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace engine {
namespace {

constexpr int bar_colours = 192;
// Points.
constexpr float bar_width = 384.0F;
constexpr float bar_height = 12.0F;
constexpr float padding = 12.0F;
static_assert(legend_width == bar_width + 4.0F * padding);

Legend shift_legend(const render::Display& display, const render::ShiftScale& scale) {
    Legend legend;
    legend.title =
        display.iso_lines ? "D = wavelength seen / emitted; lines at the marks" : "D = wavelength seen / emitted";
    const auto steps = static_cast<int>(std::lround(scale.range / scale.step));
    // Thirteen labels at most find room.
    const int every = steps > 6 ? 2 : 1;
    for (int k = -steps; k <= steps; ++k) {
        const std::string label = k % every == 0 ? wavelength_ratio_text(std::exp2(k * scale.step)) : "";
        legend.marks.push_back({0.5 + 0.5 * k / steps, label});
    }
    for (int i = 0; i < bar_colours; ++i) {
        const double level = scale.range * (2.0 * (i + 0.5) / bar_colours - 1.0);
        const double shown = display.view == render::View::rings ? render::band_middle(level, scale.step) : level;
        legend.colours.push_back(display.view == render::View::natural
                                     ? render::with_iso_line(glm::vec3(0.3F), 0.0, 1.0, 1.0, true)
                                     : render::shift_colour(shown, scale.range));
    }
    return legend;
}

Legend brightness_legend(double exposure_stops) {
    const render::BrightnessScale scale;
    Legend legend;
    legend.title = "luminance; 1: white that the sun lights squarely";
    const double span = scale.brightest - scale.darkest;
    for (double stops = scale.darkest; stops <= scale.brightest; stops += scale.step) {
        const double seen = render::shown_middle_grey * std::exp2(stops - exposure_stops);
        legend.marks.push_back({(stops - scale.darkest) / span, wavelength_ratio_text(seen)});
    }
    for (int i = 0; i < bar_colours; ++i) {
        legend.colours.push_back(render::brightness_colour((i + 0.5) / bar_colours));
    }
    return legend;
}

} // namespace

std::optional<Legend> legend_of(const render::Display& display, sim::Rapidity rapidity, double exposure_stops) {
    if (display.view == render::View::luminance) {
        return brightness_legend(exposure_stops);
    }
    if (display.view == render::View::natural && !display.iso_lines) {
        return std::nullopt;
    }
    return shift_legend(display, render::shift_scale(rapidity));
}

void draw_legend(Canvas& canvas, const Legend& legend, float left, float bottom) {
    const float top = bottom - legend_height;
    canvas.plate({left, top}, {left + legend_width, bottom}, IM_COL32(6, 11, 15, 205));
    const float x = left + 2.0F * padding;
    canvas.text({x, top + 6.0F}, legend.title, canvas.fonts().small, palette::label);
    const float bar = top + 25.0F;
    const float step = bar_width / static_cast<float>(legend.colours.size());
    for (std::size_t i = 0; i < legend.colours.size(); ++i) {
        const glm::vec3 c = 255.0F * legend.colours[i];
        const float from = x + static_cast<float>(i) * step;
        canvas.bar({from, bar}, {from + step, bar + bar_height},
                   IM_COL32(static_cast<int>(c.r), static_cast<int>(c.g), static_cast<int>(c.b), 255));
    }
    for (const Legend::Mark& mark : legend.marks) {
        const float at = x + bar_width * static_cast<float>(mark.place);
        canvas.line({at, bar + bar_height}, {at, bar + bar_height + 4.0F}, palette::line);
        canvas.text({at, bar + bar_height + 5.0F}, mark.label, canvas.fonts().small, palette::value, Align::centre);
    }
}

void stamp_legend(content::Image& image, const Legend& legend, const ImageText& text) {
    const float scale = text.scale() * std::min(1.0F, static_cast<float>(image.width) / (text.scale() * legend_width));
    const auto pixels = [scale](float points) { return static_cast<int>(std::lround(scale * points)); };
    const int left = std::min(pixels(padding), std::max(image.width - pixels(legend_width), 0) / 2);
    const int bottom = image.height - pixels(padding);
    const int top = bottom - pixels(legend_height);
    text.fill(image, {left, top}, {left + pixels(legend_width), bottom}, {0.02F, 0.04F, 0.06F}, 0.8F);
    const int x = left + pixels(2.0F * padding);
    text.write(image, {x, top + pixels(6.0F)}, legend.title, 0.0F);
    const int bar = top + pixels(25.0F);
    const int length = pixels(bar_width);
    for (int i = 0; i < length; ++i) {
        const auto colour = static_cast<std::size_t>(i) * legend.colours.size() / static_cast<std::size_t>(length);
        text.fill(image, {x + i, bar}, {x + i + 1, bar + pixels(bar_height)}, legend.colours[colour], 1.0F);
    }
    for (const Legend::Mark& mark : legend.marks) {
        const int at = x + static_cast<int>(std::lround(length * mark.place));
        const int under = bar + pixels(bar_height);
        text.fill(image, {at, under}, {at + 1, under + pixels(4.0F)}, {0.8F, 0.88F, 0.92F}, 1.0F);
        text.write(image, {at, under + pixels(5.0F)}, mark.label, 0.5F);
    }
}

void stamp_name(content::Image& image, const std::string& name, const ImageText& text) {
    const auto pixels = [&](float points) { return static_cast<int>(std::lround(text.scale() * points)); };
    const int width = static_cast<int>(text.width(name)) + pixels(20.0F);
    text.fill(image, {pixels(8.0F), pixels(8.0F)}, {pixels(8.0F) + width, pixels(32.0F)}, {0.02F, 0.04F, 0.06F}, 0.7F);
    text.write(image, {pixels(18.0F), pixels(12.0F)}, name, 0.0F);
}

} // namespace engine
