#include "engine/cockpit/cockpit.h"
#include "engine/cockpit/cockpit_still.h"
#include "render/gl/egl_context.h"
#include "sim/look.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <numbers>

using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

/// Nothing but a sky of radiance 1 everywhere.
content::SceneDesc even_sky() {
    content::SceneDesc scene;
    scene.gradient_sky = {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f)};
    return scene;
}

render::RenderFrame frame(double beta, int width, int height) {
    render::RenderFrame frame;
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)), {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0});
    frame.eye.width = width;
    frame.eye.height = height;
    frame.mode = render::Mode::searchlight; // D^-4, colours as at rest: closed forms for each channel
    return frame;
}

content::Image grey_picture(int width, int height) {
    content::Image image;
    image.width = width;
    image.height = height;
    image.rgba.resize(static_cast<std::size_t>(4 * width * height), 200);
    for (std::size_t i = 1; i < image.rgba.size(); i += 4) {
        image.rgba[i] = 17; // a colour that no grey surface has
    }
    return image;
}

bool is_left(const content::Image& image, int column, int row) {
    const std::size_t at = 4 * static_cast<std::size_t>(row * image.width + column);
    return image.rgba[at] == 200 && image.rgba[at + 1] == 17;
}

} // namespace

TEST_CASE("the light gathered around the ship is the closed form's under an even sky") {
    const render::EglContext context;
    for (const render::Method method : {render::Method::ray, render::Method::texture}) {
        render::Renderer renderer(even_sky(), {method});
        for (const double beta : {0.0, 0.5, 0.9}) {
            const render::RenderFrame eye = frame(beta, 64, 36);
            const sim::BoostAndRotation ship = sim::split(eye.eye.world_from_head);
            engine::SceneryLight light;
            light.look_around(renderer, eye, ship, -4.0);
            glm::dvec3 all(0.0);
            const render::LightFromAround around = light.in_vehicle(ship);
            for (const glm::vec3& power : around.power()) {
                all += glm::dvec3(power);
            }
            // All that comes in: the integral of (gamma (1 - beta mu))^-4 over the sphere, 4 pi gamma^2 (1 + beta^2 /
            // 3).
            const double gamma2 = 1.0 / (1.0 - beta * beta);
            CAPTURE(beta, static_cast<int>(method));
            CHECK_THAT(all.x, WithinRel(4.0 * pi * gamma2 * (1.0 + beta * beta / 3.0), 0.01)); // half floats, 16 pixels
            CHECK_THAT(all.z, WithinRel(all.x, 0.01));
        }
    }
}

TEST_CASE("the cabin is where a pinhole puts it, at rest and at 0.9 c alike") {
    constexpr int width = 320;
    constexpr int height = 180;
    content::Image at_rest = grey_picture(width, height);
    content::Image at_speed = at_rest;
    engine::draw_cockpit_over(at_rest, even_sky(), frame(0.0, width, height), 0.0);
    engine::draw_cockpit_over(at_speed, even_sky(), frame(0.9, width, height), -4.0);
    int covered = 0;
    int different = 0;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            covered += is_left(at_rest, column, row) ? 0 : 1;
            different += is_left(at_rest, column, row) != is_left(at_speed, column, row) ? 1 : 0;
        }
    }
    CHECK(different == 0);
    CHECK(covered > width * height / 8);
    CHECK(covered < width * height / 2);
    CHECK(is_left(at_rest, width / 2, height / 3)); // the view ahead is free
}
