#include "engine/hud/instrument_parts.h"

#include "engine/hud/palette.h"
#include "engine/hud/readouts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace engine {
namespace {

/// Blue for blueshift, red for redshift, white between; full colour from a factor of three.
ImU32 shift_colour(double ratio) {
    const double s = std::clamp(std::log(ratio) / std::log(3.0), -1.0, 1.0);
    const double cold = std::max(-s, 0.0);
    const double hot = std::max(s, 0.0);
    const auto channel = [](double v) { return static_cast<int>(255.0 * v); };
    return IM_COL32(channel(1.0 - 0.65 * cold), channel(1.0 - 0.35 * cold - 0.65 * hot), channel(1.0 - 0.75 * hot),
                    255);
}

} // namespace

float readout(Canvas& canvas, ImVec2 at, const std::string& label, const std::string& value, float least_width) {
    canvas.text(at, label, canvas.fonts().small, palette::label);
    const float width = canvas.text({at.x, at.y + 17.0F}, value, canvas.fonts().text, palette::value);
    return at.x + std::max(width, least_width) + 22.0F;
}

void draw_motion_readouts(Canvas& canvas, const HudModel& model, ImVec2 at) {
    const bool greek = canvas.fonts().greek;
    const sim::Readings& r = model.readings;
    const float y = at.y;
    canvas.text({at.x, y - 8.0F}, greek ? "speed \u03B2" : "speed beta", canvas.fonts().small, palette::label);
    const std::string beta = beta_text(r);
    const float beta_width = canvas.text({at.x, y + 6.0F}, beta, canvas.fonts().large, palette::value);
    const float unit_x = at.x + beta_width + 6.0F;
    canvas.text({unit_x, y + 26.0F}, "c", canvas.fonts().text, palette::label);

    float x = unit_x + 36.0F;
    x = readout(canvas, {x, y + 8.0F}, greek ? "\u03B3" : "gamma", gamma_text(r), 44.0F);
    x = readout(canvas, {x, y + 8.0F}, "rapidity", rapidity_text(r.rapidity), 44.0F);
    canvas.disc({x + 3.5F, y + 33.5F}, 3.5F, shift_colour(r.wavelength_ratio_ahead));
    canvas.text({x, y + 8.0F}, "D ahead", canvas.fonts().small, palette::label);
    canvas.text({x + 13.0F, y + 25.0F}, wavelength_ratio_text(r.wavelength_ratio_ahead), canvas.fonts().text,
                palette::value);
}

void draw_rapidity_scale(Canvas& canvas, sim::Rapidity rapidity, float from, float to, float y) {
    struct Mark {
        double beta;
        const char* label;
    };
    constexpr std::array marks{Mark{0.0, "0"},    Mark{0.5, ".5"},     Mark{0.9, ".9"},
                               Mark{0.99, ".99"}, Mark{0.999, ".999"}, Mark{0.9999, ".9999"}};
    const double end = std::atanh(0.99995);
    const auto place = [&](double xi) { return from + (to - from) * static_cast<float>(std::min(xi / end, 1.0)); };
    canvas.line({from, y}, {to, y}, palette::line);
    for (const Mark& mark : marks) {
        const float x = place(std::atanh(mark.beta));
        canvas.line({x, y}, {x, y + 5.0F}, palette::line);
        canvas.text({x, y + 8.0F}, mark.label, canvas.fonts().small, palette::label, Align::centre);
    }
    const float x = place(rapidity.value);
    canvas.line({from, y}, {x, y}, palette::accent, 2.0F);
    canvas.triangle({x, y - 2.0F}, {x - 5.0F, y - 10.0F}, {x + 5.0F, y - 10.0F}, palette::accent);
}

} // namespace engine
