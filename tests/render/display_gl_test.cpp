#include "render/colour/display.h"
#include "render/gl/display_pass.h"
#include "render/gl/egl_context.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

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
    const render::DisplayPass display;
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

TEST_CASE("the display pass shows what display_bytes says, curve and gamut included") {
    const render::EglContext context;
    const std::vector<glm::vec3> colours{
        {0.1f, 0.5f, 0.9f}, {3.0f, 1.0f, 0.2f}, {2.0f, -0.3f, 0.1f}, {40.0f, 80.0f, 90.0f}};
    std::vector<float> light;
    for (const glm::vec3& colour : colours) {
        light.insert(light.end(), {colour.r, colour.g, colour.b, 1.0f});
    }
    const render::Texture picture = half_float_picture(4, 1, light);
    const Target target(4, 1);
    const render::DisplayPass display;
    render::RenderFrame frame;
    frame.eye.width = 4;
    frame.eye.height = 1;
    frame.exposure.linear_curve = false;
    display.draw(frame, picture.name(), 0.5, target.framebuffer.name(), {0, 0, 4, 1});
    std::vector<std::uint8_t> bytes(16);
    glGetTextureImage(target.texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, 16, bytes.data());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto expected = render::display_bytes(0.5f * colours[i], false);
        for (std::size_t j = 0; j < 3; ++j) {
            CHECK(std::abs(bytes[4 * i + j] - expected[j]) <= 1); // half floats and rounding
        }
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
    CHECK_THAT(display.pre_exposure(frame.exposure, 1.0), WithinRel(0.12, 1e-3));
    frame.exposure = {false, 2.0f, true};
    CHECK_THAT(display.factor(frame, picture.name(), 4.0), WithinRel(4.0, 1e-12));
}
