#include "render/offline/reference.h"
#include "tests/render/outline_check.h"
#include "tests/render/scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace scene_kit;

namespace {

constexpr glm::dvec3 ahead{0.0, 0.0, -1.0};
constexpr double single_precision = 1e-6; // a few roundings of the float that a picture keeps

render::Picture picture(const content::SceneDesc& scene, const render::RenderFrame& frame, int samples_per_side = 1) {
    return render::ReferenceRenderer(scene).render(frame, samples_per_side);
}

render::Picture layer(const content::SceneDesc& scene, render::RenderFrame frame, render::Layer which) {
    frame.layer = which;
    return picture(scene, frame);
}

glm::dvec3 pixel_direction(const render::RenderFrame& frame, int column, int row) {
    return render::head_direction_from_pixel(frame.eye, column + 0.5, row + 0.5).unit;
}

} // namespace

TEST_CASE("a moving eye sees a sphere's outline as the circle of sphere_outline.csv") {
    check_sphere_outlines(
        [](const content::SceneDesc& scene, const render::RenderFrame& view) { return picture(scene, view); });
}

TEST_CASE("D in a picture follows the half-angle form about the direction of motion") {
    const double rapidity = 2.0;
    const render::RenderFrame view = frame(rapidity, ahead, glm::normalize(glm::dvec3(0.6, 0.2, -0.5)), 64, 36);
    const render::Picture ratio = layer(empty_scene(), view, render::Layer::doppler);
    const glm::dmat3 axes = sim::camera_axes(glm::normalize(glm::dvec3(0.6, 0.2, -0.5)));
    for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double half = 0.5 * angle_between(axes * pixel_direction(view, x, y), ahead);
            const double expected = std::exp(-rapidity) * std::cos(half) * std::cos(half) +
                                    std::exp(rapidity) * std::sin(half) * std::sin(half);
            CHECK_THAT(value_at(ratio, x, y), WithinRel(expected, single_precision));
        }
    }
}

TEST_CASE("a grey wall's searchlight is D^-4 times its radiance at rest") {
    content::SceneDesc scene = empty_scene();
    add(scene, sphere({0, 0, 0}, 5.0f, 16), unlit(glm::vec3(0.25f)));
    render::RenderFrame view = frame(1.5, ahead, {1.0, 0.0, 0.0}, 48, 27);
    const render::Picture ratio = layer(scene, view, render::Layer::doppler);
    view.mode = render::Mode::searchlight;
    const render::Picture light = picture(scene, view);
    for (int y = 0; y < 27; ++y) {
        for (int x = 0; x < 48; ++x) {
            const double expected = 0.25 * std::pow(value_at(ratio, x, y), -4.0);
            CHECK_THAT(colour_at(light, x, y).g, WithinRel(expected, 5.0 * single_precision)); // fourth power
        }
    }
}

TEST_CASE("unlit colours reach an eye at rest as they are, in every mode") {
    content::SceneDesc scene = empty_scene();
    add(scene, sphere({0, 0, 0}, 5.0f, 16), unlit({1.0f, 0.5f, 0.125f}));
    render::RenderFrame view = frame(0.0, ahead, ahead, 8, 8);
    for (const render::Mode mode :
         {render::Mode::geometry, render::Mode::doppler, render::Mode::searchlight, render::Mode::full}) {
        view.mode = mode;
        const glm::dvec3 seen = colour_at(picture(scene, view, 2), 3, 5);
        CHECK_THAT(seen.r, WithinAbs(1.0, single_precision));
        CHECK_THAT(seen.g, WithinAbs(0.5, single_precision));
        CHECK_THAT(seen.b, WithinAbs(0.125, single_precision));
    }
}

TEST_CASE("what stands to the right is seen on the right, what is above is above") {
    content::SceneDesc scene = empty_scene();
    add(scene, rectangle({2, 0, -10}, {0.5f, 0, 0}, {0, 0.5f, 0}), unlit(glm::vec3(1.0f)));
    add(scene, rectangle({0, 3, -10}, {0.5f, 0, 0}, {0, 0.5f, 0}), unlit(glm::vec3(1.0f)));
    const render::Picture objects = layer(scene, frame(0.0, ahead, ahead, 100, 100), render::Layer::object);
    CHECK(value_at(objects, 60, 50) == 0.0); // 90 degrees wide: x / distance = 0.2 lies 10 pixels right of 50
    CHECK(value_at(objects, 50, 35) == 1.0);
    CHECK(value_at(objects, 40, 50) == -1.0);
    CHECK(value_at(objects, 50, 65) == -1.0);
}

TEST_CASE("moving ahead draws the scenery together towards the direction of motion") {
    content::SceneDesc scene = empty_scene();
    const double world_angle = 1.2;
    const auto position = glm::vec3(10.0 * glm::dvec3(std::sin(world_angle), 0.0, -std::cos(world_angle)));
    add(scene, sphere(position, 0.05f, 32), unlit(glm::vec3(1.0f)));
    const double rapidity = 1.0;
    const double eye_angle = 2.0 * std::atan(std::exp(-rapidity) * std::tan(0.5 * world_angle));
    const render::Picture objects = layer(scene, frame(rapidity, ahead, ahead, 1001, 3), render::Layer::object);
    const int expected = static_cast<int>(500.5 + 500.5 * std::tan(eye_angle));
    CHECK(value_at(objects, expected, 1) == 0.0);
    CHECK(value_at(objects, expected - 5, 1) == -1.0); // the sphere is 2 * 0.005 rad * (1/D = 1.4) * 500 = 7 px wide
    CHECK(value_at(objects, expected + 5, 1) == -1.0);
}

TEST_CASE("distances are those of the world at rest") {
    content::SceneDesc scene = empty_scene();
    add(scene, rectangle({0, 0, -10}, {1000, 0, 0}, {0, 1000, 0}), unlit(glm::vec3(1.0f)));
    const render::RenderFrame view = frame(0.3, ahead, ahead, 32, 32); // sees up to 70 degrees of the world
    const render::Picture distance = layer(scene, view, render::Layer::distance);
    const render::Picture direction = layer(scene, view, render::Layer::direction);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const double down_range = -colour_at(direction, x, y).z;
            CHECK_THAT(value_at(distance, x, y), WithinRel(10.0 / down_range, 2.0 * single_precision));
        }
    }
    CHECK(std::isinf(value_at(layer(empty_scene(), view, render::Layer::distance), 0, 0)));
}

TEST_CASE("one sample a pixel shows light exactly where the object layer has an object") {
    content::SceneDesc scene = empty_scene();
    add(scene, sphere({3, 1, -10}, 2.0f, 24), unlit(glm::vec3(1.0f)));
    add(scene, sphere({-2, -1, -6}, 1.5f, 24), unlit(glm::vec3(1.0f)));
    const render::RenderFrame view = frame(0.8, ahead, ahead, 96, 54);
    const render::Picture light = picture(scene, view);
    const render::Picture objects = layer(scene, view, render::Layer::object);
    int lit = 0;
    for (int y = 0; y < 54; ++y) {
        for (int x = 0; x < 96; ++x) {
            CHECK((colour_at(light, x, y).r > 0.0) == (value_at(objects, x, y) >= 0.0));
            lit += colour_at(light, x, y).r > 0.0 ? 1 : 0;
        }
    }
    CHECK(lit > 50);
}

TEST_CASE("supersampling gives an edge the share of the pixel that it covers") {
    content::SceneDesc scene = empty_scene();
    // Covers the right part of the pixel column 4 of 8: tan = -0.25 ... 0.0 is column 3, 0 ... 0.25 column 4.
    add(scene, rectangle({50.0625f, 0, -1}, {50, 0, 0}, {0, 50, 0}), unlit(glm::vec3(1.0f)));
    const render::Picture light = picture(scene, frame(0.0, ahead, ahead, 8, 8), 8);
    CHECK_THAT(colour_at(light, 4, 4).r, WithinAbs(0.75, single_precision));
    CHECK_THAT(colour_at(light, 3, 4).r, WithinAbs(0.0, single_precision));
    CHECK_THAT(colour_at(light, 5, 4).r, WithinAbs(1.0, single_precision));
}
