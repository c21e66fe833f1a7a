#include "render/gl/renderer.h"

#include "render/gl/egl_context.h"
#include "render/gl/software_opengl.h"
#include "render/gl/warp_error.h"
#include "scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

const glm::dvec3 forwards(0.0, 0.0, -1.0);

render::Renderer renderer_of(const content::SceneDesc& scene, render::Method method) {
    render::RendererSettings settings;
    settings.method = method;
    settings.shadow_map_size = 256;
    return {scene, settings};
}

bool all_finite(const render::Picture& picture) {
    return std::all_of(picture.values.begin(), picture.values.end(), [](float v) { return std::isfinite(v); });
}

/// A room of coloured walls with pillars in it, lit by sun, sky and one lamp.
content::SceneDesc room() {
    content::SceneDesc scene;
    scene.ambient = glm::vec3(0.4f, 0.45f, 0.5f);
    scene.sun.emplace();
    scene.sun->direction = glm::normalize(glm::vec3(0.3f, 0.8f, 0.5f));
    content::Lamp lamp;
    lamp.position = {1.0f, 0.5f, -3.0f};
    lamp.intensity = glm::vec3(6.0f, 5.0f, 3.0f);
    scene.lamps.push_back(lamp);
    scene_kit::add(scene, scene_kit::rectangle({0, -2, 0}, {40, 0, 0}, {0, 0, -40}), scene_kit::matte({0.6, 0.5, 0.4}));
    for (int i = 0; i < 12; ++i) {
        const double angle = 0.5 + i * 0.5236;
        const glm::vec3 at(glm::dvec3(8.0 * std::sin(angle), 0.0, 8.0 * std::cos(angle)));
        scene_kit::add(scene, scene_kit::sphere(at, 1.2f, 24), scene_kit::matte({0.2f + 0.06f * float(i), 0.5f, 0.7f}));
    }
    return scene;
}

} // namespace

TEST_CASE("the GPU's warp agrees with double precision") {
    const render::EglContext context;
    for (const double rapidity : {0.0, 2.0, 10.0}) {
        for (const glm::dvec3& heading : {forwards, -forwards, glm::dvec3(1, 0, 0), glm::dvec3(0.48, 0.6, -0.64)}) {
            const render::WarpError error =
                render::warp_error(scene_kit::frame(rapidity, heading, forwards, 320, 180).eye);
            CAPTURE(rapidity, heading.x, heading.z);
            CHECK(error.pixels < 0.1); // what the project promises; single precision gives about 1e-3
            CHECK(error.relative_d < 1e-4);
        }
    }
}

TEST_CASE("tiles and warp give an eye at rest the picture that is drawn straight") {
    const render::EglContext context;
    const content::SceneDesc scene = room();
    render::Renderer plain = renderer_of(scene, render::Method::plain);
    render::Renderer warped = renderer_of(scene, render::Method::texture);
    const render::RenderFrame frame = scene_kit::frame(0.0, forwards, {0.6, 0.0, -0.8}, 320, 180);
    const render::Picture a = plain.picture(frame);
    const render::Picture b = warped.picture(frame);
    CHECK(plain.statistics().method == render::Method::plain);
    CHECK(warped.statistics().method == render::Method::texture);
    double sum = 0.0;
    double largest_inside = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        sum += std::abs(static_cast<double>(a.values[i] - b.values[i]));
    }
    for (int x = 0; x < 320; ++x) {
        largest_inside =
            std::max(largest_inside, glm::distance(scene_kit::colour_at(a, x, 178), scene_kit::colour_at(b, x, 178)));
    }
    // Edges are filtered differently, which is a few pixels in a hundred; smooth ground is the same to half floats.
    CHECK(sum / static_cast<double>(a.values.size()) < 0.005);
    CHECK(largest_inside < 0.01);
}

TEST_CASE("no picture has a NaN or an infinity, straight along the axes and at any speed") {
    const render::EglContext context;
    render::Renderer renderer = renderer_of(room(), render::Method::automatic);
    for (const double rapidity : {0.0, 5e-5, 1e-3, 0.9, 2.6467, 5.0, 10.0}) {
        for (const glm::dvec3& heading : {forwards, -forwards, glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
            for (const render::Mode mode : {render::Mode::geometry, render::Mode::full}) {
                render::RenderFrame frame = scene_kit::frame(rapidity, heading, forwards, 97, 55);
                frame.mode = mode;
                CAPTURE(rapidity, heading.x, heading.y, heading.z);
                CHECK(all_finite(renderer.picture(frame)));
            }
        }
    }
}

TEST_CASE("an empty scene and a single triangle are scenes") {
    const render::EglContext context;
    content::SceneDesc scene;
    const render::RenderFrame frame = scene_kit::frame(1.5, forwards, forwards, 64, 36);
    render::Renderer empty = renderer_of(scene, render::Method::automatic);
    CHECK(all_finite(empty.picture(frame)));
    CHECK(empty.statistics().triangles == 0);

    content::Mesh triangle = scene_kit::rectangle({0, 0, -5}, {50, 0, 0}, {0, 50, 0});
    triangle.indices.resize(3);
    scene_kit::add(scene, triangle, scene_kit::unlit({0.25, 0.5, 0.75}));
    render::Renderer one = renderer_of(scene, render::Method::automatic);
    const render::Picture picture = one.picture(frame);
    CHECK(all_finite(picture));
    // Lower left lies on the triangle; 1/512 is what 16-bit colours and half floats leave of 0.75.
    CHECK(glm::distance(scene_kit::colour_at(picture, 30, 20), glm::dvec3(0.25, 0.5, 0.75)) < 1.0 / 512.0);
}

TEST_CASE("layers hold what sim says") {
    const render::EglContext context;
    content::SceneDesc scene;
    scene_kit::add(scene, scene_kit::rectangle({0, 0, 40}, {1, 0, 0}, {0, 1, 0}), scene_kit::unlit({1, 1, 1}));
    const std::size_t wall =
        scene_kit::add(scene, scene_kit::rectangle({0, 0, -10}, {7, 0, 0}, {0, 5, 0}), scene_kit::unlit({1, 1, 1}));
    const render::Method method = GENERATE(render::Method::texture, render::Method::ray);
    render::Renderer renderer = renderer_of(scene, method);
    for (const double rapidity : {0.0, 0.5493, 1.4722, 2.6467}) {
        render::RenderFrame frame = scene_kit::frame(rapidity, forwards, forwards, 256, 144);
        frame.sharpness = 1.5; // of tiles: the nearest texel is then within half a pixel
        const auto layer = [&](render::Layer wanted) {
            frame.layer = wanted;
            return renderer.picture(frame);
        };
        const render::Picture doppler = layer(render::Layer::doppler);
        const render::Picture direction = layer(render::Layer::direction);
        const render::Picture distance = layer(render::Layer::distance);
        const render::Picture object = layer(render::Layer::object);
        // What the wall is, exactly: the ray through a point of the screen meets z = -10 within 7 x 5.
        const auto sees_wall = [&](double x, double y) {
            const glm::dvec3 n =
                sim::see(frame.eye.world_from_head, render::head_direction_from_pixel(frame.eye, x, y)).world_direction;
            return n.z < 0.0 && std::abs(n.x / n.z) <= 0.7 && std::abs(n.y / n.z) <= 0.5;
        };
        int wrong_edges = 0;
        for (int row = 0; row < 144; ++row) {
            for (int column = 0; column < 256; ++column) {
                const double x = column + 0.5;
                const double y = row + 0.5;
                const sim::SeenLight seen =
                    sim::see(frame.eye.world_from_head, render::head_direction_from_pixel(frame.eye, x, y));
                const double d = scene_kit::value_at(doppler, column, row);
                REQUIRE(std::abs(d / seen.wavelength_ratio - 1.0) < 1e-5); // single precision
                REQUIRE(glm::distance(scene_kit::colour_at(direction, column, row), seen.world_direction) < 1e-5);
                const bool found = scene_kit::value_at(object, column, row) == static_cast<double>(wall);
                bool possible = false;
                for (const glm::dvec2& aside : {glm::dvec2(0, 0), glm::dvec2(0.5, 0), glm::dvec2(-0.5, 0),
                                                glm::dvec2(0, 0.5), glm::dvec2(0, -0.5)}) {
                    possible = possible || sees_wall(x + aside.x, y + aside.y) == found;
                }
                wrong_edges += possible ? 0 : 1;
                const double metres = scene_kit::value_at(distance, column, row);
                REQUIRE(found == std::isfinite(metres));
                if (found) {
                    // The nearest texel is up to half a pixel off, 1/D larger in the world, and distance to a wall
                    // changes by the tangent of the angle it is met at, here up to 0.86.
                    const double half_pixel = 0.5 / 128.0 / seen.wavelength_ratio;
                    CHECK(std::abs(metres * -seen.world_direction.z / 10.0 - 1.0) < 0.86 * half_pixel);
                }
            }
        }
        CAPTURE(rapidity);
        CHECK(wrong_edges == 0); // edges of straight things stand within half a pixel of where they should
    }
}

TEST_CASE("automatic is by rays on software OpenGL, and shows what the texture method shows") {
    const render::EglContext context;
    render::Renderer automatic = renderer_of(room(), render::Method::automatic);
    render::Renderer texture = renderer_of(room(), render::Method::texture);
    const render::RenderFrame frame = scene_kit::frame(1.2, forwards, {0.6, 0.0, -0.8}, 320, 180);
    const render::Picture a = automatic.picture(frame);
    const render::Picture b = texture.picture(frame);
    CHECK(automatic.statistics().method == (render::software_opengl() ? render::Method::ray : render::Method::texture));
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        sum += std::abs(static_cast<double>(a.values[i] - b.values[i]));
    }
    // As between plain and texture: edges are filtered differently, and shadows' edges are exact by rays.
    CHECK(sum / static_cast<double>(a.values.size()) < 0.005);
}

TEST_CASE("statistics tell what was drawn") {
    const render::EglContext context;
    render::Renderer renderer = renderer_of(room(), render::Method::texture);
    render::RenderFrame frame = scene_kit::frame(2.0, forwards, forwards, 320, 180);
    frame.sharpness = 0.5;
    renderer.picture(frame);
    const render::FrameStatistics half = renderer.statistics();
    frame.sharpness = 1.0;
    renderer.picture(frame);
    const render::FrameStatistics full = renderer.statistics();
    CHECK(half.sharpness == 0.5);
    CHECK(full.sharpness == 1.0);
    CHECK(full.triangles > 0);
    CHECK(full.tiles >= half.tiles);
    CHECK(half.texels_per_pixel < 0.6 * full.texels_per_pixel);
}
