#include "render/colour/display.h"
#include "render/colour/false_colour_scale.h"
#include "render/gl/display_pass.h"
#include "render/gl/egl_context.h"
#include "render/shown_picture.h"
#include "scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using Catch::Matchers::WithinRel;

namespace {

render::Texture half_float_picture(int width, int height, const std::vector<float>& rgba) {
    render::Texture texture = render::Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(texture.name(), 1, GL_RGBA16F, width, height);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
    return texture;
}

struct Target {
    Target(int width, int height)
        : texture(render::Texture::create(GLenum{GL_TEXTURE_2D})), framebuffer(render::Framebuffer::create()) {
        glTextureStorage2D(texture.name(), 1, GL_RGBA8, width, height);
        glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, texture.name(), 0);
    }
    render::Texture texture;
    render::Framebuffer framebuffer;
};

/// Whether single precision may put the middle of a pixel on either side of an edge between two rings: log2 D is of
/// size 2 and rounded some twenty times on the way.
bool at_ring_edge(const render::RenderFrame& frame, int column, int row) {
    constexpr double rounding = 1e-5;
    const sim::Direction<sim::Head> direction = render::head_direction_from_pixel(frame.eye, column + 0.5, row + 0.5);
    const double level = std::log2(sim::see(frame.eye.world_from_head, direction).wavelength_ratio);
    const double step = render::shift_scale(sim::split(frame.eye.world_from_head).xi).step;
    return std::abs(level / step - std::round(level / step)) * step < rounding;
}

} // namespace

TEST_CASE("every sRGB byte comes out of the display pass as it went in") {
    const render::EglContext context;
    std::vector<float> light;
    for (int byte = 0; byte < 256; ++byte) {
        const float linear = render::linear_from_srgb(static_cast<float>(byte) / 255.0f);
        light.insert(light.end(), {linear, linear, linear, 1.0f});
    }
    const render::Texture picture = half_float_picture(16, 16, light);
    const Target target(16, 16);
    render::DisplayPass display;
    render::RenderFrame frame;
    frame.eye.width = 16;
    frame.eye.height = 16;
    display.draw(frame, picture.name(), 1.0, target.framebuffer.name(), {0, 0, 16, 16});
    std::vector<std::uint8_t> bytes(4 * 256);
    glGetTextureImage(target.texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, 4 * 256, bytes.data());
    for (int byte = 0; byte < 256; ++byte) {
        // Half floats carry 11 bits: a quarter of a byte's step at most.
        CHECK(std::abs(static_cast<int>(bytes[static_cast<std::size_t>(4 * byte)]) - byte) <= 1);
    }
}

TEST_CASE("the display pass shows what the CPU says, curve and gamut included") {
    const render::EglContext context;
    const std::vector<glm::vec3> colours{
        {0.1f, 0.5f, 0.9f}, {3.0f, 1.0f, 0.2f}, {2.0f, -0.3f, 0.1f}, {40.0f, 80.0f, 90.0f}};
    std::vector<float> light;
    for (const glm::vec3& colour : colours) {
        light.insert(light.end(), {colour.r, colour.g, colour.b, 1.0f});
    }
    const render::Texture picture = half_float_picture(4, 1, light);
    const Target target(4, 1);
    render::DisplayPass display;
    render::RenderFrame frame;
    frame.eye.width = 4;
    frame.eye.height = 1;
    frame.exposure.linear_curve = false;
    for (const float brightest : {1.0f, 0.3f}) {
        frame.display.brightest = brightest;
        display.draw(frame, picture.name(), 0.5, target.framebuffer.name(), {0, 0, 4, 1});
        std::vector<std::uint8_t> bytes(16);
        glGetTextureImage(target.texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, 16, bytes.data());
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const glm::vec3 shown =
                render::display_colour(0.5f * colours[i], false, render::Primaries::srgb, brightest);
            const auto expected = render::display_bytes(shown, {static_cast<int>(i), 0}, true);
            for (std::size_t j = 0; j < 3; ++j) {
                CHECK(std::abs(bytes[4 * i + j] - expected[j]) <= 1); // half floats and rounding
            }
        }
    }
}

TEST_CASE("the display pass scatters light as the CPU does, at any size") {
    const render::EglContext context;
    for (const glm::ivec2& size : {glm::ivec2(64, 32), glm::ivec2(53, 37)}) {
        render::Picture picture{size.x, size.y, 3, {}};
        std::vector<float> light;
        for (int i = 0; i < size.x * size.y; ++i) {
            const bool lamp = i == size.x * (size.y / 2) + 3 || i % 97 == 0;
            const glm::vec3 rgb = lamp ? glm::vec3(40.0f, 20.0f, 8.0f) : glm::vec3(0.05f);
            light.insert(light.end(), {rgb.r, rgb.g, rgb.b, 1.0f});
        }
        for (int row = size.y - 1; row >= 0; --row) { // OpenGL's rows come from the bottom
            for (int column = 0; column < size.x; ++column) {
                const auto at = static_cast<std::size_t>(4 * (row * size.x + column));
                picture.values.insert(picture.values.end(), {light[at], light[at + 1], light[at + 2]});
            }
        }
        const render::Texture texture = half_float_picture(size.x, size.y, light);
        const Target target(size.x, size.y);
        render::DisplayPass display;
        render::RenderFrame frame;
        frame.eye.width = size.x;
        frame.eye.height = size.y;
        frame.display.bloom = 0.3f;
        display.draw(frame, texture.name(), 1.0, target.framebuffer.name(), {0, 0, size.x, size.y});
        std::vector<std::uint8_t> bytes(light.size());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(target.texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()),
                          bytes.data());
        const content::Image expected = render::shown_picture(picture, frame, 0.0);
        int largest = 0;
        for (int row = 0; row < size.y; ++row) {
            for (int i = 0; i < 4 * size.x; ++i) {
                const auto shown = static_cast<std::size_t>(4 * size.x * (size.y - 1 - row) + i);
                const auto wanted = static_cast<std::size_t>(4 * size.x * row + i);
                largest = std::max(largest, std::abs(bytes[shown] - expected.rgba[wanted]));
            }
        }
        CHECK(largest <= 2); // half floats in every level of the pyramid, then the dither's step
    }
}

TEST_CASE("the display pass draws false colours and iso-lines where the CPU does") {
    const render::EglContext context;
    constexpr int width = 96;
    constexpr int height = 54;
    std::vector<float> light;
    render::Picture picture{width, height, 3, {}};
    for (int i = 0; i < width * height; ++i) {
        // The same in every row; as half floats keep it, so that both sides are given the same light.
        const float brightness =
            glm::unpackHalf1x16(glm::packHalf1x16(std::exp2(static_cast<float>(i % width) / 8.0f - 9.0f)));
        light.insert(light.end(), {brightness, brightness, brightness, 1.0f});
        picture.values.insert(picture.values.end(), {brightness, brightness, brightness});
    }
    const render::Texture texture = half_float_picture(width, height, light);
    const Target target(width, height);
    render::DisplayPass display;
    render::RenderFrame frame =
        scene_kit::frame(1.5, glm::normalize(glm::dvec3(0.3, 0.2, -1.0)), {0.0, 0.0, -1.0}, width, height);
    frame.display.iso_lines = true;
    for (const render::View view :
         {render::View::natural, render::View::doppler, render::View::rings, render::View::luminance}) {
        frame.display.view = view;
        display.draw(frame, texture.name(), 1.0, target.framebuffer.name(), {0, 0, width, height});
        std::vector<std::uint8_t> bytes(light.size());
        glGetTextureImage(target.texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()),
                          bytes.data());
        const content::Image expected = render::shown_picture(picture, frame, 0.0);
        int largest = 0;
        int undecided = 0;
        for (int row = 0; row < height; ++row) {
            for (int i = 0; i < 4 * width; ++i) {
                if (view == render::View::rings && at_ring_edge(frame, i / 4, row)) {
                    ++undecided;
                    continue;
                }
                const auto shown = static_cast<std::size_t>(4 * width * (height - 1 - row) + i);
                const auto wanted = static_cast<std::size_t>(4 * width * row + i);
                largest = std::max(largest, std::abs(bytes[shown] - expected.rgba[wanted]));
            }
        }
        CAPTURE(static_cast<int>(view));
        // Lines and colours without steps: single precision's 1e-5 of a pixel is nothing, but for the dither's step.
        CHECK(largest <= 1);
        CHECK(undecided <= 4 * 4); // two in ten thousand of some 500 pixels that edges of rings pass through
    }
}

TEST_CASE("automatic exposure reads the picture it is given") {
    const render::EglContext context;
    std::vector<float> light;
    for (int i = 0; i < 64 * 32; ++i) {
        light.insert(light.end(), {3.0f, 3.0f, 3.0f, 1.0f});
    }
    const render::Texture picture = half_float_picture(64, 32, light);
    render::DisplayPass display;
    render::RenderFrame frame;
    frame.eye.width = 64;
    frame.eye.height = 32;
    frame.exposure.automatic = true;
    // Rendered with pre-exposure 2, so the radiance is 1.5: middle grey is 0.18. Luminance weights are 4 digits.
    CHECK_THAT(display.factor(frame, picture.name(), 2.0), WithinRel(0.12, 1e-3));
    CHECK_THAT(display.pre_exposure(frame, 1.0), WithinRel(0.12, 1e-3));
    frame.pane = 1; // another pane has not adapted yet
    CHECK_THAT(display.pre_exposure(frame, 1.0), WithinRel(0.25, 1e-6));
    frame.pane = 0;
    frame.exposure = {false, 2.0f, true};
    CHECK_THAT(display.factor(frame, picture.name(), 4.0), WithinRel(4.0, 1e-12));
}
