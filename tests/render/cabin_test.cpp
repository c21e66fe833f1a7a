#include "content/generator/cabin.h"
#include "render/cabin/cabin_light.h"
#include "render/cabin/cabin_view.h"
#include "render/cabin/surroundings.h"
#include "scene_kit.h"
#include "sim/look.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace shared {
using glm::vec3;
using glm::vec4;
namespace {
#include "render/shaders/shared/cabin_clip.glsl"
}
} // namespace shared

namespace {

constexpr double pi = std::numbers::pi;

sim::BoostAndRotation moving_eye(double rapidity, const glm::dvec3& heading) {
    return sim::split(sim::world_from_looking<sim::Head>(sim::Rapidity(rapidity), heading, {0.0, 0.0, -1.0}));
}

/// What is seen around an eye under a sky of radiance 1 everywhere, by the closed form of the searchlight at every
/// pixel's centre: D^-4.
std::vector<render::SeenLightSample> samples_of_even_sky(const sim::BoostAndRotation& eye) {
    std::vector<render::SeenLightSample> samples;
    constexpr int side = render::surroundings_side;
    for (const render::SurroundingsView& view : render::surroundings_views(eye, render::Mode::full)) {
        render::Picture picture{side, side, 3, {}};
        for (int row = 0; row < side; ++row) {
            for (int column = 0; column < side; ++column) {
                const glm::dvec3 in_view(view.half_width * ((2.0 * column + 1.0) / side - 1.0),
                                         view.half_width * (1.0 - (2.0 * row + 1.0) / side), -1.0);
                const glm::dvec3 seen = view.boosted_from_view * glm::normalize(in_view);
                const double beta = std::tanh(eye.xi.value);
                const double shift = std::cosh(eye.xi.value) * (1.0 - beta * glm::dot(seen, eye.along)); // D
                picture.values.insert(picture.values.end(), 3, static_cast<float>(std::pow(shift, -4.0)));
            }
        }
        render::add_samples(view, picture, 0.0, samples);
    }
    return samples;
}

/// Irradiance of a wall that faces where the eye goes, under that sky: 2 pi integral mu (gamma (1 - beta mu))^-4 d mu
/// over [0, 1]. beta < 0: of one that faces back.
double wall_across(double beta) {
    const double gamma4 = std::pow(1.0 - beta * beta, -2.0);
    const double u = 1.0 - beta;
    const double integral = (1.0 / 6.0 + 1.0 / (3.0 * u * u * u) - 1.0 / (2.0 * u * u)) / (beta * beta);
    return 2.0 * pi * integral / gamma4;
}

} // namespace

TEST_CASE("the cabin's clip coordinates are a pinhole's, for screens that are not symmetric, too") {
    const render::CabinView view{
        {0.05, -0.02, 0.1}, glm::angleAxis(0.3, glm::normalize(glm::dvec3(1.0, 2.0, 0.5))), {-1.3, 0.8, -0.9, 1.1}};
    for (const glm::dvec3& point : {glm::dvec3(0.2, 0.1, -1.0), {-0.4, -0.3, -0.74}, {0.1, 0.4, -3.5}}) {
        const glm::dvec3 from_eye = glm::conjugate(view.cabin_from_eye) * (point - view.eye);
        REQUIRE(from_eye.z < 0.0);
        const glm::vec4 clip = shared::cabin_clip(glm::vec3(from_eye), glm::vec4(-1.3f, 0.8f, -0.9f, 1.1f), 0.01f);
        // The pinhole: right per distance ahead; the picture's left edge at -1.3, its right edge at 0.8.
        const glm::dvec2 place((from_eye.x / -from_eye.z + 1.3) / 2.1, (from_eye.y / -from_eye.z + 0.9) / 2.0);
        // Single precision.
        CHECK_THAT(0.5 + 0.5 * static_cast<double>(clip.x / clip.w), WithinAbs(place.x, 1e-6));
        CHECK_THAT(0.5 + 0.5 * static_cast<double>(clip.y / clip.w), WithinAbs(place.y, 1e-6));
        CHECK_THAT(static_cast<double>(clip.z / clip.w), WithinRel(0.01 / -from_eye.z, 1e-5));
        CHECK_THAT(view.place_of(view.tangents_of(point)).x, WithinAbs(place.x, 1e-15));
        CHECK_THAT(view.place_of(view.tangents_of(point)).y, WithinAbs(place.y, 1e-15));
    }
}

TEST_CASE("the small pictures all around cover every direction once, at any speed") {
    for (const double rapidity : {0.0, 0.4, 1.5, 5.0}) {
        const sim::BoostAndRotation eye = moving_eye(rapidity, glm::normalize(glm::dvec3(1.0, 0.4, -2.0)));
        double solid_angle = 0.0;
        glm::dvec3 middle(0.0);
        std::vector<render::SeenLightSample> samples;
        const render::Picture white{
            render::surroundings_side, render::surroundings_side, 3,
            std::vector<float>(3 * render::surroundings_side * render::surroundings_side, 1.0f)};
        for (const render::SurroundingsView& view : render::surroundings_views(eye, render::Mode::full)) {
            render::add_samples(view, white, 0.0, samples);
        }
        for (const render::SeenLightSample& sample : samples) {
            solid_angle += static_cast<double>(sample.power.x);
            middle += static_cast<double>(sample.power.x) * glm::dvec3(sample.direction);
        }
        CHECK_THAT(solid_angle, WithinRel(4.0 * pi, 2e-3)); // midpoint rule, 16 pixels a side
        CHECK(glm::length(middle) < 0.02);                  // the nested views are sampled finer than their opposite
    }
}

TEST_CASE("the light of an even sky on walls at speed is that of the closed form") {
    for (const double beta : {0.3, 0.9, 0.99, 0.999}) {
        const glm::dvec3 heading = glm::normalize(glm::dvec3(1.0, 0.4, -2.0));
        const sim::BoostAndRotation eye = moving_eye(std::atanh(beta), heading);
        const std::vector<render::SeenLightSample> samples = samples_of_even_sky(eye);
        const glm::dvec3 beside = glm::normalize(glm::cross(heading, {0.0, 1.0, 0.0}));
        const double gamma = std::cosh(eye.xi.value);
        CAPTURE(beta);
        // 16 pixels across a range of D of 2 at most: the midpoint rule's error at the steepest is a percent.
        CHECK_THAT(render::irradiance(samples, heading).x, WithinRel(wall_across(beta), 0.01));
        CHECK_THAT(render::irradiance(samples, -heading).x, WithinRel(wall_across(-beta), 0.02));
        // Beside: D^-4 of the eye's sky is D^-1 of the world's, whose mean is gamma.
        CHECK_THAT(render::irradiance(samples, beside).x, WithinRel(pi * gamma, 0.01));
    }
}

TEST_CASE("a plate in the open is lit by the coarse directions as by the closed form") {
    content::Mesh plate = scene_kit::rectangle({0.0f, 0.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}); // faces +z
    for (content::Vertex& vertex : plate.vertices) {
        vertex.colour = glm::vec4(0.5f, 0.25f, 1.0f, 1.0f);
    }
    const render::CabinLight cabin(plate);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(cabin.openness(i) > 0.98f); // cosines at the middles of parts of 11 degrees
    }
    render::LightFromAround even(glm::vec3(2.0f));
    for (const glm::vec3& direction : {glm::vec3(0.0f, 0.0f, 1.0f), {0.6f, -0.64f, 0.48f}, {-0.57f, 0.58f, -0.58f}}) {
        CHECK_THAT(static_cast<double>(even.radiance_from(glm::normalize(direction)).y), WithinRel(2.0, 1e-5));
    }
    const std::vector<glm::vec3> sent_out = cabin.radiance(even);
    CHECK_THAT(static_cast<double>(sent_out[0].x), WithinRel(1.0, 0.02)); // reflectance times the sky's radiance
    CHECK_THAT(static_cast<double>(sent_out[0].y), WithinRel(0.5, 0.02));

    // At speed, facing ahead, back and aside: light near the plate's own plane is spread over 11 degrees.
    for (const double beta : {0.5, 0.9}) {
        const sim::BoostAndRotation eye = moving_eye(std::atanh(beta), {0.0, 0.0, 1.0});
        render::LightFromAround light;
        light.add(samples_of_even_sky(eye), glm::dmat3(1.0));
        CHECK_THAT(static_cast<double>(cabin.irradiance(light)[0].x), WithinRel(wall_across(beta), 0.05));
        light = {};
        light.add(samples_of_even_sky(moving_eye(std::atanh(beta), {1.0, 0.0, 0.0})), glm::dmat3(1.0));
        CHECK_THAT(static_cast<double>(cabin.irradiance(light)[0].x),
                   WithinRel(pi / std::sqrt(1.0 - beta * beta), 0.05));
        // Turned by a quarter about y, what was ahead is aside.
        light = {};
        light.add(samples_of_even_sky(eye), glm::dmat3({0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}));
        CHECK_THAT(static_cast<double>(cabin.irradiance(light)[0].x),
                   WithinRel(pi / std::sqrt(1.0 - beta * beta), 0.05));
    }
}

TEST_CASE("what stands before a part of the cabin takes its light, and gives some back") {
    content::Mesh plates = scene_kit::rectangle({0.0f, 0.0f, 0.0f}, {0.01f, 0.0f, 0.0f}, {0.0f, 0.01f, 0.0f});
    const content::Mesh roof = scene_kit::rectangle({0.0f, 0.0f, 0.5f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f});
    for (const content::Vertex& vertex : roof.vertices) {
        plates.vertices.push_back(vertex);
    }
    for (const std::uint32_t index : roof.indices) {
        plates.indices.push_back(index + 4);
    }
    for (content::Vertex& vertex : plates.vertices) {
        vertex.colour = glm::vec4(0.5f);
    }
    const render::CabinLight cabin(plates);
    // A square of half side a at distance a over a small plate covers the share 4 / (pi sqrt 2) atan(1 / sqrt 2) of it
    // (the view factor of a plate parallel to a rectangle, four corners of sides a).
    const double covered = 4.0 / (pi * std::sqrt(2.0)) * std::atan(1.0 / std::sqrt(2.0));
    CHECK_THAT(static_cast<double>(cabin.openness(0)), WithinAbs(1.0 - covered, 0.05)); // parts of 11 degrees
    const std::vector<glm::vec3> straight = cabin.irradiance(render::LightFromAround(glm::vec3(1.0f)));
    const std::vector<glm::vec3> sent_out = cabin.radiance(render::LightFromAround(glm::vec3(1.0f)));
    CHECK(static_cast<double>(sent_out[0].x) > 0.5 * static_cast<double>(straight[0].x) / pi);
    CHECK(sent_out[0].x < sent_out[4].x);
}

TEST_CASE("the pilot sees the screens, and no part of the cabin is where the eyes are") {
    const content::generator::Cabin cabin = content::generator::make_cabin();
    REQUIRE(cabin.screens.size() == 3);
    const render::CabinView view{{}, {1.0, 0.0, 0.0, 0.0}, {-1.0, 1.0, -0.5625, 0.5625}};
    double width = 0.0;
    for (const content::generator::PanelScreen& screen : cabin.screens) {
        // Square to the line of sight, right and up as the pilot has them, within a picture of 16:9 and 90 degrees.
        CHECK(glm::dot(glm::cross(screen.right, screen.up), -screen.centre) > 0.0);
        CHECK_THAT(glm::dot(screen.right, screen.up), WithinAbs(0.0, 1e-12));
        CHECK_THAT(glm::dot(screen.centre, screen.right), WithinAbs(0.0, 1e-12));
        CHECK_THAT(glm::dot(screen.centre, screen.up), WithinAbs(0.0, 1e-12));
        const glm::dvec2 place = view.place_of(view.tangents_of(screen.centre));
        CHECK(std::min(place.x, place.y) > 0.0);
        CHECK(std::max(place.x, place.y) < 1.0);
        // As high for its width as its part of the picture.
        const glm::dvec2 part = screen.high - screen.low;
        CHECK_THAT(glm::length(screen.right) / glm::length(screen.up),
                   WithinRel(content::generator::panel_aspect * part.x / part.y, 1e-12));
        width += part.x;
    }
    CHECK_THAT(width, WithinRel(1.0, 1e-12));
    for (const content::Vertex& vertex : cabin.mesh.vertices) {
        CHECK(glm::length(vertex.position) > 0.2f);
        CHECK(std::max({vertex.colour.r, vertex.colour.g, vertex.colour.b}) <= 1.0f);
    }
}
