#include "render/offline/traced/bent_rays.h"
#include "render/offline/traced/disk_light.h"
#include "sim/spacetime/observer.h"

#include <catch2/catch_test_macros.hpp>

#include <glm/geometric.hpp>

#include <cmath>

namespace {

/// The visitor shown every step of one ray, without lanes and bounds.
template <class Spacetime>
render::TracedRay one_by_one(const Spacetime& spacetime, const sim::Components<double>& eye, const sim::Tetrad& tetrad,
                             const sim::RaySettings& settings, const render::TracedMatter& matter,
                             const glm::dvec3& seen) {
    render::TracedRay ray;
    const sim::RayResult result = sim::follow_ray(spacetime, sim::seen_photon(spacetime, eye, tetrad, seen), settings,
                                                  render::MatterVisitor(spacetime, matter, ray));
    if (result.outcome != sim::RayOutcome::hit_object) {
        return render::traced_ray(result.outcome, result.infinity, result.steps);
    }
    ray.steps = static_cast<std::int32_t>(result.steps);
    return ray;
}

content::TracedScenario scenario_with_matter() {
    content::TracedScenario scenario;
    content::TracedSphere still;
    still.centre = {-9.0, 2.0, 1.0};
    still.radius = 2.0;
    content::TracedSphere moving;
    moving.centre = {-0.2, 4.8, 2.5}; // at (-2, -6, 2.5) as seen
    moving.velocity = {0.1, 0.6, 0.0};
    moving.radius = 2.0;
    scenario.spheres = {still, moving};
    content::TracedModel ship;
    ship.file = "generated:square";
    ship.scale = 0.05;
    ship.path = {{-60.0, {10.0, 4.0, 1.5}}, {0.0, {10.0, -4.0, 1.5}}};
    scenario.models = {ship};
    return scenario;
}

template <class Spacetime>
void check_same_bits(const Spacetime& spacetime, const render::TracedMatter& matter, bool with_disk) {
    const sim::Components<double> eye{3.0, 18.0, 0.0, 2.0};
    const auto velocity = sim::observer_velocity(spacetime, eye, sim::ObserverKind::at_rest);
    REQUIRE(velocity);
    const glm::dvec3 look = glm::normalize(glm::dvec3(-9.0, 0.0, -1.0));
    const glm::dvec3 up = glm::normalize(glm::dvec3(-1.0, 0.0, 9.0));
    const sim::Tetrad tetrad = sim::camera_tetrad(spacetime, eye, *velocity, look, up);
    sim::RaySettings settings;
    settings.step = 0.2;
    settings.escape_radius = 60.0;
    settings.nothing_near_horizon = false;
    const render::BentRays<Spacetime> rays(spacetime, eye, tetrad, settings, matter);
    std::vector<glm::dvec3> directions;
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 50; ++column) {
            directions.push_back(glm::normalize(glm::dvec3(0.04 * (column - 24.6), 0.04 * (row - 19.6), -1.0)));
        }
    }
    std::vector<render::TracedRay> found(directions.size());
    rays.trace(directions, found, 0);
    std::array<int, 4> met{};
    int disk = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const render::TracedRay ray = one_by_one(spacetime, eye, tetrad, settings, matter, directions[i]);
        INFO("ray " << i);
        REQUIRE(found[i].fate == ray.fate);
        REQUIRE(found[i].steps == ray.steps);
        REQUIRE(found[i].object == ray.object);
        REQUIRE(found[i].direction == ray.direction);
        REQUIRE(found[i].light == ray.light);
        REQUIRE(found[i].wavelength_ratio == ray.wavelength_ratio);
        met[ray.object] += ray.fate == render::RayFate::object ? 1 : 0;
        disk += ray.fate == render::RayFate::disk ? 1 : 0;
    }
    CHECK(met[0] > 10);
    CHECK(met[1] > 10);
    CHECK(met[2] > 5);
    CHECK((disk > 50) == with_disk);
}

} // namespace

TEST_CASE("matter on the way is met on lanes as by rays one by one that look at every step, to the bit") {
    const content::TracedScenario scenario = scenario_with_matter();
    std::vector<std::string> notes;
    const render::TracedObjects objects(scenario, notes);
    const render::TracedColour colour(5762.0);
    const render::DiskLight disk({}, 1.0, 0.9, colour);
    render::TracedMatter matter{&objects, &disk, &colour};
    check_same_bits(sim::Kerr(1.0, 0.9), matter, true);
    matter.disk = nullptr;
    check_same_bits(sim::Minkowski{}, matter, false);
}
