#include "render/gl/display_pass.h"
#include "render/gl/egl_context.h"
#include "render/gl/ray_pass.h"
#include "render/gl/renderer.h"
#include "render/shown_picture.h"
#include "scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

using Catch::Matchers::WithinRel;

namespace {

const glm::dvec3 forwards(0.0, 0.0, -1.0);

/// Coloured spheres before the sky, a lamp, and stars: colours in and out of sRGB for a moving eye.
content::SceneDesc outdoors() {
    content::SceneDesc scene;
    scene.ambient = glm::vec3(0.4f, 0.45f, 0.5f);
    scene.sun.emplace();
    scene.sun->direction = glm::normalize(glm::vec3(0.3f, 0.8f, 0.5f));
    for (int i = 0; i < 12; ++i) {
        const double angle = 0.5 + i * 0.5236;
        const glm::vec3 at(glm::dvec3(8.0 * std::sin(angle), 0.0, 8.0 * std::cos(angle)));
        const auto share = static_cast<float>(i) / 12.0f;
        scene_kit::add(scene, scene_kit::sphere(at, 1.7f, 24), scene_kit::matte({share, 0.9f - 0.8f * share, 0.05f}));
    }
    content::Star star;
    star.position = {0.0, 2.0, -10.0};
    star.visual_magnitude = -12.0f; // within half floats with glare around it
    scene.stars.push_back(star);
    return scene;
}

class Target {
  public:
    Target(int width, int height) : width_(width), height_(height), target_(GL_RGBA8, GL_NEAREST, false) {
        target_.resize({width, height});
    }
    GLuint framebuffer() const { return target_.framebuffer(); }
    std::vector<std::uint8_t> bytes() const {
        std::vector<std::uint8_t> read(static_cast<std::size_t>(4 * width_ * height_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.framebuffer());
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
        return read;
    }

  private:
    int width_;
    int height_;
    render::RenderTarget target_;
};

int largest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    REQUIRE(a.size() == b.size());
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

struct Cast {
    explicit Cast(const content::SceneDesc& scene, const render::RenderFrame& frame, double pre_exposure)
        : colour(scene), rays(scene, colour), light(GL_RGBA16F, GL_NEAREST, false) {
        rays.cast(frame, pre_exposure, nullptr, false);
        rays.add_stars(frame, pre_exposure, nullptr);
        light.resize({frame.eye.width, frame.eye.height});
        rays.load(light);
    }
    render::SceneColour colour;
    render::RayPass rays;
    render::RenderTarget light;
};

} // namespace

TEST_CASE("the processor shows rays' light as the display pass does, and meters it alike") {
    const render::EglContext context;
    const glm::dvec3 look = GENERATE(forwards, -forwards, glm::dvec3(1.0, 0.0, 0.0));
    render::RenderFrame frame = scene_kit::frame(1.2, forwards, look, 150, 83);
    Cast cast(outdoors(), frame, 0.8);
    render::DisplayPass display;
    const Target by_processor(160, 100);
    const Target by_display(160, 100);
    for (const bool linear : {false, true}) {
        frame.exposure.linear_curve = linear;
        frame.display.brightest = linear ? 1.0f : 0.6f;
        frame.display.bloom = 0.0f;
        cast.rays.show(frame, 1.5, by_processor.framebuffer(), {4, 7, 150, 83});
        display.draw(frame, cast.light.colour(), 1.5, by_display.framebuffer(), {4, 7, 150, 83});
        CAPTURE(linear);
        CHECK(largest_difference(by_processor.bytes(), by_display.bytes()) <= 1); // half floats
        frame.display.bloom = 0.3f;
        cast.rays.show(frame, 1.5, by_processor.framebuffer(), {4, 7, 150, 83});
        display.draw(frame, cast.light.colour(), 1.5, by_display.framebuffer(), {4, 7, 150, 83});
        CHECK(largest_difference(by_processor.bytes(), by_display.bytes()) <= 2); // in every level of the pyramid
    }
    frame.exposure = {true, 0.0f, false};
    const double by_meter = display.factor(frame, cast.light.colour(), 0.8);
    render::DisplayPass other;
    CHECK_THAT(other.factor(frame, cast.rays.metered(0.8)), WithinRel(by_meter, 1e-3)); // half floats
}

TEST_CASE("a finished picture is shown the right way up whatever its bytes' layout") {
    const render::EglContext context;
    const render::LightPackets packets = [] {
        render::LightPackets made;
        made.resize(24, 12);
        for (std::size_t i = 0; i < made.light.size(); ++i) {
            made.light[i].x.values.fill(0.05f * static_cast<float>(i));
            made.light[i].z.values.fill(0.5f - 0.02f * static_cast<float>(i));
        }
        return made;
    }();
    const Target target(40, 30);
    std::vector<std::vector<std::uint8_t>> shown;
    for (const render::ByteLayout& layout : {render::ByteLayout{}, render::ByteLayout{true, true}}) {
        render::PacketDisplay display;
        render::BytePicture picture;
        for (const glm::ivec2& size : {glm::ivec2(24, 12), glm::ivec2(31, 22)}) {
            picture.show(display.show(packets, {}, size, layout), layout, target.framebuffer(), {5, 3, size.x, size.y});
        }
        shown.push_back(target.bytes());
    }
    CHECK(shown[0] == shown[1]);
    const std::size_t corner = 4 * (3 * 40 + 5); // the packet of 0, no red; the last one is far redder
    CHECK(shown[0][corner] < 2);
    CHECK(shown[0][4 * (24 * 40 + 35)] > 200);
    CHECK(render::BytePicture::layout_for(0).from_top);
    CHECK_FALSE(render::BytePicture::layout_for(target.framebuffer()).from_top);
}

TEST_CASE("a picture drawn by rays is what shown_picture says, byte by byte") {
    const render::EglContext context;
    render::RendererSettings settings;
    settings.method = render::Method::ray;
    render::Renderer renderer(outdoors(), settings);
    render::RenderFrame frame = scene_kit::frame(1.0, forwards, {0.6, 0.0, -0.8}, 150, 83);
    frame.exposure = {false, 0.4f, false};
    const Target target(150, 83);
    renderer.draw(frame, target.framebuffer(), {0, 0, 150, 83});
    const std::vector<std::uint8_t> shown = target.bytes();
    const render::Picture light = renderer.picture(frame); // exposed already
    const content::Image expected = render::shown_picture(light, frame, 0.0);
    int different = 0;
    for (int row = 0; row < 83; ++row) {
        for (int i = 0; i < 4 * 150; ++i) {
            const int difference = shown[static_cast<std::size_t>(4 * 150 * (82 - row) + i)] -
                                   expected.rgba[static_cast<std::size_t>(4 * 150 * row + i)];
            REQUIRE(std::abs(difference) <= 1);
            different += difference != 0 ? 1 : 0;
        }
    }
    // The factor is multiplied in at another place: a rounding decides here and there.
    CHECK(different <= 4);
}

TEST_CASE("rays' pictures are scaled to their viewport, and false colours are shown of them") {
    const render::EglContext context;
    const render::RenderFrame plain = scene_kit::frame(0.8, forwards, {0.6, 0.0, -0.8}, 160, 90);
    Cast cast(outdoors(), plain, 1.0);
    render::DisplayPass display;
    const Target by_processor(320, 180);
    const Target by_display(320, 180);
    cast.rays.show(plain, 1.0, by_processor.framebuffer(), {0, 0, 320, 180});
    display.draw(plain, cast.light.colour(), 1.0, by_display.framebuffer(), {0, 0, 320, 180});
    const std::vector<std::uint8_t> a = by_processor.bytes();
    const std::vector<std::uint8_t> b = by_display.bytes();
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::abs(a[i] - b[i]);
    }
    // Bytes are interpolated instead of light: that differs at edges alone, by a fraction of what they part.
    CHECK(sum / static_cast<double>(a.size()) < 1.0);

    render::RendererSettings settings;
    settings.method = render::Method::ray;
    render::Renderer renderer(outdoors(), settings);
    const Target small(160, 90);
    for (const bool iso_lines : {false, true}) {
        render::RenderFrame frame = plain;
        frame.display.view = iso_lines ? render::View::natural : render::View::luminance;
        frame.display.iso_lines = iso_lines;
        REQUIRE_FALSE(render::RayPass::shows(frame.display));
        renderer.draw(frame, by_processor.framebuffer(), {0, 0, 160, 90});
        display.draw(frame, cast.light.colour(), 1.0, small.framebuffer(), {0, 0, 160, 90});
        std::vector<std::uint8_t> corner;
        const std::vector<std::uint8_t> all = by_processor.bytes();
        for (std::size_t row = 0; row < 90; ++row) {
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(4 * 320 * row);
            corner.insert(corner.end(), first, first + 4 * 160);
        }
        CAPTURE(iso_lines);
        CHECK(largest_difference(corner, small.bytes()) == 0); // the same pass over the same light
    }
}
