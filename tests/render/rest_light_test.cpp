#include "render/offline/reference.h"
#include "render/raycast/ray_caster.h"
#include "tests/render/scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace scene_kit;

namespace {

constexpr glm::dvec3 ahead{0.0, 0.0, -1.0};
constexpr glm::dvec3 down{0.0, -1.0, 0.0};
constexpr double single_precision = 2e-6; // a dozen roundings, of rays; the reference keeps its result as a float

enum class Method : std::uint8_t { reference, ray };

/// What an eye at rest sees in the middle of its picture.
glm::dvec3 seen_along(Method method, const content::SceneDesc& scene, const glm::dvec3& look,
                      double field_of_view = 1e-3) {
    render::RenderFrame view = frame(0.0, ahead, look, 1, 1);
    view.eye.horizontal_field_of_view = field_of_view;
    if (method == Method::reference) {
        return colour_at(render::ReferenceRenderer(scene).render(view, 1), 0, 0);
    }
    const render::SceneColour colour(scene);
    return colour_at(render::RayCaster(scene, colour).picture(view, 1), 0, 0);
}

void check_colour(const glm::dvec3& seen, const glm::dvec3& expected) {
    CHECK(glm::length(seen - expected) < single_precision);
}

content::Image four_colours() {
    content::Image image;
    image.width = 2;
    image.height = 2;
    image.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0};
    return image;
}

} // namespace

TEST_CASE("the sun lights by the cosine, and pi of irradiance makes white 1") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = floor_scene(matte({1.0f, 0.5f, 0.25f}));
    scene.sun = content::Sun{glm::normalize(glm::vec3(3, 4, 0)), glm::vec3(3.1415927f)};
    const glm::dvec3 seen = seen_along(method, scene, down);
    CHECK_THAT(seen.r, WithinRel(0.8, single_precision));
    CHECK_THAT(seen.g, WithinRel(0.4, single_precision));
    CHECK_THAT(seen.b, WithinRel(0.2, single_precision));
}

TEST_CASE("a roof shades the floor below it and nothing else") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = floor_scene(matte(glm::vec3(1.0f)));
    scene.sun = content::Sun{{0, 1, 0}, glm::vec3(3.1415927f)};
    add(scene, rectangle({5, 3, 0}, {1, 0, 0}, {0, 0, -1}), matte(glm::vec3(1.0f)));
    CHECK_THAT(seen_along(method, scene, glm::normalize(glm::dvec3(5, -2, 0))).r, WithinAbs(0.0, single_precision));
    // It ends at x = 6 exactly; a millimetre is what rays' starts are lifted at this distance, at most.
    CHECK_THAT(seen_along(method, scene, glm::normalize(glm::dvec3(5.999, -2, 0)), 1e-6).r,
               WithinAbs(0.0, single_precision));
    CHECK_THAT(seen_along(method, scene, glm::normalize(glm::dvec3(6.001, -2, 0)), 1e-6).r,
               WithinAbs(1.0, single_precision));
    CHECK_THAT(seen_along(method, scene, down).r, WithinAbs(1.0, single_precision));
}

TEST_CASE("ambient light is full on what faces up and 0.3 of it on what faces down") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = floor_scene(matte(glm::vec3(0.5f)));
    scene.ambient = glm::vec3(0.4f);
    add(scene, rectangle({0, 3, 0}, {1, 0, 0}, {0, 0, 1}), matte(glm::vec3(0.5f)));
    CHECK_THAT(seen_along(method, scene, down).r, WithinRel(0.2, single_precision));
    CHECK_THAT(seen_along(method, scene, {0.0, 1.0, 0.0}).r, WithinRel(0.2 * 0.3, single_precision));
}

TEST_CASE("a lamp falls off by the inverse square and fades out at its range") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = floor_scene(matte(glm::vec3(1.0f)));
    content::Lamp lamp;
    lamp.position = {0, 2, 0};
    lamp.intensity = glm::vec3(8.0f);
    scene.lamps = {lamp};
    CHECK_THAT(seen_along(method, scene, down).g, WithinRel(8.0 / std::numbers::pi / 16.0, single_precision));
    scene.lamps[0].range = 8.0f;
    CHECK_THAT(seen_along(method, scene, down).g,
               WithinRel(8.0 / std::numbers::pi / 16.0 * 15.0 / 16.0, single_precision));
    scene.lamps[0].range = 3.0f;
    CHECK(seen_along(method, scene, down).g == 0.0);
}

TEST_CASE("a surface is lit on the side that is looked at") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = empty_scene();
    content::Material material = matte(glm::vec3(1.0f));
    material.double_sided = true;
    add(scene, rectangle({0, 0, -5}, {1, 0, 0}, {0, -1, 0}), material); // its back towards the eye
    scene.sun = content::Sun{{0, 0, 1}, glm::vec3(3.1415927f)};
    CHECK_THAT(seen_along(method, scene, ahead).r, WithinRel(1.0, single_precision));
    scene.sun->direction = {0, 0, -1};
    CHECK(seen_along(method, scene, ahead).r == 0.0);
}

TEST_CASE("a surface with one side is not seen from behind, but casts its shadow") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = floor_scene(matte(glm::vec3(1.0f)));
    const std::size_t roof = add(scene, rectangle({0, 3, 0}, {1, 0, 0}, {0, 0, -1}), unlit(glm::vec3(0.5f)));
    const std::size_t ceiling = add(scene, rectangle({0, 4, 0}, {1, 0, 0}, {0, 0, 1}), unlit(glm::vec3(0.25f)));
    for (content::Material& material : scene.materials) {
        material.double_sided = false;
    }
    scene.sun = content::Sun{{0, 1, 0}, glm::vec3(3.1415927f)};
    const glm::dvec3 up{0.0, 1.0, 0.0};
    CHECK(seen_along(method, scene, up) == glm::dvec3(0.25)); // through the roof, which faces up
    CHECK(seen_along(method, scene, down) == glm::dvec3(0.0));
    const glm::mat4 mirror = glm::scale(glm::mat4(1.0f), {-1.0f, 1.0f, 1.0f}); // a mirrored front is still a front
    scene.instances[roof].world_from_mesh = mirror;
    scene.instances[ceiling].world_from_mesh = mirror;
    CHECK(seen_along(method, scene, up) == glm::dvec3(0.25));
}

TEST_CASE("emission adds to reflected light") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::Material material = matte(glm::vec3(0.5f));
    material.emission = {3.0f, 2.0f, 1.0f};
    content::SceneDesc scene = floor_scene(material);
    scene.ambient = glm::vec3(1.0f);
    const glm::dvec3 seen = seen_along(method, scene, down);
    CHECK_THAT(seen.r, WithinRel(3.5, single_precision));
    CHECK_THAT(seen.b, WithinRel(1.5, single_precision));
}

TEST_CASE("an image's first row is at the top of what it is laid on, and half way between texels is their mean") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = empty_scene();
    scene.images.push_back(four_colours());
    content::Material material = unlit(glm::vec3(1.0f));
    material.base_colour_image = 0;
    add(scene, rectangle({0, 0, -4}, {4, 0, 0}, {0, 4, 0}), material);
    check_colour(seen_along(method, scene, glm::normalize(glm::dvec3(-2, 2, -4))), glm::dvec3(1, 0, 0));
    check_colour(seen_along(method, scene, glm::normalize(glm::dvec3(2, 2, -4))), glm::dvec3(0, 1, 0));
    check_colour(seen_along(method, scene, glm::normalize(glm::dvec3(-2, -2, -4))), glm::dvec3(0, 0, 1));
    const glm::dvec3 between = seen_along(method, scene, glm::normalize(glm::dvec3(0, 2, -4)));
    CHECK_THAT(between.r, WithinAbs(0.5, single_precision));
    CHECK_THAT(between.g, WithinAbs(0.5, single_precision));
}

TEST_CASE("a masked material is not there where its alpha is below the cutoff") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = empty_scene();
    scene.images.push_back(four_colours()); // lower right quarter: alpha 0
    content::Material material = unlit(glm::vec3(1.0f));
    material.base_colour_image = 0;
    material.alpha_mode = content::AlphaMode::mask;
    add(scene, rectangle({0, 0, -4}, {4, 0, 0}, {0, 4, 0}), material);
    const std::size_t behind = add(scene, rectangle({0, 0, -9}, {50, 0, 0}, {0, 50, 0}), unlit({0.125f, 0.25f, 0.5f}));
    check_colour(seen_along(method, scene, glm::normalize(glm::dvec3(-2, -2, -4))), glm::dvec3(0, 0, 1));
    check_colour(seen_along(method, scene, glm::normalize(glm::dvec3(2, -2, -4))), glm::dvec3(0.125, 0.25, 0.5));
    scene.materials[scene.meshes[behind].material] = matte(glm::vec3(1.0f));
    scene.sun = content::Sun{{0, 0, 1}, glm::vec3(3.1415927f)};
    // Both are seen through the hole. The sun reaches (2.25, -2.25) through it too, but (3.9, -3.9) lies behind the
    // rectangle's edge, where the repeated image's alpha is 0.72.
    CHECK_THAT(seen_along(method, scene, glm::normalize(glm::dvec3(1, -1, -4))).r, WithinAbs(1.0, single_precision));
    CHECK_THAT(seen_along(method, scene, glm::normalize(glm::dvec3(3.9, -3.9, -9))).r,
               WithinAbs(0.0, single_precision));
}

TEST_CASE("a panorama's middle looks along -z, its right half towards +x, its top row is the zenith") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene = empty_scene();
    content::Panorama panorama;
    panorama.width = 256;
    panorama.height = 128;
    for (int row = 0; row < panorama.height; ++row) {
        for (int column = 0; column < panorama.width; ++column) {
            const double colatitude = std::numbers::pi * (row + 0.5) / panorama.height;
            const double longitude = 2.0 * std::numbers::pi * ((column + 0.5) / panorama.width - 0.5);
            const glm::dvec3 direction(std::sin(colatitude) * std::sin(longitude), std::cos(colatitude),
                                       -std::sin(colatitude) * std::cos(longitude));
            panorama.radiance.emplace_back(0.5 * direction + 0.5);
        }
    }
    scene.panorama = panorama;
    for (const glm::dvec3& look : {glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0),
                                   glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.6, 0.64, -0.48)}) {
        const glm::dvec3 seen = 2.0 * seen_along(method, scene, look) - 1.0;
        // Linear between texels 0.0245 rad apart: the chord is off by 0.0245^2 / 8 a direction; at the pole, half a
        // texel from the last row, by the row's own distance from it.
        const double tolerance = std::abs(look.y) == 1.0 ? 0.0123 : 2e-4;
        CHECK(glm::length(seen - look) < tolerance);
    }
}

TEST_CASE("the gradient sky has its colours at zenith, horizon and nadir") {
    const Method method = GENERATE(Method::reference, Method::ray);
    content::SceneDesc scene;
    scene.gradient_sky = {{0.125f, 0.25f, 0.5f}, {0.5f, 0.75f, 1.0f}, {0.25f, 0.25f, 0.125f}};
    check_colour(seen_along(method, scene, {0, 1, 0}), glm::dvec3(scene.gradient_sky.zenith));
    CHECK(glm::length(seen_along(method, scene, ahead, 1e-9) - glm::dvec3(scene.gradient_sky.horizon)) < 1e-6);
    check_colour(seen_along(method, scene, {0, -1, 0}), glm::dvec3(scene.gradient_sky.nadir));
}
