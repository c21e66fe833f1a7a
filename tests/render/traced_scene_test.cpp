#include "render/offline/traced/traced_scene.h"

#include "content/model_name.h"
#include "render/offline/scenery_hits.h"
#include "render/offline/seen_colour.h"
#include "render/offline/traced/curve_search.h"
#include "sim/bad_input.h"
#include "sim/retarded.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

content::TracedScenario flat() {
    content::TracedScenario scenario;
    scenario.name = "test";
    scenario.camera.moment.position = {0.0, 0.0, 0.0};
    scenario.camera.moment.look = {0.0, 1.0, 0.0};
    scenario.camera.field_of_view = 1.2;
    return scenario;
}

const render::CameraLens lens{content::Projection::perspective, 1.2, 160, 90};

std::vector<render::TracedRay> rays_of(const render::TracedScene& scene, const content::TracedScenario& scenario,
                                       const std::vector<glm::dvec3>& directions) {
    std::vector<render::TracedRay> rays(directions.size());
    scene.rays(render::camera_pose(scenario, 0.0), lens)->trace(directions, rays, 0);
    return rays;
}

glm::dvec3 chart_from_head(const glm::dvec3& head) {
    return {head.x, -head.z, head.y};
}

} // namespace

TEST_CASE("a sphere at rest in flat space has the outline and the distance that geometry gives it") {
    content::TracedScenario scenario = flat();
    content::TracedSphere sphere;
    sphere.centre = {1.0, 8.0, 0.5};
    sphere.radius = 2.0;
    scenario.spheres = {sphere};
    const render::TracedScene scene(scenario, {});
    const double half = std::asin(2.0 / glm::length(sphere.centre));
    const glm::dvec3 axis = glm::normalize(sphere.centre);
    const glm::dvec3 side = glm::normalize(glm::cross(axis, {0.0, 0.0, 1.0}));
    for (const double share : {0.0, 0.5, 0.999999, 1.000001, 1.5}) {
        for (const double turn : {0.0, 1.0, 2.5, 4.0}) {
            const glm::dvec3 across = std::cos(turn) * side + std::sin(turn) * glm::cross(axis, side);
            const glm::dvec3 chart = std::cos(share * half) * axis + std::sin(share * half) * across;
            const glm::dvec3 head(chart.x, chart.z, -chart.y);
            INFO("share " << share << ", turn " << turn);
            CHECK((rays_of(scene, scenario, {head})[0].fate == render::RayFate::object) == (share < 1.0));
        }
    }
}

TEST_CASE("a moving sphere is seen where its light left it, as a circle, with its own Doppler shift") {
    content::TracedScenario scenario = flat();
    content::TracedSphere sphere;
    sphere.centre = {-2.0, 6.0, 1.0};
    sphere.velocity = {-0.8, 0.1, 0.0};
    sphere.radius = 1.0;
    scenario.spheres = {sphere};
    const render::TracedScene scene(scenario, {});
    // In the sphere's frame (axes carried by the boost) the eye is at an event at a place relative to its centre, and
    // meets the sphere when its own, aberrated direction does: a circle there, hence a circle here (Penrose 1959).
    const double speed = glm::length(sphere.velocity);
    const double gamma = 1.0 / std::sqrt(1.0 - speed * speed);
    const glm::dvec3 along = sphere.velocity / speed;
    const glm::dvec3 eye_from_centre = -sphere.centre + (gamma - 1.0) * glm::dot(-sphere.centre, along) * along;
    int hits = 0;
    for (int row = 0; row < 90; ++row) {
        std::vector<glm::dvec3> heads;
        for (int column = 0; column < 160; ++column) {
            heads.push_back(*render::head_direction(lens, {column + 0.5, row + 0.5}));
        }
        const auto rays = rays_of(scene, scenario, heads);
        for (std::size_t i = 0; i < heads.size(); ++i) {
            const glm::dvec3 n = chart_from_head(heads[i]);
            // Light of unit frequency here, -n its motion: its frequency there and where it comes from.
            const double frequency = gamma * (1.0 + glm::dot(n, sphere.velocity));
            const glm::dvec3 there = (n + ((gamma - 1.0) * glm::dot(n, along) + gamma * speed) * along) / frequency;
            const double nearest = glm::length(glm::cross(there, eye_from_centre));
            const bool hit = nearest < 1.0 && glm::dot(there, eye_from_centre) < 0.0;
            if (std::abs(nearest - 1.0) > 1e-6) { // the outline itself is anybody's
                CHECK((rays[i].fate == render::RayFate::object) == hit);
            }
            if (hit && nearest < 0.999) {
                ++hits;
                CHECK_THAT(rays[i].wavelength_ratio, WithinRel(frequency, 1e-9)); // one step of flat space is exact
            }
        }
    }
    CHECK(hits > 100);
}

TEST_CASE("a moving sphere's colour is that of its reflectance's five terms, seen at its D") {
    content::TracedScenario scenario = flat();
    content::TracedSphere sphere;
    sphere.centre = {0.0, 8.0, 0.0};
    sphere.radius = 1.0;
    sphere.velocity = {0.0, -0.5, 0.0};
    sphere.reflectance = {0.1, 0.4, 0.05};
    sphere.emission = {0.02, 0.01, 0.03};
    scenario.spheres = {sphere};
    scenario.light.irradiance = glm::dvec3(0.0);
    scenario.light.ambient = {1.0, 0.9, 0.7};
    const auto ray = rays_of(render::TracedScene(scenario, {}), scenario, {{0.0, 0.0, -1.0}})[0];
    REQUIRE(ray.fate == render::RayFate::object);
    CHECK_THAT(ray.wavelength_ratio, WithinRel(1.0 / std::sqrt(3.0), 1e-9));
    content::SceneDesc plain;
    plain.materials.emplace_back();
    const render::SceneSpectra spectra(plain);
    const render::MaterialTerms& material = spectra.materials().front();
    render::RestLight light;
    light.parts.push_back(
        {material.reflected, spectra.reflected(material, sphere.reflectance, scenario.light.ambient)});
    light.parts.push_back({material.emitted, spectra.emitted(material, sphere.emission)});
    const glm::dvec3 expected = render::SpectralColour(spectra).seen(light, ray.wavelength_ratio);
    CHECK(glm::length(ray.light - expected) < 5e-4 * glm::length(expected)); // tables in ln D: 0.02 %
}

TEST_CASE("a small moving body is where sim's light cone has it") {
    content::TracedScenario scenario = flat();
    content::TracedSphere sphere;
    sphere.centre = {0.0, 9.0, 0.0};
    sphere.velocity = {0.6, 0.0, 0.3};
    sphere.radius = 1e-3;
    scenario.spheres = {sphere};
    scenario.camera.moment.time = 2.0;
    const render::TracedScene scene(scenario, {});
    const sim::Emission emission =
        sim::retarded_emission({sphere.centre, sphere.velocity}, sim::Event{2.0, glm::dvec3(0.0)});
    const glm::dvec3 n = emission.from.unit;
    const render::TracedRay ray = rays_of(scene, scenario, {{n.x, n.z, -n.y}})[0];
    CHECK(ray.fate == render::RayFate::object);
    // The hit lies on the sphere's surface, a thousandth before its centre.
    CHECK_THAT(ray.wavelength_ratio, WithinRel(emission.wavelength_ratio, 1e-3));
}

TEST_CASE("cameras where nobody can be are refused by name") {
    content::TracedScenario scenario = flat();
    scenario.spacetime.name = "schwarzschild";
    const auto refuse = [&](const glm::dvec3& place, content::ObserverKind kind) {
        content::TracedScenario bad = scenario;
        bad.camera.moment.position = place;
        bad.camera.observer = kind;
        const render::TracedScene scene(bad, {});
        CHECK_THROWS_AS(scene.method(render::camera_pose(bad, 0.0)), sim::BadInput);
    };
    refuse({0.01, 0.0, 0.0}, content::ObserverKind::free_falling); // in the singularity
    refuse({1.5, 0.0, 0.0}, content::ObserverKind::at_rest);       // nothing rests within the horizon
    refuse({2.5, 0.0, 0.0}, content::ObserverKind::circular);      // no orbit within that of light
    refuse({8.0, 0.0, 1.0}, content::ObserverKind::circular);      // off the plane
    scenario.spacetime.parameters["mass"] = -1.0;
    CHECK_THROWS_AS(render::TracedScene(scenario, {}), sim::BadInput);
    scenario.spacetime = {"kerr", {{"spin", 1.5}}};
    CHECK_THROWS_AS(render::TracedScene(scenario, {}), sim::BadInput);
    scenario.spacetime = {"kerrr", {}};
    CHECK_THROWS_AS(render::TracedScene(scenario, {}), sim::BadInput);
    // A camera within an object.
    content::TracedScenario inside = flat();
    inside.spheres.emplace_back().centre = {0.2, 0.0, 0.0};
    const render::TracedScene scene(inside, {});
    CHECK_THROWS_AS(scene.rays(render::camera_pose(inside, 0.0), lens), sim::BadInput);
}

TEST_CASE("a segment meets a ball where it enters it, from inside where it leaves") {
    CHECK_THAT(*render::meet_ball({-3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, 1.0), WithinAbs(1.0 / 3.0, 1e-15));
    CHECK_THAT(*render::meet_ball({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, 1.0), WithinAbs(0.25, 1e-15));
    CHECK_FALSE(render::meet_ball({-3.0, 1.0001, 0.0}, {3.0, 1.0001, 0.0}, 1.0));
    CHECK_FALSE(render::meet_ball({2.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, 1.0));
    CHECK_FALSE(render::meet_ball({0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, 1.0));
}

TEST_CASE("a glTF model in flat space is what rays straight through the scenery find") {
    content::TracedScenario scenario = flat();
    content::TracedModel model;
    model.file = "generated:square";
    model.scale = 0.05;
    model.position = {0.3, 3.0, -0.4};
    model.look = {0.5, 0.8, 0.0};
    scenario.models = {model};
    scenario.light.direction = {0.3, -0.5, 0.8};
    const render::TracedScene scene(scenario, {});

    content::SceneDesc square = content::load_model(model.file);
    const glm::dvec3 back = -glm::normalize(model.look);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), back));
    const glm::dmat3 chart_from_model(right, glm::cross(back, right), back);
    square.sun.emplace();
    square.sun->direction = glm::vec3(glm::normalize(glm::transpose(chart_from_model) * scenario.light.direction));
    square.sun->irradiance = glm::vec3(scenario.light.irradiance);
    square.ambient = glm::vec3(scenario.light.ambient);
    const render::SceneryHits scenery(square);
    const render::SceneSpectra spectra(square);
    const render::SpectralColour colour(spectra);
    std::vector<glm::dvec3> heads;
    for (int i = 0; i < 300; ++i) {
        heads.push_back(*render::head_direction(lens, {0.5 + 53 * i % 160, 0.5 + 31 * i % 90}));
    }
    const auto rays = rays_of(scene, scenario, heads);
    int hits = 0;
    int different = 0;
    int recoloured = 0;
    for (std::size_t i = 0; i < heads.size(); ++i) {
        const glm::dvec3 origin = glm::transpose(chart_from_model) * (-model.position) / model.scale;
        const glm::dvec3 direction = glm::transpose(chart_from_model) * chart_from_head(heads[i]);
        const auto hit = scenery.first(origin, direction);
        if (hit.has_value() != (rays[i].fate == render::RayFate::object)) {
            ++different;
        } else if (hit) {
            ++hits;
            CHECK_THAT(glm::length(rays[i].direction), WithinRel(model.scale * hit->distance, 1e-4));
            CHECK_THAT(rays[i].wavelength_ratio, WithinRel(1.0, 1e-12));
            if (hits % 8 == 0) {
                // The rays' own places differ by 1e-4 of the way, over textures and shadows' edges.
                const glm::dvec3 expected = colour.seen(render::surface_light(square, spectra, scenery, *hit), 1.0);
                recoloured += glm::length(rays[i].light - expected) < 0.02 * glm::length(expected) ? 0 : 1;
            }
        }
    }
    CHECK(recoloured <= 1);
    CHECK(hits > 50);
    // Embree's single precision may see a ray along an edge either way.
    CHECK(different <= 2);
}

TEST_CASE("a model on a world line is seen with the light's delay") {
    content::TracedScenario scenario = flat();
    content::TracedModel model;
    model.file = "generated:square";
    model.scale = 0.002; // 0.12 wide
    // Passes (0, 5, 0) at t = -5 at half the speed of light, then stops at once: the eye at t = 0 sees it just there.
    model.path = {{-25.0, {-10.0, 5.0, 0.0}}, {-5.0, {0.0, 5.0, 0.0}}};
    scenario.models = {model};
    scenario.camera.moment.position = {0.0, 0.0, 0.5};
    const auto ahead = [&](double time) {
        content::TracedScenario at = scenario;
        at.camera.moment.time = time;
        const render::TracedScene scene(at, {});
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.0, 5.0, -0.5));
        return rays_of(scene, at, {{n.x, n.z, -n.y}})[0];
    };
    CHECK(ahead(1.0).fate == render::RayFate::object);
    CHECK_THAT(ahead(1.0).wavelength_ratio, WithinRel(1.0, 1e-12)); // at rest
    const render::TracedRay moving = ahead(-0.15);                  // before, as seen
    REQUIRE(moving.fate == render::RayFate::object);
    // Moving across the view at 0.5 c: D = gamma (1 - beta.n), nearly the time dilation alone.
    CHECK_THAT(moving.wavelength_ratio, WithinRel(1.0 / std::sqrt(0.75), 0.03));
    CHECK(ahead(-3.0).fate == render::RayFate::sky); // it has not come yet, as seen
}
