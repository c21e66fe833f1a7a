#include "render/offline/traced/traced_scene.h"
#include "sim/spacetime/bundle.h"
#include "tests/content/temporary_folder.h"
#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

content::TracedScenario scenario_of(const std::string& spacetime, std::map<std::string, double> parameters,
                                    const glm::dvec3& position) {
    content::TracedScenario scenario;
    scenario.name = "test";
    scenario.spacetime = {spacetime, std::move(parameters)};
    scenario.camera.moment.position = position;
    return scenario;
}

std::vector<render::TracedRay> rays_of(const content::TracedScenario& scenario, const render::CameraLens& lens,
                                       const std::vector<glm::dvec3>& directions,
                                       const render::TraceAccuracy& accuracy = {}) {
    const render::TracedScene scene(scenario, accuracy);
    std::vector<render::TracedRay> rays(directions.size());
    scene.rays(render::camera_pose(scenario, 0.0), lens)->trace(directions, rays, 0);
    return rays;
}

std::vector<std::vector<double>> table(const std::string& name) {
    std::ifstream file(tests::source_folder() + "/tests/reference/" + name);
    std::vector<std::vector<double>> rows;
    std::string line;
    std::getline(file, line); // the header
    while (std::getline(file, line)) {
        std::vector<double> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) {
            row.push_back(std::strtod(cell.c_str(), nullptr)); // a dark row has no numbers: 0
        }
        rows.push_back(row);
    }
    return rows;
}

/// Angle that light with impact parameter b turns about a Schwarzschild hole of mass 1 between radii r1 and r2, over
/// its periapsis: 2 int dphi/du by the midpoint rule in w, u = u_p - w^2, which takes the root's singularity away.
double turned(double b, double r1, double r2) {
    const auto rest = [&](double u) { return 1.0 / (b * b) - u * u + 2.0 * u * u * u; };
    double low = 0.0;
    double high = 1.0 / 3.0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (rest(middle) > 0.0 ? low : high) = middle;
    }
    const double periapsis = 0.5 * (low + high);
    const auto leg = [&](double r) {
        constexpr int steps = 20000;
        const double end = std::sqrt(periapsis - 1.0 / r);
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double w = end * (i + 0.5) / steps;
            const double u = periapsis - w * w;
            // (rest(u) - rest(u_p))/(u_p - u), multiplied out.
            const double slope = (u + periapsis) - 2.0 * (u * u + u * periapsis + periapsis * periapsis);
            sum += 2.0 / std::sqrt(slope) * end / steps;
        }
        return sum;
    };
    return leg(r1) + leg(r2);
}

} // namespace

TEST_CASE("Einstein's ring has the radius that the orbit integral gives it") {
    content::TracedScenario scenario = scenario_of("schwarzschild", {}, {200.0, 0.0, 0.0});
    content::TracedSphere source;
    source.centre = {-400.0, 0.0, 0.0};
    source.radius = 0.5;
    source.emission = glm::dvec3(1.0);
    scenario.spheres = {source};
    // The b with which light from just behind turns by pi on its way.
    double low = 10.0;
    double high = 60.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (turned(middle, 200.0, 400.0) > pi ? low : high) = middle;
    }
    const double expected = std::asin(0.5 * (low + high) * std::sqrt(1.0 - 2.0 / 200.0) / 200.0);
    // The built-in scenario's picture: 26 degrees over 1920 pixels.
    const double pixel = 26.0 / 180.0 * pi / 1920.0;
    const render::CameraLens lens{content::Projection::perspective, 26.0 / 180.0 * pi, 1920, 1080};
    std::vector<glm::dvec3> directions;
    for (int i = -200; i <= 200; ++i) {
        const double angle = expected + 0.02 * i * pixel;
        directions.emplace_back(std::sin(angle) * 0.6, std::sin(angle) * 0.8, -std::cos(angle));
    }
    const auto rays = rays_of(scenario, lens, directions, {1e-6});
    double first = 0.0;
    double last = 0.0;
    int hits = 0;
    for (int i = 0; i <= 400; ++i) {
        if (rays[static_cast<std::size_t>(i)].fate == render::RayFate::object) {
            first = hits++ == 0 ? i : first;
            last = i;
        }
    }
    REQUIRE(hits > 3);
    // The ball's image is a narrow ring around the radius of its centre: the middle of its width, to a tenth of a
    // pixel.
    CHECK_THAT(0.02 * (0.5 * (first + last) - 200.0), WithinAbs(0.0, 0.1));
}

TEST_CASE("the shadow of a Kerr hole follows the critical curve within a pixel of 1920") {
    // A far camera: the table's observer is at infinity; at r = 1e5 the outline differs by order M/r of itself.
    constexpr double far = 1e5;
    constexpr double pixel = 20.0 / 1920.0; // a picture 20 M wide
    int points = 0;
    const auto rows = table("kerr_critical_curve.csv");
    for (std::size_t i = 0; i < rows.size(); i += 4) { // every fourth, to save time
        const std::vector<double>& row = rows[i];
        const double inclination = row[1] / 180.0 * pi;
        const glm::dvec3 place = far * glm::dvec3(std::sin(inclination), 0.0, std::cos(inclination));
        const content::TracedScenario scenario = scenario_of("kerr", {{"spin", row[0]}}, place);
        const glm::dvec2 edge(row[3], row[4]);
        const glm::dvec2 middle(2.0 * row[0] * std::sin(inclination), 0.0); // about the shadow's centre
        const glm::dvec2 outwards = glm::normalize(edge - middle);
        std::vector<glm::dvec3> directions;
        for (const double offset : {-pixel, pixel}) {
            const glm::dvec2 place_seen = (edge + offset * outwards) / far;
            directions.push_back(glm::normalize(glm::dvec3(place_seen, -1.0)));
        }
        const render::CameraLens lens{content::Projection::perspective, 20.0 / far, 1920, 1080};
        const auto rays = rays_of(scenario, lens, directions, {1e-6});
        INFO("a " << row[0] << ", inclination " << row[1] << ", alpha " << row[3] << ", beta " << row[4]);
        CHECK(rays[0].fate == render::RayFate::captured);
        CHECK(rays[1].fate == render::RayFate::sky);
        ++points;
    }
    CHECK(points > 5);
}

TEST_CASE("from the bridge of a warp ship every direction and frequency is as the table has it") {
    int rows = 0;
    for (const std::vector<double>& row : table("warp_bridge.csv")) {
        content::TracedScenario scenario =
            scenario_of("alcubierre", {{"speed", row[0]}, {"radius", row[1]}, {"sigma", row[2]}}, glm::dvec3(0.0));
        scenario.camera.observer = content::ObserverKind::free_falling;
        scenario.camera.moment.look = {1.0, 0.0, 0.0};
        const render::CameraLens lens{content::Projection::fisheye, 6.0, 100, 100};
        const glm::dvec3 direction(std::sin(row[3]), 0.0, -std::cos(row[3]));
        const render::TracedRay ray = rays_of(scenario, lens, {direction})[0];
        INFO("v " << row[0] << ", psi " << row[3]);
        ++rows;
        if (row[4] == 1.0) {
            CHECK_FALSE(render::is_sky(ray.fate));
            continue;
        }
        REQUIRE(ray.fate == render::RayFate::sky);
        // The picture's own accuracy, 1e-4 for nine in ten rays; a ray at the dark cone's edge has more.
        CHECK_THAT(std::abs(std::atan2(std::hypot(ray.direction.y, ray.direction.z), ray.direction.x)),
                   WithinAbs(std::abs(row[5]), 1e-3));
        // Absolute: at the dark cone's edge the frequency itself goes to 0, and its direction is only known to 1e-4.
        CHECK_THAT(1.0 / ray.wavelength_ratio, WithinAbs(1.0 + row[0] * ray.direction.x, 1e-3));
    }
    CHECK(rows > 5);
}

TEST_CASE("a disk is the same by rays in Mino time and by Hamilton's equations") {
    content::TracedScenario scenario = scenario_of("kerr", {{"spin", 0.99}}, {25.0, 0.0, 5.0});
    scenario.disk.emplace();
    scenario.disk->texture = 0.5;
    content::TracedScenario with_ball = scenario; // a ball behind the camera: every ray is followed on its own
    content::TracedSphere ball;
    ball.centre = {60.0, 0.0, 0.0};
    with_ball.spheres = {ball};
    const render::CameraLens lens{content::Projection::perspective, 1.0, 160, 90};
    std::vector<glm::dvec3> directions;
    for (int row = 0; row < 18; ++row) {
        for (int column = 0; column < 32; ++column) {
            directions.push_back(*render::head_direction(lens, {5.0 * column + 2.5, 5.0 * row + 2.5}));
        }
    }
    const auto fast = rays_of(scenario, lens, directions, {1e-6});
    const auto slow = rays_of(with_ball, lens, directions, {1e-6});
    int disk = 0;
    int different = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        different += fast[i].fate != slow[i].fate ? 1 : 0;
        if (fast[i].fate == render::RayFate::disk && slow[i].fate == render::RayFate::disk) {
            ++disk;
            // Nine in ten within 1e-6 rad at infinity; on the disk, seen edge on, that is magnified.
            CHECK(glm::length(fast[i].direction - slow[i].direction) < 1e-2 * glm::length(fast[i].direction));
            CHECK_THAT(fast[i].wavelength_ratio, WithinRel(slow[i].wavelength_ratio, 1e-3));
        }
    }
    CHECK(disk > 100);
    CHECK(different <= 2); // rays along an edge
}

TEST_CASE("a falling eye sees the sky behind it shifted as theory has it, outside and inside the horizon") {
    for (const double r : {2.5, 2.0, 1.5, 0.5}) {
        content::TracedScenario scenario = scenario_of("schwarzschild", {}, {r, 0.0, 0.0});
        scenario.camera.observer = content::ObserverKind::free_falling;
        const render::CameraLens lens{content::Projection::fisheye, 6.2, 100, 100};
        // Outwards, against the fall: Doppler shift of a faller from rest at infinity, D = 1 + sqrt(2 M/r).
        const auto rays = rays_of(scenario, lens, {{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}});
        INFO("r " << r);
        REQUIRE(rays[0].fate == render::RayFate::sky);
        CHECK_THAT(rays[0].wavelength_ratio, WithinRel(1.0 + std::sqrt(2.0 / r), 1e-6));
        CHECK(rays[1].fate == render::RayFate::captured);
    }
}

namespace {

/// Solid angle seen over solid angle of sky, by differences of rays of the fourth order.
double magnification_by_rays(const render::RaySource& rays, const glm::dvec3& direction) {
    constexpr double h = 2e-3;
    const auto across = sim::axes_across(direction);
    std::array<glm::dvec3, 2> slope{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::array<double, 4> offsets{-2.0 * h, -h, h, 2.0 * h};
        const std::array<double, 4> weights{1.0, -8.0, 8.0, -1.0};
        std::vector<glm::dvec3> directions;
        for (const double offset : offsets) {
            directions.push_back(std::cos(offset) * direction + std::sin(offset) * across.at(axis));
        }
        std::vector<render::TracedRay> traced(directions.size());
        rays.trace(directions, traced, 0);
        for (std::size_t i = 0; i < traced.size(); ++i) {
            REQUIRE(render::is_sky(traced[i].fate));
            slope.at(axis) += weights.at(i) / (12.0 * h) * traced[i].direction;
        }
    }
    return 1.0 / glm::length(glm::cross(slope[0], slope[1]));
}

} // namespace

TEST_CASE("a bundle magnifies as neighbouring rays diverge, near a hole, on an orbit, through a wormhole, in a warp") {
    std::vector<content::TracedScenario> scenarios{
        scenario_of("schwarzschild", {}, {20.0, 0.0, 0.0}), scenario_of("kerr", {{"spin", 0.9}}, {15.0, 0.0, 0.0}),
        scenario_of("wormhole", {}, {8.0, 0.0, 0.0}), scenario_of("alcubierre", {{"speed", 0.5}}, {-0.1, 0.0, 0.0})};
    scenarios[1].camera.observer = content::ObserverKind::circular;
    const render::CameraLens lens{content::Projection::fisheye, 6.2, 100, 100};
    for (const content::TracedScenario& scenario : scenarios) {
        const render::TracedScene scene(scenario, {1e-9});
        const render::CameraPose pose = render::camera_pose(scenario, 0.0);
        const auto rays = scene.rays(pose, lens);
        const render::BundleMagnification magnification = scene.magnification(pose);
        for (const double angle : {0.45, 0.6, 1.0, 1.7, 2.9}) { // from ahead: the hole's shadow ends at 0.25 and 0.33
            const glm::dvec3 direction(std::sin(angle) * std::cos(7.0 * angle), std::sin(angle) * std::sin(7.0 * angle),
                                       -std::cos(angle));
            INFO(scenario.spacetime.name << ", " << angle);
            // What the bundles' own step leaves, as they say; the rays' differences err by 1e-9 over 2e-3 rad.
            CHECK_THAT(magnification(direction), WithinRel(magnification_by_rays(*rays, direction), 1e-4));
        }
    }
}

TEST_CASE("a picture through a user's own metric has the rays of the built-in chart of the same hole") {
    const samples::TemporaryFolder folder;
    // Schwarzschild in isotropic coordinates: r = rho (1 + M/2 rho)^2.
    folder.write("isotropic.toml", R"toml(flat_radius = 3e4
[parameters]
M = 2.0
[definitions]
q = "M/(2*sqrt(x^2 + y^2 + z^2))"
[metric]
tt = "-((1 - q)/(1 + q))^2"
xx = "(1 + q)^4"
yy = "(1 + q)^4"
zz = "(1 + q)^4"
)toml");
    const double r = 10.0;
    const double rho = 0.5 * (r - 1.0 + std::sqrt(r * r - 2.0 * r));
    const content::TracedScenario own =
        scenario_of((folder.path() / "isotropic.toml").string(), {{"M", 1.0}}, {rho, 0.0, 0.0});
    const content::TracedScenario built_in = scenario_of("schwarzschild", {}, {r, 0.0, 0.0});
    const render::CameraLens lens{content::Projection::fisheye, 6.2, 100, 100};
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 64; ++i) {
        // From towards the hole (in its shadow up to 0.49 rad) to away from it, all round.
        const double psi = (i + 0.5) * pi / 64.0;
        directions.emplace_back(std::sin(psi) * std::cos(2.4 * i), std::sin(psi) * std::sin(2.4 * i), -std::cos(psi));
    }
    const auto through_own = rays_of(own, lens, directions, {1e-6});
    const auto expected = rays_of(built_in, lens, directions, {1e-6});
    int compared = 0;
    int captured = 0;
    int beyond = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        REQUIRE(through_own[i].fate == expected[i].fate);
        captured += expected[i].fate == render::RayFate::captured ? 1 : 0;
        if (expected[i].fate == render::RayFate::sky) {
            ++compared;
            // Both have an error of 1e-6; 2e-8 is left at 3e4 M, where the file calls it flat.
            beyond += glm::length(through_own[i].direction - expected[i].direction) < 2.1e-6 ? 0 : 1;
            // -p_t = E is conserved to the last bits, by RK4 too.
            CHECK_THAT(through_own[i].wavelength_ratio, WithinRel(std::sqrt(1.0 - 2.0 / r), 1e-9));
        }
    }
    CHECK(captured > 5);
    CHECK(compared > 50);
    CHECK(beyond <= 6); // the step is chosen for nine in ten rays of the picture
}
