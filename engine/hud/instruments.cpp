#include "engine/hud/instruments.h"

#include "engine/hud/canvas.h"
#include "engine/hud/instrument_parts.h"
#include "engine/hud/navigation_display.h"
#include "engine/hud/palette.h"
#include "engine/hud/pane_marks.h"
#include "engine/hud/readouts.h"
#include "engine/hud/spectrum_plot.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

namespace engine {
namespace {

constexpr float margin = 24.0F;

void draw_clocks(Canvas& canvas, const HudModel& model) {
    struct Entry {
        const char* label;
        std::string value;
        float width;
    };
    const std::array<Entry, 3> entries{Entry{"world clock", clock_text(model.world_clock, model.clock_unit), 92.0F},
                                       Entry{"ship clock", clock_text(model.ship_clock, model.clock_unit), 92.0F},
                                       Entry{"felt", g_text(model.felt_g), 64.0F}};
    const float y = canvas.height() - 58.0F;
    float right = canvas.width() - margin;
    for (const Entry& entry : entries) {
        canvas.text({right, y}, entry.label, canvas.fonts().small, palette::label, Align::right);
        canvas.text({right, y + 17.0F}, entry.value, canvas.fonts().text, palette::value, Align::right);
        right -= std::max(entry.width, canvas.text_width(entry.value, canvas.fonts().text)) + 20.0F;
    }
}

/// Between the readouts of motion and the clocks, where the window is wide enough.
void draw_scale_between(Canvas& canvas, const HudModel& model) {
    constexpr float left_group = 470.0F;
    constexpr float right_group = 350.0F;
    const float to = canvas.width() - right_group;
    if (to - left_group >= 220.0F) {
        draw_rapidity_scale(canvas, model.readings.rapidity, left_group, to, canvas.height() - 40.0F);
    }
}

void draw_status(Canvas& canvas, const HudModel& model) {
    float y = 16.0F;
    float x = margin;
    x += canvas.text({x, y}, model.title, canvas.fonts().text, palette::value) + 18.0F;
    x += canvas.text({x, y + 2.0F}, model.panes.front().name, canvas.fonts().small, palette::label) + 18.0F;
    x += canvas.text({x, y + 2.0F},
                     fmt::format("exposure {:+.1f}{}", model.panes.front().exposure_stops_used,
                                 model.exposure.automatic ? " automatic" : ""),
                     canvas.fonts().small, palette::label);

    float right = canvas.width() - margin;
    const auto put = [&](const std::string& text, ImU32 colour) {
        if (right - canvas.text_width(text, canvas.fonts().small) < x + 18.0F) { // a small window: one line lower
            right = canvas.width() - margin;
            x = 0.0F;
            y += 18.0F;
        }
        right -= canvas.text({right, y + 2.0F}, text, canvas.fonts().small, colour, Align::right) + 18.0F;
    };
    if (!model.recording_trouble.empty()) {
        put("not recording", palette::warning);
    } else if (model.recording) {
        put("recording", palette::label);
        canvas.disc({right + 10.0F, y + 9.5F}, 3.5F, palette::recording);
        right -= 8.0F;
    }
    if (model.relative_pace != 1.0) {
        put(fmt::format("pace x {:g}", model.relative_pace), palette::accent);
    }
    if (model.frame_seconds > 0.0) {
        put(fmt::format("{:.0f} ms  {:.0f} fps", 1e3 * model.frame_seconds, 1.0 / model.frame_seconds), palette::label);
        if (model.resolution_scale < 1.0) {
            put(fmt::format("dynamic resolution {:.0f} %", 100.0 * model.resolution_scale), palette::warning);
        }
    }
}

void draw_notices(Canvas& canvas, const HudModel& model) {
    std::vector<std::pair<std::string, ImU32>> lines;
    if (model.paused) {
        lines.emplace_back("paused", palette::value);
    }
    if (!model.recording_trouble.empty()) {
        lines.emplace_back(model.recording_trouble, palette::warning);
    }
    for (const std::string& notice : model.notices) {
        lines.emplace_back(notice, palette::accent);
    }
    float y = model.panes.size() > 1 ? 76.0F : 52.0F; // below the panes' names
    for (const auto& [text, colour] : lines) {
        canvas.text({0.5F * canvas.width(), y}, text, canvas.fonts().text, colour, Align::centre);
        y += 24.0F;
    }
}

} // namespace

std::string mode_name(render::Mode mode) {
    switch (mode) {
    case render::Mode::geometry:
        return "geometry only";
    case render::Mode::doppler:
        return "geometry and Doppler";
    case render::Mode::searchlight:
        return "geometry and searchlight";
    case render::Mode::full:
        return "everything";
    }
    return "";
}

void draw_instruments(const HudModel& model, const ImguiLayer& layer) {
    Canvas canvas(*ImGui::GetBackgroundDrawList(), layer);
    if (!model.cockpit) {
        canvas.shade(canvas.height() - 140.0F, canvas.height(), IM_COL32(4, 8, 12, 225));
    }
    canvas.shade(84.0F, 0.0F, IM_COL32(4, 8, 12, 175));
    draw_panes(canvas, model);
    if (model.panes.size() == 1) { // its marks lie over the whole picture
        draw_navigation(canvas, model);
    }
    if (!model.cockpit) {
        draw_motion_readouts(canvas, model, {margin, canvas.height() - 66.0F});
        draw_clocks(canvas, model);
        draw_scale_between(canvas, model);
    }
    draw_status(canvas, model);
    draw_notices(canvas, model);
    if (model.probe) {
        draw_spectrum_plot(canvas, *model.probe);
    }
}

} // namespace engine
