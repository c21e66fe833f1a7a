#include "render/colour/star_photometry.h"
#include "render/offline/reference.h"
#include "tests/render/scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace scene_kit;

namespace {

constexpr glm::dvec3 ahead{0.0, 0.0, -1.0};

content::SceneDesc one_star(const glm::dvec3& light_years) {
    content::SceneDesc scene;
    scene.gradient_sky = {glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
    content::Star star;
    star.position = light_years;
    star.visual_magnitude = 1.0f;
    star.temperature = 9600.0f;
    scene.stars = {star};
    return scene;
}

struct Spot {
    double irradiance = 0.0; ///< green, radiance times solid angle over the whole picture
    glm::dvec2 centroid{0.0};
};

Spot spot_of(const render::Picture& picture, const render::EyeView& eye) {
    Spot spot;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double cosine = -render::head_direction_from_pixel(eye, x + 0.5, y + 0.5).unit.z;
            const double focal = render::focal_length_pixels(eye);
            const double light = colour_at(picture, x, y).g * cosine * cosine * cosine / (focal * focal);
            spot.irradiance += light;
            spot.centroid += light * glm::dvec2(x + 0.5, y + 0.5);
        }
    }
    spot.centroid /= spot.irradiance;
    return spot;
}

} // namespace

TEST_CASE("a star's light arrives whole, where aberration puts it, with the flux that photometry says") {
    const double world_angle = 0.7;
    const double distance = 20.0;
    const content::SceneDesc scene =
        one_star(distance * glm::dvec3(std::sin(world_angle), 0.0, -std::cos(world_angle)));
    for (const double rapidity : {0.0, 0.5, 2.0}) {
        render::RenderFrame view = frame(rapidity, ahead, ahead, 96, 54);
        view.mode = render::Mode::full;
        const Spot spot = spot_of(render::ReferenceRenderer(scene).render(view, 1), view.eye);
        const double half_tangent = std::exp(-rapidity) * std::tan(0.5 * world_angle);
        const double eye_angle = 2.0 * std::atan(half_tangent);
        const double ratio = std::exp(-rapidity) * std::pow(std::cos(0.5 * eye_angle), 2) +
                             std::exp(rapidity) * std::pow(std::sin(0.5 * eye_angle), 2);
        const render::DopplerColour colour(scene.light_temperature);
        const glm::dvec3 expected = render::star_light(colour, render::star_source(colour, scene.stars[0]),
                                                       render::Mode::full, distance, ratio);
        // The footprint's pixels differ in solid angle; over its 0.7 pixels of spread that is second order: < 0.1 %.
        CHECK_THAT(spot.irradiance, WithinRel(expected.g, 1e-3));
        CHECK_THAT(spot.centroid.x, WithinAbs(48.0 + 48.0 * std::tan(eye_angle), 0.02)); // first order of the same
        CHECK_THAT(spot.centroid.y, WithinAbs(27.0, 1e-4));
    }
}

TEST_CASE("a star does not shine through a wall") {
    content::SceneDesc scene = one_star({0.0, 0.0, -20.0});
    add(scene, rectangle({0, 0, -5}, {9, 0, 0}, {0, 9, 0}), unlit(glm::vec3(0.0f)));
    const render::RenderFrame view = frame(0.0, ahead, ahead, 16, 16);
    for (const float value : render::ReferenceRenderer(scene).render(view, 2).values) {
        CHECK(value == 0.0f);
    }
}
