#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "render/offline/reference.h"
#include "tests/render/ship_kit.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>

using namespace ship_kit;

TEST_CASE("OpenGL draws a passing ship where the reference sees it, to moving eyes and to resting ones") {
    const render::EglContext context;
    content::SceneDesc scene = empty_scene();
    scene.ambient = glm::vec3(0.5f);
    scene_kit::add(scene, scene_kit::rectangle({6.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f}),
                   scene_kit::unlit({0.0f, 1.0f, 0.0f}));
    sim::VehicleState ship;
    for (const render::Method method : {render::Method::texture, render::Method::plain}) {
        render::RendererSettings settings;
        settings.method = method;
        settings.shadow_map_size = 256;
        render::Renderer renderer(scene, settings);
        render::RenderFrame frame = passing_frame(0.9, glowing_ship(), ship);
        if (method == render::Method::texture) {
            frame.eye.world_from_head = sim::world_from_looking<sim::Head>(
                sim::Rapidity(0.7), glm::normalize(glm::dvec3(0.3, 0.1, -1.0)), {1.0, 0.0, 0.0});
        }
        frame.mode = render::Mode::full;
        const render::ReferenceRenderer truth(scene);
        frame.layer = render::Layer::object;
        frame.sharpness = 2.0;
        // A third of a thin ship's pixels are its outline's; there texels are read up to half a pixel off.
        CHECK(disagreement(truth.render(frame, 1), renderer.picture(frame), 1, 1) < 0.12);
        frame.layer = render::Layer::light;
        const render::Picture expected = truth.render(frame, 2);
        const render::Picture drawn = renderer.picture(frame);
        double difference = 0.0;
        double all = 0.0;
        for (std::size_t i = 0; i < expected.values.size(); ++i) {
            difference += std::abs(double{expected.values[i]} - double{drawn.values[i]});
            all += double{expected.values[i]};
        }
        CHECK(difference / all < 0.06); // edges against averaged edges
    }
}
