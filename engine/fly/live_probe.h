#pragma once

#include "content/scenario.h"
#include "engine/hud/hud_model.h"
#include "engine/panes.h"
#include "render/offline/spectrum_probe.h"

#include <memory>
#include <optional>

namespace engine {

/// The spectrum probe of a flight, which points where the mouse does.
class LiveProbe {
  public:
    /// Reads the scene once more: its triangles are searched apart from the renderer's. Throws sim::BadInput.
    explicit LiveProbe(const content::Scenario& scenario);

    /// What lies under a point, in pixels from the upper left corner of a picture of `width` x `height` pixels in
    /// `panes`; none outside of it. `whole`: the picture's frame, of any size with that shape.
    std::optional<HudProbe> at(const render::RenderFrame& whole, const std::vector<Pane>& panes,
                               const glm::dvec2& point, int width, int height) const;

  private:
    std::unique_ptr<const content::SceneDesc> scene_;
    render::SpectrumProbe probe_;
};

} // namespace engine
