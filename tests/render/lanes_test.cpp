#include "render/cube_face.h"
#include "render/gl/software_opengl.h"
#include "render/offline/scenery_hits.h"
#include "render/panorama.h"
#include "render/raycast/sky_map.h"
#include "render/raycast/texture_pool.h"
#include "tests/render/scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <glm/gtc/packing.hpp>

#include <cmath>
#include <limits>
#include <random>

TEST_CASE("log2 for lanes is log2 to 2e-7") {
    // Over every exponent of normal floats; near 1 the error is absolute.
    for (int exponent = -126; exponent < 128; ++exponent) {
        for (int step = 0; step < 64; ++step) {
            const auto x = static_cast<float>(std::ldexp(1.0 + step / 64.0, exponent));
            const double exact = std::log2(static_cast<double>(x));
            CHECK(std::abs(static_cast<double>(render::log2_of_lane(x)) - exact) < 2e-7 + 1.2e-7 * std::abs(exact));
        }
    }
}

TEST_CASE("halves for lanes round to the nearest half, ties to even, denormal or not") {
    for (std::uint32_t bits = 0; bits < 0x7c00u; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        const float value = glm::unpackHalf1x16(half);
        CHECK(render::half_of_lane(value) == half);
        CHECK(render::half_of_lane(-value) == (half | 0x8000u));
        const float next = bits + 1 < 0x7c00u ? glm::unpackHalf1x16(static_cast<std::uint16_t>(half + 1)) : 65536.0f;
        const float middle = 0.5f * (value + next);
        if (middle < 65520.0f) {
            CHECK(render::half_of_lane(middle) == half + (half & 1u));
            CHECK(render::half_of_lane(std::nextafter(middle, 0.0f)) == half);
            CHECK(render::half_of_lane(std::nextafter(middle, 1e6f)) == half + 1);
        }
    }
}

TEST_CASE("a texture's levels are means of light, and it repeats") {
    content::Image image;
    image.width = 6;
    image.height = 3; // neither a power of two
    for (int i = 0; i < 18; ++i) {
        const std::uint8_t value = i % 2 == 0 ? 255 : 0;
        image.rgba.insert(image.rgba.end(), {value, 188, 255, static_cast<std::uint8_t>(10 * i)});
    }
    const render::TexturePool pool({image});
    const auto sample = [&](float u, float v, float level) {
        render::TextureLookUp look_up;
        std::array<render::Four, render::lane_count> colours;
        const int lane = 5;
        look_up.u[lane] = u;
        look_up.v[lane] = v;
        look_up.level[lane] = level;
        pool.sample(look_up, 1u << lane, colours);
        return colours[lane];
    };
    const render::Four first = sample(0.5f / 6.0f, 0.5f / 3.0f, 0.0f);
    const render::Four second = sample(1.5f / 6.0f - 7.0f, 0.5f / 3.0f + 3.0f, -5.0f);
    CHECK(std::abs(first[0] - 1.0f) < 1e-5f);
    CHECK(std::abs(second[0]) < 1e-5f);
    const render::Four between = sample(1.0f / 6.0f, 0.5f / 3.0f, 0.0f);
    CHECK(std::abs(between[0] - 0.5f) < 1e-5f);
    CHECK(std::abs(between[1] - 0.5028865f) < 2e-5f); // 188 / 255 decoded
    const render::Four mean = sample(0.3f, 0.7f, 20.0f);
    CHECK(std::abs(mean[0] - 0.5f) < 1e-4f);                   // rounding of two levels
    CHECK(std::abs(mean[3] - 85.0f / 255.0f) < 1e-4f);         // the mean of 0, 10 ... 170
    const render::Four edge = sample(0.0f, 0.5f / 3.0f, 0.0f); // between the last column and the first
    CHECK(std::abs(edge[0] - 0.5f) < 1e-5f);
}

TEST_CASE("a sky map is its panorama, without seams at any level") {
    content::Panorama panorama;
    panorama.width = 512;
    panorama.height = 256;
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 512; ++x) {
            const double colatitude = (y + 0.5) / 256.0 * std::numbers::pi;
            const double longitude = (x + 0.5) / 256.0 * std::numbers::pi;
            const auto up = static_cast<float>(std::cos(colatitude));
            const auto across = static_cast<float>(std::sin(colatitude) * std::sin(longitude));
            panorama.radiance.emplace_back(1.0f + 0.5f * up, 1.0f + 0.5f * across, 3.0f);
        }
    }
    const render::SkyMap sky(panorama);
    std::mt19937 random(5);
    std::normal_distribution<double> component;
    for (int i = 0; i < 2000; ++i) {
        glm::dvec3 direction = glm::normalize(glm::dvec3(component(random), component(random), component(random)));
        if (i % 2 == 0) { // on an edge of the cube
            direction = glm::normalize(glm::dvec3(direction.x, std::copysign(direction.x, direction.y), direction.z));
        }
        const glm::dvec3 exact = render::panorama_radiance(panorama, direction);
        // Bilinear twice over texels of 0.6 degrees: their squares times the curvature; and 16 bits.
        const glm::dvec3 sharp(sky.radiance(glm::vec3(direction), 0.0f));
        CHECK(glm::distance(glm::dvec2(sharp), glm::dvec2(exact)) < 2e-3);
        CHECK(std::abs(sharp.b - 3.0) < 5e-5);
        // Level 3 averages over 4.5 degrees, whose curvature is 60 times as large.
        CHECK(glm::distance(glm::dvec2(sky.radiance(glm::vec3(direction), 3.0f)), glm::dvec2(exact)) < 0.03);
    }
}

TEST_CASE("a packet's rays hit what single rays hit") {
    content::SceneDesc scene;
    content::Material one_sided = scene_kit::matte(glm::vec3(1.0f));
    scene_kit::add(scene, scene_kit::sphere({0, 0, -6}, 2.0f, 24), one_sided);
    scene_kit::add(scene, scene_kit::rectangle({0, 0, -3}, {1, 0, 0}, {0, -1, 0}), one_sided); // its back to the eye
    scene_kit::add(scene, scene_kit::sphere({2, 1, -9}, 2.0f, 24), scene_kit::unlit(glm::vec3(1.0f)));
    const render::SceneryHits scenery(scene);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> tangent(-0.6f, 0.6f);
    const glm::vec3 origin(0.1f, 0.2f, 0.3f);
    int found = 0;
    for (int round = 0; round < 200; ++round) {
        render::Lanes3 directions;
        for (int i = 0; i < render::lane_count; ++i) {
            const glm::vec3 direction = glm::normalize(glm::vec3(tangent(random), tangent(random), -1.0f));
            directions.x[i] = direction.x;
            directions.y[i] = direction.y;
            directions.z[i] = direction.z;
        }
        render::PacketHits hits;
        scenery.first(origin, directions, hits);
        for (int i = 0; i < render::lane_count; ++i) {
            const glm::dvec3 direction(directions.x[i], directions.y[i], directions.z[i]);
            const auto single = scenery.first(glm::dvec3(origin), direction);
            REQUIRE(single.has_value() == (hits.instance[i] != render::PacketHits::nothing));
            if (!single) {
                CHECK(std::isinf(hits.distance[i]));
                continue;
            }
            ++found;
            CHECK(single->instance == hits.instance[i]);
            CHECK(std::abs(static_cast<double>(hits.distance[i]) / single->distance - 1.0) < 2e-6);
            const glm::dvec3 towards(0.3, 0.9, 0.3);
            render::Lanes3 origins;
            const glm::dvec3 start = single->position + 1e-3 * single->facing;
            origins.x[i] = static_cast<float>(start.x);
            origins.y[i] = static_cast<float>(start.y);
            origins.z[i] = static_cast<float>(start.z);
            const render::LaneMask lane = 1u << static_cast<unsigned>(i);
            CHECK((scenery.blocked(origins, glm::vec3(towards), lane) != 0) == scenery.blocked(start, towards));
        }
    }
    CHECK(found > 500);
}

TEST_CASE("software OpenGL is known by its name") {
    CHECK(render::is_software_opengl("llvmpipe (LLVM 15.0.6, 256 bits)"));
    CHECK(render::is_software_opengl("softpipe"));
    CHECK(render::is_software_opengl("Google SwiftShader"));
    CHECK_FALSE(render::is_software_opengl("NVIDIA H100 PCIe/PCIe/SSE2"));
    CHECK_FALSE(render::is_software_opengl("Mesa Intel(R) UHD Graphics 630 (CFL GT2)"));
    CHECK_FALSE(render::is_software_opengl("AMD Radeon RX 6800 (navi21, LLVM 15.0.6, DRM 3.49)"));
}
