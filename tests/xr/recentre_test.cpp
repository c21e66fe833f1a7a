#include "tests/xr/monado.h"
#include "tests/xr/watched_flight.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>

namespace {

/// The head in the vehicle after some frames of what the remote headset does; counts presses of the menu's button.
input::XrMotion after_frames(xr_kit::RemoteHeadset& remote, xr_kit::WatchedFlight& flight, int& menus) {
    input::XrMotion head;
    for (int i = 0; i < 8; ++i) {
        remote.send();
        const std::optional<engine::HeadsetFrame> frame = flight.next_frame();
        REQUIRE(frame);
        head = frame->head;
        menus += frame->controllers.menu ? 1 : 0;
    }
    return head;
}

double turned(const glm::dquat& q) {
    return 2.0 * glm::length(glm::dvec3(q.x, q.y, q.z));
}

} // namespace

TEST_CASE("recentring at any time puts the seat where the head is, and ahead where it looks") {
    constexpr double tolerance = 1e-4; // places come in single precision
    xr_kit::RemoteHeadset remote;
    xr_kit::WatchedFlight flight(content::SceneDesc{});
    int menus = 0;
    // The first look is the seat, wherever the room's origin is.
    CHECK(glm::length(after_frames(remote, flight, menus).place.position) < tolerance);

    const double yaw = 0.7;
    remote.head = {0.3F, 1.5F, -0.2F};
    remote.head_turn = {0.0F, static_cast<float>(std::sin(0.5 * yaw)), 0.0F, static_cast<float>(std::cos(0.5 * yaw))};
    const input::XrMotion away = after_frames(remote, flight, menus);
    CHECK(glm::distance(away.place.position, glm::dvec3(0.3, -0.1, -0.2)) < tolerance);
    CHECK(std::abs(turned(away.place.orientation) - 2.0 * std::sin(0.5 * yaw)) < tolerance);

    flight.headset.take_notes();
    remote.left.a = true; // Index: recentre
    const input::XrMotion centred = after_frames(remote, flight, menus);
    CHECK(glm::length(centred.place.position) < tolerance);
    CHECK(turned(centred.place.orientation) < tolerance);
    const std::vector<std::string> notes = flight.headset.take_notes();
    CHECK(std::ranges::count(notes, std::string("recentred: you sit here and look ahead")) == 1);

    // A button that stays down recentres once; from now on the room is seen from the new seat.
    remote.head[0] += 0.1F;
    const input::XrMotion moved = after_frames(remote, flight, menus);
    CHECK(glm::distance(moved.place.position, glm::dvec3(0.1 * std::cos(yaw), 0.0, 0.1 * std::sin(yaw))) < tolerance);

    remote.left.b = true; // Index: menu
    after_frames(remote, flight, menus);
    CHECK(menus == 1);
}
