#include "sim/lorentz.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <glm/matrix.hpp>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using sim_tests::RandomFrames;

namespace {

using HeadFrame = sim::Lorentz<sim::World, sim::Head>;

/// The other route to aberration: the spinor of the direction times (Lambda^dagger)^-1 (Penrose 1959).
sim::SeenLight seen_by_spinor(const HeadFrame& world_from_head, const glm::dvec3& n) {
    const bool north = n.z >= 0.0;
    const sim::Complex up = north ? sim::Complex{1.0 + n.z, 0.0} : sim::Complex{n.x, -n.y};
    const sim::Complex down = north ? sim::Complex{n.x, n.y} : sim::Complex{1.0 - n.z, 0.0};
    const sim::SpinMatrix s = dagger(adjugate(world_from_head.spin));
    const sim::Complex world_up = s.a * up + s.b * down;
    const sim::Complex world_down = s.c * up + s.d * down;
    const double norm = norm2(world_up) + norm2(world_down);
    const sim::Complex cross = conj(world_up) * world_down;
    return {glm::dvec3(2.0 * cross.re, 2.0 * cross.im, norm2(world_up) - norm2(world_down)) / norm,
            norm / (norm2(up) + norm2(down))};
}

double largest_difference(const glm::dmat3& p, const glm::dmat3& q) {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            largest = std::max(largest, std::abs(p[i][j] - q[i][j]));
        }
    }
    return largest;
}

/// The rotation matrix of a Lorentz frame without a boost, through its tetrad.
glm::dmat3 rotation_matrix(const sim::Lorentz<sim::Boosted, sim::Head>& rotation) {
    const auto axes = sim::tetrad(rotation);
    return {axes[1].space, axes[2].space, axes[3].space};
}

} // namespace

TEST_CASE("a frame splits into the boost and the rotation that it was made of, at any rapidity") {
    RandomFrames random;
    for (const double xi : {1e-12, 1e-6, 0.01, 0.5, 2.0, 10.0, 20.0, 30.0, 100.0}) {
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 along = random.unit();
            const auto rotation =
                sim::rotation<sim::Boosted, sim::Head>(sim::Radians(random.uniform(0.0, 6.28)), random.unit());
            const sim::BoostAndRotation parts =
                sim::split(sim::boost<sim::World, sim::Boosted>(sim::Rapidity(xi), along) * rotation);
            INFO("rapidity " << xi);
            // Entries of Lambda carry roundings of 1e-16 each: absolute in xi and the rotation; the direction of a
            // motion as slow as the roundings is lost in them.
            CHECK_THAT(parts.xi.value, WithinAbs(xi, 2e-15 * std::max(1.0, xi)));
            CHECK(glm::length(parts.along - along) < 4e-15 * std::max(1.0, 1.0 / xi));
            CHECK(largest_difference(parts.boosted_from_head, rotation_matrix(rotation)) < 3e-15);
            CHECK(largest_difference(glm::transpose(parts.boosted_from_head) * parts.boosted_from_head,
                                     glm::dmat3(1.0)) < 2e-15);
        }
    }
}

TEST_CASE("half angles and spinors see the same sky") {
    RandomFrames random;
    for (const double xi : {0.0, 1e-3, 0.7, 2.0, 5.0}) {
        for (int i = 0; i < 200; ++i) {
            const HeadFrame frame = random.frame<sim::World, sim::Head>(xi);
            const glm::dvec3 n = random.unit();
            const sim::SeenLight half = sim::see(frame, {n});
            const sim::SeenLight spinor = seen_by_spinor(frame, n);
            // The spinor sum cancels by up to e^(xi/2) near straight ahead: e^5 * 1e-16 and a few roundings.
            CHECK(glm::length(half.world_direction - spinor.world_direction) < 1e-13);
            CHECK_THAT(half.wavelength_ratio, WithinRel(spinor.wavelength_ratio, 3e-13));
            CHECK_THAT(glm::length(half.world_direction), WithinAbs(1.0, 1e-15));
        }
    }
}

TEST_CASE("where a direction is seen is the inverse of what is seen there") {
    RandomFrames random;
    for (const double xi : {0.0, 0.3, 3.0, 8.0}) {
        for (int i = 0; i < 200; ++i) {
            const sim::BoostAndRotation eye = sim::split(random.frame<sim::World, sim::Head>(xi));
            const glm::dvec3 world = random.unit();
            const sim::SeenFrom seen = sim::where_seen(eye, {world});
            const sim::SeenLight back = sim::see(eye, {seen.head_direction});
            // Looking ahead magnifies angles by e^xi, and with them the rounding of the head's direction.
            const double tolerance = 1e-15 * std::exp(xi) + 2e-15;
            CHECK(glm::length(back.world_direction - world) < tolerance);
            CHECK_THAT(back.wavelength_ratio, WithinRel(seen.wavelength_ratio, 2.0 * tolerance));
        }
    }
}

TEST_CASE("D is e^-xi ahead, e^xi behind and gamma aside") {
    RandomFrames random;
    for (const double xi : {0.0, 0.1, 1.0, 5.0, 15.0, 30.0}) {
        const glm::dvec3 along = random.unit();
        const sim::BoostAndRotation eye{sim::Rapidity(xi), along, glm::dmat3(1.0)};
        const glm::dvec3 aside = glm::normalize(glm::cross(along, random.unit()));
        // The chord from `along` to itself is exactly zero, so D ahead has only the roundings of exp.
        CHECK_THAT(sim::see(eye, {along}).wavelength_ratio, WithinRel(std::exp(-xi), 4e-16 * (1.0 + xi)));
        CHECK_THAT(sim::see(eye, {-along}).wavelength_ratio, WithinRel(std::exp(xi), 2e-15));
        // `aside` is square to the motion to 2e-16, which is how far D can be from gamma.
        CHECK_THAT(sim::see(eye, {aside}).wavelength_ratio, WithinRel(std::cosh(xi), 2e-15));
    }
}

TEST_CASE("circles on the sky stay circles, and solid angles change by D squared") {
    RandomFrames random;
    const sim::BoostAndRotation eye = sim::split(random.frame<sim::World, sim::Head>(1.7));
    const glm::dvec3 centre = random.unit();
    const glm::dvec3 first = glm::normalize(glm::cross(centre, random.unit()));
    const glm::dvec3 second = glm::cross(centre, first);
    constexpr double radius = 0.4;
    std::array<glm::dvec3, 24> seen;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double turn = 0.2618 * static_cast<double>(i);
        const glm::dvec3 rim =
            std::cos(radius) * centre + std::sin(radius) * (std::cos(turn) * first + std::sin(turn) * second);
        seen[i] = sim::where_seen(eye, {rim}).head_direction;
    }
    // A circle on a sphere is where a plane cuts it: all points lie in the plane of the first, ninth and seventeenth.
    const glm::dvec3 normal = glm::normalize(glm::cross(seen[8] - seen[0], seen[16] - seen[0]));
    for (const glm::dvec3& point : seen) {
        CHECK_THAT(glm::dot(normal, point - seen[0]), WithinAbs(0.0, 3e-15)); // roundings of unit vectors
    }

    // A small triangle's area: second differences of the map leave an error of the order of its size.
    constexpr double size = 1e-5;
    const auto at = [&](double u, double v) { return glm::normalize(centre + size * (u * first + v * second)); };
    const auto area = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
        return 0.5 * glm::length(glm::cross(q - p, r - p));
    };
    const double world_area = area(at(-1, -1), at(1, -1), at(0, 2));
    const auto head = [&](double u, double v) { return sim::where_seen(eye, {at(u, v)}).head_direction; };
    const double head_area = area(head(-1, -1), head(1, -1), head(0, 2));
    const double ratio = sim::where_seen(eye, {centre}).wavelength_ratio;
    CHECK_THAT(head_area / world_area, WithinRel(ratio * ratio, 1e-4));
}
