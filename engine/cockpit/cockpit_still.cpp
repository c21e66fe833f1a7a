#include "engine/cockpit/cockpit_still.h"

#include "engine/cockpit/cockpit.h"
#include "engine/offscreen.h"
#include "render/gl/egl_context.h"

#include <algorithm>

namespace engine {
namespace {

/// The height, in points, that the instruments are laid out for.
constexpr float layout_height = 720.0F;

} // namespace

void draw_cockpit_over(content::Image& still, const content::SceneDesc& scene, const render::RenderFrame& frame,
                       const HudModel& instruments, double exposure_stops) {
    const render::EglContext context;
    render::Renderer renderer(scene, {});
    Cockpit cockpit(std::max(static_cast<float>(still.height) / layout_height, 0.5F));
    Offscreen target(still.width, still.height);
    target.write(still);
    cockpit.light(renderer, frame, {frame.eye.world_from_head.spin}, glm::dquat(1.0, 0.0, 0.0, 0.0), exposure_stops);
    PictureSettings picture;
    picture.mode = frame.mode;
    picture.exposure = frame.exposure;
    ComfortSettings comfort;
    for (int i = 0; i < 3; ++i) { // ImGui lays its windows out in their first frames
        cockpit.panel().draw(instruments, picture, comfort, {}, false, 0.0);
    }
    cockpit.draw(cabin_view(frame.eye, glm::dvec3(0.0), glm::dquat(1.0, 0.0, 0.0, 0.0)),
                 {exposure_stops, frame.exposure.linear_curve, frame.display.brightest}, target.framebuffer(),
                 {0, 0, still.width, still.height});
    still = target.read();
}

} // namespace engine
