#include "engine/bookmarks.h"

#include "engine/recording_file.h"
#include "engine/replay_deck.h"
#include "recorded_flight.h"
#include "sim/bad_input.h"
#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>

#include <fstream>

TEST_CASE("a replay's bookmark is in the recording, which stays the same flight") {
    const recorded_flight::Folder folder;
    const std::filesystem::path file = folder / "a.rapidity";
    recorded_flight::record(file, 500);
    const std::uint64_t checksum = engine::read_sound_recording(file).checksum();
    CHECK(engine::keep_bookmark(file, {300, "bookmark: 1"}) == file);
    CHECK(engine::keep_bookmark(file, {100, "bookmark: 2"}) == file);
    const engine::Recording again = engine::read_sound_recording(file);
    CHECK(again.checksum() == checksum);
    REQUIRE(again.bookmarks.size() == 2);
    CHECK(again.bookmarks[0].tick == 100);
    CHECK(again.bookmarks[1].what == "bookmark: 1");
    engine::ReplayDeck deck(again);
    CHECK(deck.marks().size() == 5); // with the start, the change in the middle and the end
    deck.seek(50.0);
    deck.set_paused(true);
    deck.seek_mark(true);
    CHECK(deck.state().tick == 100);
    CHECK(deck.mark().what == "bookmark: 3");
}

TEST_CASE("an older recording takes a bookmark too") {
    const recorded_flight::Folder folder;
    for (const int version : {1, 5}) {
        const std::string name = "version" + std::to_string(version) + ".rapidity";
        std::filesystem::copy(tests::source_folder() + "/tests/engine/recordings/" + name, folder / name);
        CHECK(engine::keep_bookmark(folder / name, {30, "here"}) == folder / name);
        const engine::Recording recording = engine::read_sound_recording(folder / name);
        CHECK(recording.layout.version == version);
        REQUIRE(recording.bookmarks.size() == 1);
        CHECK(recording.bookmarks[0].tick == 30);
    }
}

TEST_CASE("bookmarks of a recording that cannot be written lie beside it, and damage there is told") {
    const recorded_flight::Folder folder;
    const std::filesystem::path file = folder / "a.rapidity";
    recorded_flight::record(file, 500);
    // A database that another program holds cannot be written, by root neither.
    engine::Database other = engine::Database::create(file);
    other.execute("BEGIN EXCLUSIVE");
    const std::filesystem::path beside = engine::keep_bookmark(file, {200, "bookmark: 1"});
    CHECK(beside == folder / "a.rapidity.bookmarks.csv");
    other.roll_back();
    const engine::Recording recording = engine::read_sound_recording(file);
    REQUIRE(recording.bookmarks.size() == 1);
    CHECK(recording.bookmarks[0].tick == 200);
    CHECK(recording.bookmarks[0].what == "bookmark: 1");
    std::ofstream(beside, std::ios::app) << "soon,here\n";
    CHECK_THROWS_AS(engine::read_sound_recording(file), sim::BadInput);
    CHECK_THROWS_AS(engine::keep_bookmark("/proc/none/a.rapidity", {1, "x"}), sim::BadInput);
}
