#pragma once

#include "content/generator/cabin.h"
#include "engine/cockpit/panel_picture.h"
#include "engine/cockpit/panel_pointer.h"
#include "engine/cockpit/scenery_light.h"
#include "render/cabin/cabin_light.h"
#include "render/cabin/cabin_pass.h"

namespace engine {

/// The cabin around the pilot: modelled, lit by the scenery, drawn over each eye's finished picture, with instruments
/// on its screens. Needs an OpenGL 4.5 context current, the same one from construction to destruction.
class Cockpit {
  public:
    /// `panel_scale`: pixels per point of the screens' text.
    explicit Cockpit(float panel_scale);

    /// Looks around with the renderer for some of the light and lights the cabin with what is known of it; once a
    /// frame, whatever the number of eyes. `frame`: an eye's, whose picture was shown by `exposure_stops`.
    /// `vehicle_from_cabin`: how the cabin is turned in the ship. The first call looks everywhere.
    void light(render::Renderer& renderer, const render::RenderFrame& frame,
               const sim::Lorentz<sim::World, sim::Vehicle>& world_from_vehicle, const glm::dquat& vehicle_from_cabin,
               double exposure_stops);

    /// Draws the cabin over an eye's picture.
    void draw(const render::CabinView& view, const render::CabinExposure& exposure, unsigned target_framebuffer,
              const render::Viewport& viewport);

    const content::generator::Cabin& cabin() const { return cabin_; }
    PanelPicture& panel() { return panel_; }
    const PanelPicture& panel() const { return panel_; }

  private:
    content::generator::Cabin cabin_;
    render::CabinLight cabin_light_;
    render::CabinPass pass_;
    SceneryLight scenery_light_;
    PanelPicture panel_;
};

/// The view of an eye at the pilot's seat on an ordinary screen, as the renderer's own picture of it.
render::CabinView cabin_view(const render::EyeView& eye, const glm::dvec3& head_metres,
                             const glm::dquat& cabin_from_head);

} // namespace engine
