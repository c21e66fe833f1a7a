#include "sim/level.h"
#include "sim/look.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using Catch::Matchers::WithinAbs;

namespace {

constexpr double rounding = 1e-15; // a few operations on unit vectors

void check_equal(const glm::dvec3& a, const glm::dvec3& b) {
    for (int i = 0; i < 3; ++i) {
        CHECK_THAT(a[i], WithinAbs(b[i], rounding));
    }
}

glm::dvec3 seen(const sim::Lorentz<sim::World, sim::Head>& frame, const glm::dvec3& in_head) {
    return sim::see(frame, {in_head}).world_direction;
}

} // namespace

TEST_CASE("a camera looking along -z has the world's axes") {
    CHECK(sim::camera_axes({0.0, 0.0, -1.0}) == glm::dmat3(1.0));
}

TEST_CASE("camera axes are a right-handed triad that looks where told, straight up and down included") {
    const std::array looks{glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(1.0, 0.0, 0.0),
                           glm::normalize(glm::dvec3(-0.3, 0.8, 0.5))};
    for (const glm::dvec3& look : looks) {
        const glm::dmat3 axes = sim::camera_axes(look);
        check_equal(axes[2], -look);
        check_equal(glm::cross(axes[0], axes[1]), axes[2]);
        CHECK_THAT(glm::dot(axes[0], axes[1]), WithinAbs(0.0, rounding));
        CHECK(axes[1].y >= 0.0);
    }
    check_equal(sim::camera_axes({0.0, 1.0, 0.0})[1], {0.0, 0.0, 1.0});
    check_equal(sim::camera_axes({0.0, -1.0, 0.0})[1], {0.0, 0.0, -1.0});
}

TEST_CASE("an eye at rest that looks east sees east ahead, south to its right and the sky above") {
    const auto frame = sim::world_from_looking<sim::Head>(sim::Rapidity(0.0), {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0});
    check_equal(seen(frame, {0.0, 0.0, -1.0}), {1.0, 0.0, 0.0});
    check_equal(seen(frame, {1.0, 0.0, 0.0}), {0.0, 0.0, 1.0});
    check_equal(seen(frame, {0.0, 1.0, 0.0}), {0.0, 1.0, 0.0});
}

TEST_CASE("the look does not change the motion") {
    const glm::dvec3 heading = glm::normalize(glm::dvec3(0.2, -0.5, 0.7));
    const auto frame = sim::world_from_looking<sim::Head>(sim::Rapidity(1.25), heading, {0.0, 0.0, 1.0});
    const sim::FourVector<sim::World> velocity = sim::four_velocity(frame);
    check_equal(velocity.space / std::sinh(1.25), heading);
}

TEST_CASE("a level seat's up is as near the world's as a roll can bring it, at any speed") {
    for (const double rapidity : {0.0, 1.0, 4.0}) {
        for (const double roll : {-3.0, -1.2, 0.0, 0.4, 2.5}) {
            for (const double pitch : {-1.0, 0.0, 0.7}) {
                using sim::Boosted;
                using sim::Vehicle;
                const auto turned = sim::rotation<Boosted, Vehicle>(sim::Radians(0.8), {0.0, 1.0, 0.0}) *
                                    sim::rotation<Vehicle, Vehicle>(sim::Radians(pitch), {1.0, 0.0, 0.0}) *
                                    sim::rotation<Vehicle, Vehicle>(sim::Radians(roll), {0.0, 0.0, 1.0});
                const auto world_from_vehicle =
                    sim::boost<sim::World, Boosted>(sim::Rapidity(rapidity),
                                                    glm::normalize(glm::dvec3(1.0, -0.3, 2.0))) *
                    turned;
                const glm::dquat seat = sim::level_roll(world_from_vehicle);
                // Undoes the roll: yaw and pitch alone are left, whose right is level.
                const glm::dvec3 right =
                    (turned * sim::FourVector<Vehicle>{0.0, seat * glm::dvec3(1.0, 0.0, 0.0)}).space;
                const glm::dvec3 up = (turned * sim::FourVector<Vehicle>{0.0, seat * glm::dvec3(0.0, 1.0, 0.0)}).space;
                CHECK(std::abs(right.y) < 1e-12);
                CHECK(up.y > 0.0);
            }
        }
    }
}

TEST_CASE("over the top of a loop the level seat turns smoothly, and not at all straight up") {
    glm::dquat last = sim::level_roll({});
    for (int i = 0; i <= 2000; ++i) {
        const double pitch = std::acos(-1.0) * i / 2000.0;
        const glm::dquat seat =
            sim::level_roll(sim::rotation<sim::World, sim::Vehicle>(sim::Radians(pitch), {1.0, 0.0, 0.0}));
        // From 6 to 17 degrees off the vertical it turns by half a turn: 0.09 degrees of pitch, 3.3 of roll at the
        // most.
        CHECK(std::abs(glm::dot(seat, last)) > std::cos(0.5 * 0.06));
        last = seat;
        if (i == 1000) {
            CHECK(seat == glm::dquat(1.0, 0.0, 0.0, 0.0));
        }
    }
    CHECK(std::abs((last * glm::dvec3(0.0, 1.0, 0.0)).y + 1.0) < 1e-12); // on its back, the seat is upright
}
