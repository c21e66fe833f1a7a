#include "engine/recorder.h"
#include "engine/recording_file.h"
#include "engine/recording_header.h"
#include "engine/replay_deck.h"
#include "tests/xr/monado.h"
#include "tests/xr/watched_flight.h"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("a replay on a desktop looks where the headset looked") {
    xr_kit::use_simulated_headset();
    const xr_kit::Folder folder;
    const std::filesystem::path file = folder.path / "look.rapidity";
    const content::Scenario scenario;
    std::vector<input::XrMotion> shown;
    {
        auto recorder = std::make_unique<engine::Recorder>(file, engine::describe_flight(scenario),
                                                           engine::starting_change(scenario));
        engine::Recorder& closing = *recorder;
        xr_kit::WatchedFlight flight({}, scenario, std::move(recorder));
        for (int i = 0; i < 40; ++i) {
            const std::optional<engine::HeadsetFrame> frame = flight.next_frame();
            REQUIRE(frame);
            if (frame->shown) {
                shown.push_back(frame->head);
            }
        }
        closing.close();
        REQUIRE(closing.trouble().empty());
    }
    const engine::Recording recording = engine::read_recording(file);
    REQUIRE(recording.frames.size() == shown.size());
    engine::ReplayDeck deck(recording);
    deck.set_paused(true);
    double turned = 0.0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const engine::ShownFrame& frame = recording.frames[i];
        const double metres = scenario.metres_per_light_unit();
        CHECK(glm::distance(frame.head.head_position * metres, shown[i].place.position) < 1e-6);
        CHECK(glm::length(frame.head.head_velocity) < 1e-6); // light is fast here
        if (frame.tick < 2) {
            continue;
        }
        deck.seek(static_cast<double>(frame.tick) - 1.0 + frame.fraction);
        const glm::dquat seen = deck.moment().head();
        const glm::dquat between = glm::conjugate(shown[i].place.orientation) * seen;
        // Between heads measured a 240th of a second apart: 7.5 degrees of wobble bend by far less than a milliradian.
        CHECK(2.0 * glm::length(glm::dvec3(between.x, between.y, between.z)) < 1e-3);
        const glm::dquat first = glm::conjugate(shown[2].place.orientation) * seen;
        turned = std::max(turned, 2.0 * glm::length(glm::dvec3(first.x, first.y, first.z)));
    }
    CHECK(turned > 0.05);
}
