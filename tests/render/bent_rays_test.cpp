#include "render/offline/traced/bent_rays.h"
#include "render/offline/traced/disk_light.h"
#include "render/offline/traced/hole_rays.h"
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

/// An eye at rest 18 M from the hole, and a grid of directions.
template <class Spacetime>
struct View {
    Spacetime spacetime;
    sim::Components<double> eye{3.0, 18.0, 0.0, 2.0};
    sim::Tetrad tetrad;
    sim::RaySettings settings;
    std::vector<glm::dvec3> directions;

    explicit View(const Spacetime& chosen) : spacetime(chosen) {
        const auto velocity = sim::observer_velocity(spacetime, eye, sim::ObserverKind::at_rest);
        REQUIRE(velocity);
        const glm::dvec3 look = glm::normalize(glm::dvec3(-9.0, 0.0, -1.0));
        const glm::dvec3 up = glm::normalize(glm::dvec3(-1.0, 0.0, 9.0));
        tetrad = sim::camera_tetrad(spacetime, eye, *velocity, look, up);
        settings.step = 0.2;
        settings.escape_radius = 80.0;
        settings.nothing_near_horizon = false;
        for (int row = 0; row < 40; ++row) {
            for (int column = 0; column < 50; ++column) {
                directions.push_back(glm::normalize(glm::dvec3(0.04 * (column - 24.6), 0.04 * (row - 19.6), -1.0)));
            }
        }
    }
};

template <class Spacetime>
void check_same_bits(const Spacetime& spacetime, const render::TracedMatter& matter, bool with_disk) {
    const View view(spacetime);
    const render::BentRays<Spacetime> rays(spacetime, view.eye, view.tetrad, view.settings, matter);
    std::vector<render::TracedRay> found(view.directions.size());
    rays.trace(view.directions, found, 0);
    std::array<int, 4> met{};
    int disk = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const render::TracedRay ray =
            one_by_one(spacetime, view.eye, view.tetrad, view.settings, matter, view.directions[i]);
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

/// Rays in Mino time against Hamilton's equations, of which the bits above are known.
template <class Spacetime>
void check_same_meetings(const Spacetime& spacetime, const render::TracedMatter& matter) {
    View view(spacetime);
    const auto bent =
        std::make_shared<const render::BentRays<Spacetime>>(spacetime, view.eye, view.tetrad, view.settings, matter);
    const sim::MinoHole hole = *sim::mino_hole(spacetime);
    const render::HoleRays rays(spacetime, sim::mino_eye(spacetime, hole, view.eye, view.tetrad), view.settings, matter,
                                bent);
    std::vector<render::TracedRay> found(view.directions.size());
    std::vector<render::TracedRay> expected(view.directions.size());
    rays.trace(view.directions, found, 1);
    bent->trace(view.directions, expected, 1);
    int different = 0;
    std::array<int, 4> met{};
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i].fate != expected[i].fate || found[i].object != expected[i].object) {
            ++different;
            continue;
        }
        INFO("ray " << i << ", fate " << static_cast<int>(found[i].fate));
        met[found[i].object] += found[i].fate == render::RayFate::object ? 1 : 0;
        // Both are good to their own estimates; a ray that grazes a surface meets it nearly anywhere.
        const double good = 4.0 * (found[i].error + expected[i].error) + 2e-4;
        if (found[i].fate != render::RayFate::captured && good < 0.01) {
            CHECK(glm::length(found[i].direction - expected[i].direction) <
                  10.0 * good * glm::length(expected[i].direction));
            CHECK(std::abs(found[i].wavelength_ratio / expected[i].wavelength_ratio - 1.0) < good);
        }
    }
    CHECK(met[0] > 10);
    CHECK(met[1] > 10);
    CHECK(met[2] > 5);
    CHECK(different <= 20); // of 2000: rays along an outline
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

TEST_CASE("in Mino time matter is met where Hamilton's equations meet it, moving matter too") {
    content::TracedScenario scenario = scenario_with_matter();
    std::vector<std::string> notes;
    const render::TracedColour colour(5762.0);
    const render::DiskLight disk({}, 1.0, 0.9, colour);
    for (const bool still : {false, true}) {
        if (still) {
            scenario.spheres[1].centre = {-2.0, -6.0, 2.5};
            scenario.spheres[1].velocity = {};
            scenario.models[0].path.clear();
            scenario.models[0].position = {10.0, -3.0, 1.5};
        }
        const render::TracedObjects objects(scenario, notes);
        INFO("still " << still);
        CHECK(objects.moving_bounds().empty() == still);
        check_same_meetings(sim::Kerr(1.0, 0.9), {&objects, &disk, &colour});
        check_same_meetings(sim::Schwarzschild(1.0), {&objects, nullptr, &colour});
    }
}

TEST_CASE("light goes straight to a warp bubble and away from it as step by step") {
    content::TracedScenario scenario;
    content::TracedSphere still;
    still.centre = {-20.0, 2.0, 1.0};
    still.radius = 4.0;
    content::TracedSphere moving;
    moving.centre = {-10.0, 8.0, 2.5};
    moving.velocity = {0.1, 0.5, 0.0};
    moving.radius = 2.0;
    scenario.spheres = {still, moving};
    std::vector<std::string> notes;
    const render::TracedObjects objects(scenario, notes);
    const render::TracedColour colour(5762.0);
    const render::TracedMatter matter{&objects, nullptr, &colour};
    for (const double speed : {0.5, 1.5}) {
        // The eye at x = 18 sees the slower bubble come from x = -15; the faster one outruns its light.
        View view(sim::Alcubierre(speed, 1.8, 3.0));
        view.settings.step = 0.1;
        view.settings.tail_error = 1e-7;
        const render::BentRays<sim::Alcubierre> rays(view.spacetime, view.eye, view.tetrad, view.settings, matter);
        std::vector<render::TracedRay> found(view.directions.size());
        rays.trace(view.directions, found, 0);
        int met = 0;
        int different = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const render::TracedRay ray =
                one_by_one(view.spacetime, view.eye, view.tetrad, view.settings, matter, view.directions[i]);
            if (found[i].fate != ray.fate || found[i].object != ray.object) {
                ++different;
                continue;
            }
            INFO("speed " << speed << ", ray " << i << ", fate " << static_cast<int>(ray.fate));
            met += ray.fate == render::RayFate::object ? 1 : 0;
            if (ray.fate == render::RayFate::sky || ray.fate == render::RayFate::object) {
                // Nine in ten rays are good to 1e-7; those along the wall, and places that a ray grazes, to less.
                CHECK(glm::length(found[i].direction - ray.direction) < 1e-4 * glm::length(ray.direction));
                CHECK(std::abs(found[i].wavelength_ratio / ray.wavelength_ratio - 1.0) < 1e-4);
            }
        }
        CHECK(met > 8);
        CHECK(different <= 4); // of 2000: rays along an outline
    }
}
