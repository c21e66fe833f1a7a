#include "engine/picture_maker.h"

#include "render/gl/egl_context.h"
#include "render/gl/software_opengl.h"
#include "render/offline/reference.h"
#include "render/raycast/ray_caster.h"
#include "sim/bad_input.h"

#include <cmath>

namespace engine {

PictureMethod chosen_method(PictureMethod method) {
    if (method != PictureMethod::automatic) {
        return method;
    }
    try {
        const render::EglContext context;
        return render::software_opengl() ? PictureMethod::ray : PictureMethod::texture;
    } catch (const sim::BadInput&) {
        return PictureMethod::ray; // without OpenGL
    }
}

render::Picture make_picture(const content::SceneDesc& scene, const PictureRequest& request) {
    if (request.method == PictureMethod::reference) {
        return render::ReferenceRenderer(scene).render(request.frame, request.samples_per_side);
    }
    if (request.method == PictureMethod::ray) {
        const render::SceneColour colour(scene);
        return render::RayCaster(scene, colour).picture(request.frame, request.samples_per_side);
    }
    const render::EglContext context;
    render::RendererSettings settings;
    settings.method = request.method == PictureMethod::plain ? render::Method::plain : render::Method::texture;
    render::Renderer renderer(scene, settings);
    return radiance_picture(renderer, request.frame);
}

render::Picture radiance_picture(render::Renderer& renderer, render::RenderFrame frame) {
    frame.exposure.automatic = true;
    frame.exposure.stops = 0.0f;
    if (frame.layer == render::Layer::light) {
        // Drawn once to find the exposure: by a first guess, faint stars are left out and half floats clip the sun.
        renderer.picture(frame);
    }
    render::Picture picture = renderer.picture(frame);
    if (frame.layer == render::Layer::light) {
        const auto radiance_from_exposed = static_cast<float>(std::exp2(-renderer.statistics().exposure_stops));
        for (float& value : picture.values) {
            value *= radiance_from_exposed;
        }
    }
    return picture;
}

} // namespace engine
