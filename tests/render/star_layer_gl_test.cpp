#include "render/colour/star_photometry.h"
#include "render/gl/egl_context.h"
#include "render/gl/star_layer.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr int width = 160;
constexpr int height = 90;

/// Light seen and where its centre lies, from a float target whose alpha (sky visibility) is set.
struct SeenStars {
    glm::dvec3 irradiance{0.0}; ///< sum of radiance times solid angle of a pixel at the screen's centre
    glm::dvec2 centre{0.0};     ///< window coordinates, weighted by green
};

SeenStars see_stars(const content::SceneDesc& scene, const render::RenderFrame& frame, float sky_visibility,
                    render::StarLayer::Way way) {
    const render::DopplerColour colour(5762.0);
    render::StarLayer layer(scene, colour, way);
    const render::Texture texture = render::Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(texture.name(), 1, GL_RGBA32F, width, height);
    const render::Framebuffer framebuffer = render::Framebuffer::create();
    glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, texture.name(), 0);
    const std::array<float, 4> background{0.0f, 0.0f, 0.0f, sky_visibility};
    glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, background.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    layer.draw(frame, sim::split(frame.eye.world_from_head), 1.0);
    std::vector<float> pixels(std::size_t{4} * width * height);
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)),
                      pixels.data());
    const double pixel = 2.0 * std::tan(0.5 * frame.eye.horizontal_field_of_view) / width;
    SeenStars seen;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float* rgba = &pixels[static_cast<std::size_t>(4 * (y * width + x))];
            REQUIRE(rgba[3] == sky_visibility);
            const glm::dvec3 light(rgba[0], rgba[1], rgba[2]);
            seen.irradiance += pixel * pixel * light;
            seen.centre += light.g * glm::dvec2(x + 0.5, y + 0.5);
        }
    }
    seen.centre *= pixel * pixel / seen.irradiance.g;
    return seen;
}

content::SceneDesc one_star() {
    content::SceneDesc scene;
    content::Star star;
    star.position = {0.0, 0.0, -10.0};
    star.visual_magnitude = 1.0f;
    star.temperature = 6500.0f;
    scene.stars.push_back(star);
    return scene;
}

render::RenderFrame frame_of(double rapidity) {
    render::RenderFrame frame;
    frame.eye.width = width;
    frame.eye.height = height;
    frame.eye.horizontal_field_of_view = 1.0;
    frame.eye.world_from_head = sim::boost<sim::World, sim::Head>(sim::Rapidity(rapidity), glm::dvec3(0.0, 0.0, -1.0));
    frame.metres_per_light_year = 1.0;
    return frame;
}

} // namespace

TEST_CASE("a star's light on the screen is what photometry says, at rest and moving") {
    const render::EglContext context;
    const auto way = GENERATE(render::StarLayer::Way::points, render::StarLayer::Way::sheet);
    const render::DopplerColour colour(5762.0);
    const content::SceneDesc scene = one_star();
    for (const double rapidity : {0.0, 1.5, -1.0}) {
        for (const render::Mode mode :
             {render::Mode::geometry, render::Mode::doppler, render::Mode::searchlight, render::Mode::full}) {
            render::RenderFrame frame = frame_of(rapidity);
            frame.mode = mode;
            const SeenStars seen = see_stars(scene, frame, 1.0f, way);
            const glm::dvec3 expected = render::star_light(colour, render::star_source(colour, scene.stars[0]), mode,
                                                           10.0, std::exp(-rapidity));
            for (int i = 0; i < 3; ++i) {
                // Table of black bodies linear between steps of 1.1 % in T, logarithms in single precision.
                CHECK_THAT(seen.irradiance[i], WithinRel(expected[i], 2e-3));
            }
            CHECK_THAT(seen.centre.x, WithinAbs(0.5 * width, 1e-3)); // single precision of a projection
            CHECK_THAT(seen.centre.y, WithinAbs(0.5 * height, 1e-3));
        }
    }
}

TEST_CASE("a star keeps its light as it drifts across pixels, fades behind clouds, and shows parallax") {
    const render::EglContext context;
    const auto way = GENERATE(render::StarLayer::Way::points, render::StarLayer::Way::sheet);
    const content::SceneDesc scene = one_star();
    const SeenStars still = see_stars(scene, frame_of(0.0), 1.0f, way);
    render::RenderFrame frame = frame_of(0.0);
    const double pixels_per_light_year = 0.1 * 0.5 * width / std::tan(0.5);
    for (const double shift : {0.003, 0.011, 0.05, 0.5}) {
        frame.eye.position = {shift, 0.0, 0.0};
        const SeenStars moved = see_stars(scene, frame, 1.0f, way);
        CHECK_THAT(moved.centre.x, WithinAbs(0.5 * width - shift * pixels_per_light_year, 2e-3));
        // cos^3 off the axis and distance change by 4 (shift / 10)^2 at most, 1e-2 for the last.
        CHECK_THAT(moved.irradiance.g, WithinRel(still.irradiance.g, 1e-5 + 0.05 * shift * shift));
    }
    const SeenStars half_hidden = see_stars(scene, frame_of(0.0), 0.5f, way);
    CHECK_THAT(half_hidden.irradiance.g, WithinRel(0.5 * still.irradiance.g, 1e-6));
}

TEST_CASE("a star just outside the picture still lights its edge") {
    const render::EglContext context;
    const auto way = GENERATE(render::StarLayer::Way::points, render::StarLayer::Way::sheet);
    content::SceneDesc scene = one_star();
    const double edge = std::tan(0.5) * 10.0;
    scene.stars[0].position.x = edge * (1.0 + 2.0 / width); // one pixel beyond
    const SeenStars seen = see_stars(scene, frame_of(0.0), 1.0f, way);
    CHECK(seen.irradiance.g > 0.0);
    CHECK(seen.centre.x > width - 3.0);
}
