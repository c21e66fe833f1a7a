#include "engine/cockpit/cockpit_still.h"

#include "engine/cockpit/cockpit.h"
#include "engine/offscreen.h"
#include "render/gl/egl_context.h"

namespace engine {

void draw_cockpit_over(content::Image& still, const content::SceneDesc& scene, const render::RenderFrame& frame,
                       double exposure_stops) {
    const render::EglContext context;
    render::Renderer renderer(scene, {});
    Cockpit cockpit;
    Offscreen target(still.width, still.height);
    target.write(still);
    cockpit.light(renderer, frame, {frame.eye.world_from_head.spin}, exposure_stops);
    cockpit.draw(cabin_view(frame.eye, glm::dvec3(0.0), glm::dquat(1.0, 0.0, 0.0, 0.0)),
                 {exposure_stops, frame.exposure.linear_curve}, target.framebuffer(),
                 {0, 0, still.width, still.height});
    still = target.read();
}

} // namespace engine
