#include "render/colour/bloom.h"
#include "render/colour/display.h"
#include "render/raycast/packet_display.h"
#include "render/raycast/packet_glare.h"
#include "render/raycast/packet_stars.h"
#include "render/shown_picture.h"
#include "scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

namespace lane_display_shader {
using namespace glm;
#include "render/shaders/shared/display.glsl"
} // namespace lane_display_shader

using Catch::Matchers::WithinRel;

namespace {

/// Packets whose pixel (x, y), from the lower left corner, is colour_at(x, y); the sky is to be seen nowhere.
template <class ColourAt>
render::LightPackets packets_of(int width, int height, const ColourAt& colour_at) {
    render::LightPackets packets;
    packets.resize(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 colour = colour_at(x, y);
            render::Lanes3& light = packets.light[packets.packet(x, y)];
            const int lane = 4 * (y % 4) + x % 4;
            light.x[lane] = colour.r;
            light.y[lane] = colour.g;
            light.z[lane] = colour.b;
        }
    }
    std::fill(packets.sky.begin(), packets.sky.end(), 0);
    return packets;
}

/// Colours inside sRGB and far outside, from black to far brighter than a display.
std::vector<glm::vec3> colours(std::size_t count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(0.0f, 1.0f);
    std::vector<glm::vec3> found{glm::vec3(0.0f),          glm::vec3(1.0f),   {1.0f, 0.0f, 0.0f},  {0.2f, -0.4f, 0.1f},
                                 {-0.1f, -0.2f, -1e-3f},   glm::vec3(1e6f),   {0.0f, 0.0f, 1e-8f}, {3e4f, -2.0f, 10.0f},
                                 glm::vec3(0.9999f, 1, 1), {0.5f, 0.5f, 0.0f}};
    while (found.size() < count) {
        const glm::vec3 colour(any(random), any(random), any(random));
        const float lowest = found.size() % 3 == 0 ? 0.4f : 0.0f; // every third colour may have negative components
        found.push_back(std::exp2(20.0f * any(random) - 12.0f) * (colour - lowest));
    }
    return found;
}

} // namespace

TEST_CASE("cube roots of the gamut map are those of the library") {
    CHECK(std::abs(lane_display_shader::cube_root(0.0f)) <= 1.1e-10f);
    double worst = 0.0;
    for (double x = 1e-30; x < 1e30; x *= 1.0371) {
        const auto size = static_cast<float>(x);
        const double exact = std::cbrt(static_cast<double>(size));
        worst = std::max(worst, std::abs(static_cast<double>(lane_display_shader::cube_root(size)) / exact - 1.0));
        CHECK(lane_display_shader::cube_root(-size) == -lane_display_shader::cube_root(size));
    }
    CHECK(worst < 3e-7); // five roundings of single precision
}

TEST_CASE("bytes shown of packets are those of single colours") {
    constexpr int width = 101; // packets at the right and at the top reach out of the picture
    constexpr int height = 59;
    const std::vector<glm::vec3> light = colours(std::size_t{width} * height);
    const render::LightPackets packets =
        packets_of(width, height, [&](int x, int y) { return light[static_cast<std::size_t>(y * width + x)]; });
    render::PacketDisplay display;
    for (const bool linear : {false, true}) {
        for (const float brightest : {1.0f, 0.35f}) {
            for (const bool dither : {false, true}) {
                const render::DisplaySettings settings{0.7f, linear, brightest, dither};
                const std::span<const std::uint32_t> shown = display.show(packets, settings, {width, height});
                REQUIRE(shown.size() == light.size());
                std::size_t different = 0;
                for (std::size_t i = 0; i < shown.size(); ++i) {
                    const glm::ivec2 pixel(static_cast<int>(i) % width, static_cast<int>(i) / width);
                    const auto expected = render::display_bytes(
                        render::display_colour(0.7f * light[i], linear, render::Primaries::srgb, brightest), pixel,
                        dither);
                    const std::uint32_t wanted = std::uint32_t{expected[0]} | std::uint32_t{expected[1]} << 8u |
                                                 std::uint32_t{expected[2]} << 16u |
                                                 0xff000000u; // as bytes lie in memory
                    different += shown[i] != wanted ? 1 : 0;
                }
                CAPTURE(linear, brightest, dither);
                CHECK(different == 0); // the same operations in the same order: the same bits
            }
        }
    }
}

TEST_CASE("bytes of packets lie as they are wanted") {
    const render::LightPackets packets = packets_of(21, 14, [](int x, int y) {
        return glm::vec3(0.04f * static_cast<float>(x), 0.06f * static_cast<float>(y), 0.3f);
    });
    for (const glm::ivec2& size : {glm::ivec2(21, 14), glm::ivec2(50, 33)}) {
        render::PacketDisplay plain;
        render::PacketDisplay other;
        const std::span<const std::uint32_t> red_first = plain.show(packets, {}, size);
        const std::span<const std::uint32_t> blue_first = other.show(packets, {}, size, {true, true});
        const auto width = static_cast<std::size_t>(size.x);
        for (std::size_t i = 0; i < red_first.size(); ++i) {
            const std::uint32_t upside_down = blue_first[red_first.size() - width - i + 2 * (i % width)];
            const std::uint32_t bytes = red_first[i];
            REQUIRE(upside_down == ((bytes & 0xff00ff00u) | (bytes & 0xffu) << 16u | ((bytes >> 16u) & 0xffu)));
        }
    }
}

TEST_CASE("scaled packets are encoded colours between those of their pixels") {
    const std::vector<glm::vec3> light = colours(std::size_t{37} * 22);
    const auto pixel = [&](int x, int y) { return light[static_cast<std::size_t>(37 * y + x)]; };
    const render::LightPackets packets = packets_of(37, 22, pixel);
    for (const glm::ivec2& size : {glm::ivec2(97, 60), glm::ivec2(37, 23), glm::ivec2(20, 9)}) {
        render::PacketDisplay display;
        const std::span<const std::uint32_t> shown = display.show(packets, {1.0f, false, 1.0f, true}, size);
        std::size_t different = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const double column = std::clamp((x + 0.5) * 37.0 / size.x - 0.5, 0.0, 36.0);
                const double row = std::clamp((y + 0.5) * 22.0 / size.y - 0.5, 0.0, 21.0);
                const auto encoded = [&](int right, int up) {
                    return glm::dvec3(render::display_colour(
                        pixel(std::min(static_cast<int>(column) + right, 36), std::min(static_cast<int>(row) + up, 21)),
                        false));
                };
                const double u = column - std::floor(column);
                const double v = row - std::floor(row);
                const glm::dvec3 between =
                    glm::mix(glm::mix(encoded(0, 0), encoded(1, 0), u), glm::mix(encoded(0, 1), encoded(1, 1), u), v);
                const auto expected = render::display_bytes(glm::vec3(between), {x, y}, true);
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::uint32_t found =
                        (shown[static_cast<std::size_t>(size.x * y + x)] >> (8u * static_cast<unsigned>(i))) & 0xffu;
                    const int difference = std::abs(static_cast<int>(found) - static_cast<int>(expected.at(i)));
                    REQUIRE(difference <= 1);
                    different += difference != 0 ? 1 : 0;
                }
            }
        }
        // A rounding of single precision, 1e-6 of a byte's 255 steps, decides here and there.
        CHECK(different <= 3 * shown.size() / 300);
    }
}

TEST_CASE("glare in packets is the glare of their picture") {
    for (const glm::ivec2& size : {glm::ivec2(3, 9), glm::ivec2(64, 32), glm::ivec2(53, 37)}) {
        const render::LightPackets packets = packets_of(size.x, size.y, [](int x, int y) {
            return (x * 7 + y * 31) % 61 == 5 ? glm::vec3(90.0f, 20.0f, 3.0f) : glm::vec3(0.1f, 0.2f, 0.3f);
        });
        render::LightPackets glaring;
        render::add_glare(packets, 0.4f, glaring);
        const render::Picture found = render::light_picture(glaring, 1.0f);
        const render::Picture expected = render::bloomed(render::light_picture(packets, 1.0f), 0.4f);
        REQUIRE(found.values.size() == expected.values.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < found.values.size(); ++i) {
            worst = std::max(worst, std::abs(static_cast<double>(found.values[i] / expected.values[i]) - 1.0));
        }
        CAPTURE(size.x, size.y);
        CHECK(worst < 1e-5); // upside down: other roundings in every level
    }
}

TEST_CASE("packets are metered by the squares of a picture") {
    const auto colour_at = [](int x, int y) {
        const auto across = static_cast<float>(x);
        const auto upwards = static_cast<float>(y);
        return glm::vec3(0.2f + 0.01f * across, 0.1f + 0.02f * upwards, x == 21 && y == 9 ? 50.0f : 0.3f);
    };
    const render::LightPackets packets = packets_of(64, 32, colour_at);
    const render::MeteredLight squares = render::metered(packets, 2.0);
    const render::MeteredLight of_picture = render::metered(render::light_picture(packets, 0.5f));
    REQUIRE(squares.mean.size() == 8 * 4);
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 8; ++column) {
            const std::size_t from_top = 8 * (3 - row) + column;
            // Sums in another order.
            CHECK_THAT(squares.mean[8 * row + column], WithinRel(of_picture.mean[from_top], 1e-6f));
            CHECK_THAT(squares.brightest[8 * row + column], WithinRel(of_picture.brightest[from_top], 1e-6f));
        }
    }
    // Whole squares only; of less than one, what there is. Below 0 is no light.
    CHECK(render::metered(packets_of(53, 37, colour_at), 1.0).mean.size() == 6 * 4);
    const render::MeteredLight small =
        render::metered(packets_of(4, 4, [](int, int) { return glm::vec3(0.25f); }), 1.0);
    REQUIRE(small.mean.size() == 1);
    CHECK_THAT(small.mean.front(), WithinRel(0.25f, 1e-6f));
    const render::MeteredLight dark = render::metered(packets_of(8, 8, [](int, int) { return glm::vec3(-1.0f); }), 1.0);
    CHECK(dark.mean.front() == 0.0f);
    CHECK(dark.brightest.front() == 0.0f);
}

TEST_CASE("stars shine in packets where the sky is to be seen, as bright as on their sheet") {
    content::SceneDesc scene;
    for (int i = 0; i < 200; ++i) {
        content::Star star;
        star.position = {std::sin(i * 2.4) * i * 0.05, std::cos(i * 1.7) * i * 0.03, -10.0};
        star.visual_magnitude = 0.02f * static_cast<float>(i);
        scene.stars.push_back(star);
    }
    const render::DopplerColour colour(5762.0);
    const render::StarSheet stars(scene, colour);
    render::RenderFrame frame = scene_kit::frame(0.4, {0, 0, -1}, {0, 0, -1}, 90, 50);
    frame.metres_per_light_year = 1.0;
    const auto grey = [](int, int) { return glm::vec3(0.5f); };
    render::LightPackets packets = packets_of(90, 50, grey);
    for (std::size_t i = 0; i < packets.sky.size(); ++i) {
        packets.sky[i] = i % 3 == 0 ? 0 : 0x5a5au; // lanes with an odd number of ones in their place among four
    }
    render::add_stars(stars, frame, 1e4, nullptr, packets);
    std::vector<glm::vec4> sheet;
    stars.draw(frame, 1e4, render::faintest_star_shown, sheet);
    const render::Picture seen = render::light_picture(packets, 1.0f);
    int lit = 0;
    for (int row = 0; row < 50; ++row) {
        for (int column = 0; column < 90; ++column) {
            const int y = 49 - row;
            const bool sky = render::has(packets.sky[packets.packet(column, y)], 4 * (y % 4) + column % 4);
            const glm::vec4 star = sheet[static_cast<std::size_t>(90 * row + column)];
            const double expected = 0.5 + (sky ? static_cast<double>(star.g) : 0.0);
            const double found =
                static_cast<double>(seen.values[static_cast<std::size_t>(3 * (90 * row + column) + 1)]);
            REQUIRE(std::abs(found / expected - 1.0) < 1e-6); // single precision, sums in another order
            lit += sky && star.g > 0.1f ? 1 : 0;
        }
    }
    CHECK(lit > 100);
}
