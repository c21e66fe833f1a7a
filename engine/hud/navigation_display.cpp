#include "engine/hud/navigation_display.h"

#include "engine/hud/palette.h"
#include "engine/hud/projection.h"
#include "engine/hud/readouts.h"

#include <algorithm>
#include <fmt/core.h>

namespace engine {
namespace {

constexpr float margin = 24.0F;
constexpr float line = 18.0F;
constexpr float top = 52.0F;

void diamond(Canvas& canvas, ImVec2 p, float size, ImU32 colour) {
    canvas.line({p.x, p.y - size}, {p.x + size, p.y}, colour, 1.4F);
    canvas.line({p.x + size, p.y}, {p.x, p.y + size}, colour, 1.4F);
    canvas.line({p.x, p.y + size}, {p.x - size, p.y}, colour, 1.4F);
    canvas.line({p.x - size, p.y}, {p.x, p.y - size}, colour, 1.4F);
}

/// A diamond where the target's light comes from, a cross where the target is now.
void draw_target(Canvas& canvas, const HudModel& model) {
    const TargetReading& target = model.navigation.target;
    const double fov = model.horizontal_field_of_view;
    if (target.name.empty()) {
        return;
    }
    if (const ImVec2 p = project(canvas, target.seen, fov); on_screen(canvas, target.seen, p)) {
        diamond(canvas, p, 9.0F, palette::warning);
        canvas.text({p.x + 14.0F, p.y - 8.0F}, target.name, canvas.fonts().small, palette::warning);
    }
    if (const ImVec2 p = project(canvas, target.now, fov); on_screen(canvas, target.now, p)) {
        canvas.line({p.x - 6.0F, p.y - 6.0F}, {p.x + 6.0F, p.y + 6.0F}, palette::warning, 1.2F);
        canvas.line({p.x - 6.0F, p.y + 6.0F}, {p.x + 6.0F, p.y - 6.0F}, palette::warning, 1.2F);
        canvas.text({p.x - 12.0F, p.y - 8.0F}, "now", canvas.fonts().small, palette::warning, Align::right);
    }
}

void draw_clock_markers(Canvas& canvas, const HudModel& model) {
    for (const ClockReading& clock : model.navigation.clocks) {
        const ImVec2 p = project(canvas, clock.direction, model.horizontal_field_of_view);
        if (clock.name != model.navigation.target.name && on_screen(canvas, clock.direction, p)) {
            diamond(canvas, p, 5.0F, palette::label);
            canvas.text({p.x + 9.0F, p.y - 8.0F}, clock.name, canvas.fonts().small, palette::label);
        }
    }
}

void draw_lists(Canvas& canvas, const HudModel& model) {
    float y = top;
    for (const std::string& clock : clock_lines(model)) {
        canvas.text({canvas.width() - margin, y}, clock, canvas.fonts().small, palette::value, Align::right);
        y += line;
    }
    y = top;
    if (!model.camera.empty()) {
        canvas.text({margin, y}, model.camera, canvas.fonts().small, palette::accent);
        y += line;
    }
    for (const NavigationLine& voyage : voyage_lines(model)) {
        canvas.text({margin, y}, voyage.text, canvas.fonts().small, voyage.colour);
        y += line;
    }
}

} // namespace

std::vector<std::string> clock_lines(const HudModel& model) {
    constexpr std::size_t most_lines = 8;
    std::vector<std::string> lines;
    const std::vector<ClockReading>& clocks = model.navigation.clocks;
    for (std::size_t i = 0; i < std::min(clocks.size(), most_lines); ++i) {
        const ClockReading& clock = clocks[i];
        lines.push_back(fmt::format("{} seen {}   D {}   now {}", clock.name, clock_text(clock.seen, model.clock_unit),
                                    wavelength_ratio_text(clock.wavelength_ratio),
                                    clock_text(clock.now, model.clock_unit)));
    }
    return lines;
}

std::vector<NavigationLine> voyage_lines(const HudModel& model) {
    const NavigationReading& navigation = model.navigation;
    std::vector<NavigationLine> lines;
    if (!navigation.target.name.empty()) {
        lines.push_back({fmt::format("target {}: {}, D {}", navigation.target.name,
                                     distance_text(navigation.target.distance, model.clock_unit),
                                     wavelength_ratio_text(navigation.target.wavelength_ratio)),
                         palette::warning});
        lines.push_back({navigation.forecast, palette::label});
    }
    for (const std::string& assist : navigation.assists) {
        lines.push_back({assist, palette::accent});
    }
    if (navigation.has_propellant) {
        lines.push_back({fmt::format("propellant {:.4g} of the ship's mass", navigation.propellant), palette::value});
    }
    return lines;
}

void draw_navigation(Canvas& canvas, const HudModel& model) {
    draw_clock_markers(canvas, model);
    draw_target(canvas, model);
    if (!model.cockpit) {
        draw_lists(canvas, model);
    }
}

} // namespace engine
