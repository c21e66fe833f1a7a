#include "engine/cockpit/cockpit.h"
#include "engine/cockpit/cockpit_still.h"
#include "engine/offscreen.h"
#include "render/cabin/comfort_pass.h"
#include "render/gl/egl_context.h"
#include "sim/look.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/common.hpp>

#include <algorithm>
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
        image.rgba[i] = 17;      // a colour that no grey surface has
        image.rgba[i + 2] = 255; // opaque, as what is read back
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
            const render::LightFromAround around = light.in_cabin(ship);
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
    engine::draw_cockpit_over(at_rest, even_sky(), frame(0.0, width, height), {}, 0.0);
    engine::draw_cockpit_over(at_speed, even_sky(), frame(0.9, width, height), {}, -4.0);
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

TEST_CASE("the screens are drawn where a pinhole puts their corners, for an asymmetric eye off the seat, too") {
    const render::EglContext context;
    const content::generator::Cabin cabin = content::generator::make_cabin();
    render::CabinPass pass(cabin);
    constexpr int width = 200;
    constexpr int height = 160;
    // A panel of one colour that no unlit cabin has: the cabin gets no light and is black.
    const std::vector<std::uint8_t> red{255, 0, 0, 255};
    const render::Texture panel = render::Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(panel.name(), 1, GL_RGBA8, 1, 1);
    glTextureSubImage2D(panel.name(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, red.data());
    for (const render::CabinView& view :
         {render::CabinView{{}, {1.0, 0.0, 0.0, 0.0}, {-1.0, 1.0, -0.8, 0.8}},
          render::CabinView{
              {0.03, -0.03, -0.05}, glm::angleAxis(-0.3, glm::dvec3(1.0, 0.0, 0.0)), {-1.1, 0.7, -0.6, 0.9}}}) {
        engine::Offscreen target(width, height);
        pass.draw(view, {}, panel.name(), target.framebuffer(), {0, 0, width, height});
        const content::Image image = target.read();
        const auto is_red = [&](const glm::dvec2& tangents) {
            const glm::dvec2 place = view.place_of(tangents);
            const int column = static_cast<int>(std::floor(place.x * width));
            const int row = height - 1 - static_cast<int>(std::floor(place.y * height));
            if (column < 0 || column >= width || row < 0 || row >= height) {
                FAIL("the screen is out of the picture");
            }
            const std::size_t at = 4 * static_cast<std::size_t>(row * width + column);
            return image.rgba[at] > 200 && image.rgba[at + 1] < 20;
        };
        const content::generator::PanelScreen& screen = cabin.screens[1];
        for (const double x : {-1.0, 1.0}) {
            for (const double y : {-1.0, 1.0}) {
                // A pixel and a half within the corner it shines; as far beyond is the bezel.
                const auto corner = [&](double share) {
                    return view.tangents_of(screen.centre + share * x * screen.right + share * y * screen.up);
                };
                const glm::dvec2 at = corner(1.0);
                const glm::dvec2 pixel(1.5 * (view.tangents.right - view.tangents.left) / width,
                                       1.5 * (view.tangents.up - view.tangents.down) / height);
                const glm::dvec2 outwards = glm::sign(at - corner(0.0)) * pixel;
                CHECK(is_red(at - outwards));
                CHECK_FALSE(is_red(at + outwards));
            }
        }
    }
}

TEST_CASE("comfort darkens a finished picture by its profile, and leaves it alone when it is off") {
    const render::EglContext context;
    render::ComfortPass comfort;
    constexpr int width = 64;
    constexpr int height = 48;
    const content::Image before = grey_picture(width, height);
    engine::Offscreen target(width, height);
    target.write(before);
    const render::ViewTangents tangents{-1.2, 0.8, -0.9, 0.9};
    comfort.draw(tangents, {}, target.framebuffer(), {0, 0, width, height});
    CHECK(target.read().rgba == before.rgba);
    comfort.draw(tangents, {1.0f, 0.25f}, target.framebuffer(), {0, 0, width, height});
    const content::Image after = target.read();
    int differ = 0;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double x = -1.2 + 2.0 * (column + 0.5) / width;
            const double y = 0.9 - 1.8 * (row + 0.5) / height;
            const double t = std::clamp((std::hypot(x, y) - 0.25) / 0.5, 0.0, 1.0); // the circles of full narrowing
            const double light = 0.75 * (1.0 - t * t * (3.0 - 2.0 * t));
            const std::size_t at = 4 * static_cast<std::size_t>(row * width + column);
            differ += std::abs(after.rgba[at] - light * 200.0) > 1.0 ? 1 : 0; // 8 bits
        }
    }
    CHECK(differ == 0);
}

TEST_CASE("what the panel is told by a pointer becomes the picture's settings") {
    const render::EglContext context;
    engine::PanelPicture panel(1.0F);
    engine::PictureSettings picture;
    engine::ComfortSettings comfort;
    const engine::HudModel model;
    // The first button of the right screen, points from the picture's upper left corner.
    const glm::dvec2 geometry_button((engine::PanelPicture::width - engine::PanelPicture::side_width + 44.0) /
                                         static_cast<double>(engine::PanelPicture::width),
                                     48.0 / static_cast<double>(engine::PanelPicture::height));
    const auto touch = [&](std::optional<glm::dvec2> at, bool pressed, bool locked) {
        panel.draw(model, picture, comfort, {at, pressed}, locked, 0.02);
    };
    for (int i = 0; i < 3; ++i) { // ImGui lays a window out in its first frames
        touch(geometry_button, false, false);
    }
    CHECK(panel.hears_pointer());
    CHECK(picture.mode == render::Mode::full);
    touch(geometry_button, true, true); // a demonstration hears nobody
    touch(geometry_button, false, true);
    CHECK(picture.mode == render::Mode::full);
    for (const bool pressed : {false, false, true, true, false, false}) {
        touch(geometry_button, pressed, false);
    }
    CHECK(picture.mode == render::Mode::geometry);
    touch(std::nullopt, false, false);
    touch(std::nullopt, false, false);
    CHECK_FALSE(panel.hears_pointer());
}
