#include "engine/fly/live_probe.h"

#include "engine/probe_text.h"

#include <cmath>

namespace engine {

LiveProbe::LiveProbe(const content::Scenario& scenario)
    : scene_(std::make_unique<const content::SceneDesc>(content::load_scene(scenario))), probe_(*scene_) {}

std::optional<HudProbe> LiveProbe::at(const render::RenderFrame& whole, const std::vector<Pane>& panes,
                                      const glm::dvec2& point, int width, int height) const {
    constexpr int samples = 160;
    render::RenderFrame frame = whole;
    frame.eye.width = width;
    frame.eye.height = height;
    const std::vector<PaneArea> areas = pane_areas(panes.size(), width, height);
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const PaneArea& area = areas[i];
        const glm::dvec2 inside = point - glm::dvec2(area.left, area.top);
        if (inside.x < 0.0 || inside.y < 0.0 || inside.x >= area.width || inside.y >= area.height) {
            continue;
        }
        const render::ProbedLight light = probe_.at(pane_frame(frame, panes[i], i, area), inside);
        HudProbe shown;
        shown.x = point.x / width;
        shown.y = point.y / height;
        shown.lines = probe_lines(light);
        shown.unit = radiance_unit(light);
        shown.wavelength_ratio = light.wavelength_ratio;
        for (int k = 0; k < samples; ++k) {
            const double nm =
                HudProbe::first_nm * std::pow(HudProbe::last_nm / HudProbe::first_nm, k / (samples - 1.0));
            shown.emitted.push_back(light.emitted(nm));
            shown.received.push_back(light.received(nm));
        }
        return shown;
    }
    return std::nullopt;
}

} // namespace engine
