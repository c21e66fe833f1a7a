#include "engine/database.h"
#include "engine/demand_code.h"
#include "engine/failure.h"
#include "engine/recording_file.h"
#include "engine/recording_format.h"
#include "engine/recording_recovery.h"
#include "engine/replay_check.h"
#include "engine/replay_deck.h"
#include "recorded_flight.h"
#include "sim/bad_input.h"
#include "sim/snapshot.h"
#include "tests/engine/command.h"
#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

int exit_code_of_replay(const std::filesystem::path& file) {
    return tests::rapidity({"replay", file.string(), "--verify"});
}

/// True when `a` tells of the same flight as the beginning of `b`.
bool begins_like(const engine::Recording& a, const engine::Recording& b) {
    bool same = a.header.checksum() == b.header.checksum() && a.end() <= b.end() &&
                a.controls.size() <= b.controls.size() && a.changes.size() <= b.changes.size() &&
                a.snapshots.size() <= b.snapshots.size();
    for (std::size_t i = 0; same && i < a.controls.size(); ++i) {
        same =
            a.controls[i].tick == b.controls[i].tick && engine::identical(a.controls[i].control, b.controls[i].control);
    }
    for (std::size_t i = 0; same && i < a.snapshots.size(); ++i) {
        same = sim::snapshot(a.snapshots[i]) == sim::snapshot(b.snapshots[i]);
    }
    for (std::size_t i = 0; same && i < a.changes.size(); ++i) {
        engine::Checksum one;
        engine::Checksum other;
        add(one, a.changes[i], a.layout);
        add(other, b.changes[i], b.layout);
        same = one.sum() == other.sum();
    }
    return same;
}

/// One or a few bits, bytes or blocks changed, or the end cut off.
std::string mutated(std::string bytes, std::mt19937& random) {
    const auto below = [&random](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    switch (below(5)) {
    case 0:
        bytes.resize(below(bytes.size()));
        break;
    case 1: {
        const std::size_t begin = below(bytes.size());
        const std::size_t size = std::min(bytes.size() - begin, 1 + below(512));
        bytes.replace(begin, size, size, '\0');
        break;
    }
    case 2:
        bytes[below(bytes.size())] = static_cast<char>(below(256));
        break;
    default:
        for (std::size_t flips = 1 + below(3); flips > 0; --flips) {
            char& byte = bytes[below(bytes.size())];
            byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1u << below(8)));
        }
    }
    return bytes;
}

/// Changes the last demand of the last row that begins before a tick, as one who knows the format would.
void change_demand(engine::Database& database, std::int64_t before, void (*change)(sim::ControlFrame&)) {
    engine::Statement select =
        database.prepare("SELECT tick, packed FROM demands WHERE tick < ? ORDER BY tick DESC LIMIT 1");
    select.bind(0, before);
    REQUIRE(select.step());
    std::vector<input::TimedControl> demands = engine::unpack_demands(select.bytes(1));
    const std::int64_t tick = select.integer(0);
    select.reset();
    for (input::TimedControl& timed : demands) {
        if (timed.tick >= static_cast<sim::Tick>(before) - 1) {
            change(timed.control);
            break;
        }
    }
    engine::Statement update = database.prepare("UPDATE demands SET packed = ? WHERE tick = ?");
    update.bind_bytes(0, engine::pack_demands(demands)).bind(1, tick).run();
}

struct Outcomes {
    int refused = 0;
    int same = 0;
    int shorter = 0;
    int silently_wrong = 0;
};

/// Reads and flies a file that may be damaged, and files the outcome.
void try_to_fly(const std::filesystem::path& file, const engine::Recording& original, Outcomes& outcomes) {
    try {
        const engine::Recording recording = engine::read_recording(file);
        engine::fly_again(recording);
        if (!begins_like(recording, original)) {
            ++outcomes.silently_wrong;
        } else if (recording.end() < original.end()) {
            ++outcomes.shorter;
            outcomes.silently_wrong += recording.ending ? 1 : 0; // a short one must not call itself complete
        } else {
            ++outcomes.same;
        }
    } catch (const sim::BadInput&) {
        ++outcomes.refused;
    } catch (const engine::Failure&) {
        ++outcomes.refused;
    }
}

} // namespace

TEST_CASE("a damaged recording is refused or replays rightly") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "whole.rapidity", 1500);
    const engine::Recording original = engine::read_recording(folder / "whole.rapidity");
    const std::string bytes = bytes_of(folder / "whole.rapidity");
    std::mt19937 random(16);
    Outcomes outcomes;
    for (int i = 0; i < 700; ++i) {
        write_bytes(folder / "damaged.rapidity", mutated(bytes, random));
        try_to_fly(folder / "damaged.rapidity", original, outcomes);
    }
    INFO(fmt::format("{} refused, {} as before, {} shorter", outcomes.refused, outcomes.same, outcomes.shorter));
    CHECK(outcomes.silently_wrong == 0);
    CHECK(outcomes.shorter == 0);  // a closed recording knows its length
    CHECK(outcomes.refused > 300); // most of the file matters; unused parts of pages do not
}

TEST_CASE("a recording whose log is damaged is refused or replays rightly up to there") {
    const recorded_flight::Folder folder;
    const content::Scenario place = recorded_flight::scenario();
    std::string file_bytes;
    std::string log_bytes;
    {
        // A flight that was killed: the file and its log as they were in the middle of it.
        const engine::Recorder::Options quick{std::chrono::milliseconds(10), 1'000'000};
        engine::Recorder recorder(folder / "live.rapidity", engine::describe_flight(place),
                                  recorded_flight::start(place), quick);
        recorded_flight::Flight flight(recorder, recorded_flight::start(place));
        while (engine::read_recording(folder / "live.rapidity").heartbeats.size() < 8) {
            flight.fly(50);
        }
        file_bytes = bytes_of(folder / "live.rapidity");
        log_bytes = bytes_of(folder / "live.rapidity-wal");
    }
    const engine::Recording original = engine::read_recording(folder / "live.rapidity");
    std::mt19937 random(17);
    Outcomes outcomes;
    for (int i = 0; i < 300; ++i) {
        std::error_code ignored;
        std::filesystem::remove(folder / "damaged.rapidity-shm", ignored);
        write_bytes(folder / "damaged.rapidity", i % 4 == 0 ? mutated(file_bytes, random) : file_bytes);
        write_bytes(folder / "damaged.rapidity-wal", i % 4 == 0 ? log_bytes : mutated(log_bytes, random));
        try_to_fly(folder / "damaged.rapidity", original, outcomes);
    }
    INFO(fmt::format("{} refused, {} as before, {} shorter", outcomes.refused, outcomes.same, outcomes.shorter));
    CHECK(outcomes.silently_wrong == 0);
    CHECK(outcomes.shorter > 100); // what was committed before the damage is there
}

TEST_CASE("what is recovered of a damaged recording is the beginning of its flight") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "whole.rapidity", 1500);
    const engine::Recording original = engine::read_recording(folder / "whole.rapidity");
    const std::string bytes = bytes_of(folder / "whole.rapidity");
    const auto rescue = [&folder](const std::string& damaged) {
        write_bytes(folder / "damaged.rapidity", damaged);
        std::filesystem::remove(folder / "saved.rapidity");
        for (int part = 2; std::filesystem::remove(folder / fmt::format("saved-{}.rapidity", part)); ++part) {
        }
        return engine::recover_recording(folder / "damaged.rapidity", folder / "saved.rapidity");
    };
    const engine::Recovery all = rescue(bytes);
    CHECK(all.losses.empty());
    CHECK(all.saved_until == 1500);
    CHECK(engine::fly_again(engine::read_sound_recording(folder / "saved.rapidity")).ticks == 1500);
    CHECK_THROWS_AS(engine::recover_recording(folder / "whole.rapidity", folder / "saved.rapidity"), sim::BadInput);

    std::mt19937 random(18);
    int saved = 0;
    for (int i = 0; i < 100; ++i) {
        try {
            const engine::Recovery recovery = rescue(mutated(bytes, random));
            const engine::Recording part = engine::read_sound_recording(folder / "saved.rapidity");
            engine::fly_again(part);
            ++saved;
            REQUIRE(part.ending == recovery.saved_until);
            REQUIRE(part.header.origin.find("damaged.rapidity") != std::string::npos);
            engine::Recording same = part;
            same.header = original.header; // a damaged header is replaced by defaults
            if (recovery.head_poses_checked) {
                REQUIRE(begins_like(same, original));
            }
        } catch (const sim::BadInput&) { // said what is wrong, and wrote nothing
            REQUIRE_FALSE(std::filesystem::exists(folder / "saved.rapidity"));
        }
    }
    CHECK(saved > 50); // most damage leaves a beginning
}

TEST_CASE("what lies behind a hole is recovered as a recording of its own, from snapshot to snapshot") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "damaged.rapidity", 2400); // a change at 1200
    const engine::Recording original = engine::read_recording(folder / "damaged.rapidity");
    engine::keep_bookmark(folder / "damaged.rapidity", {900, "before the hole's end"});
    engine::keep_bookmark(folder / "damaged.rapidity", {2000, "behind the hole"});
    std::int64_t rows = 0;
    {
        engine::Database database = engine::Database::create(folder / "damaged.rapidity");
        database.execute("DELETE FROM demands"); // flown in no time, they are in a row or two
        engine::Statement insert = database.prepare("INSERT INTO demands VALUES (?, ?, ?)");
        constexpr std::size_t in_a_row = 20;
        for (std::size_t i = 0; i < original.controls.size(); i += in_a_row) {
            const auto first = original.controls.begin() + static_cast<std::ptrdiff_t>(i);
            const std::vector<input::TimedControl> row(
                first, first + static_cast<std::ptrdiff_t>(std::min(in_a_row, original.controls.size() - i)));
            insert.bind(0, static_cast<std::int64_t>(row.front().tick))
                .bind(1, static_cast<std::int64_t>(row.size()))
                .bind_bytes(2, engine::pack_demands(row))
                .run();
        }
        rows = database.integer("SELECT count(*) FROM demands WHERE tick >= 600 AND tick < 1000");
        database.execute("UPDATE demands SET packed = x'ff' WHERE tick >= 600 AND tick < 1000");
    }
    REQUIRE(rows >= 1);
    const engine::Recovery recovery = engine::recover_recording(folder / "damaged.rapidity", folder / "saved.rapidity");
    CHECK(recovery.saved_until >= 480);
    CHECK(recovery.saved_until < 1000);
    REQUIRE(recovery.later.size() == 1);
    const engine::LaterPart& part = recovery.later.front();
    CHECK(part.file == folder / "saved-2.rapidity");
    CHECK(part.first > recovery.saved_until);
    CHECK(part.first <= 1200);
    CHECK(part.first % engine::snapshot_interval == 0);
    CHECK(part.saved_until == 2400);
    const engine::Recording later = engine::read_sound_recording(part.file);
    CHECK(later.first_tick() == part.first);
    CHECK(engine::fly_again(later).ticks == part.saved_until - part.first);
    CHECK(later.snapshot_hashes.back() == original.snapshot_hashes.back());
    REQUIRE(later.bookmarks.size() == 1);
    CHECK(later.bookmarks.front().what == "behind the hole");
    for (const sim::Tick tick : {part.first, part.first + 7, sim::Tick{2000}, sim::Tick{2399}}) {
        CHECK(engine::identical(engine::demand_at(later, tick), engine::demand_at(original, tick)));
    }
    // The file of the part is there now: nothing is written over it, and nothing else is written.
    std::filesystem::remove(folder / "saved.rapidity");
    CHECK_THROWS_AS(engine::recover_recording(folder / "damaged.rapidity", folder / "saved.rapidity"), sim::BadInput);
    CHECK_FALSE(std::filesystem::exists(folder / "saved.rapidity"));
}

TEST_CASE("recordings of every older version open, and say where they fly differently today") {
    const std::string folder = tests::source_folder() + "/tests/engine/recordings/version";
    for (int version = 1; version < engine::recording_format_version; ++version) {
        INFO("version " << version);
        const std::filesystem::path file = folder + std::to_string(version) + ".rapidity";
        const engine::Recording recording = engine::read_sound_recording(file);
        CHECK(recording.layout.version == version);
        CHECK(recording.header.scenario_name == "stars");
        CHECK(recording.ending == 600); // 0.3 clock units at 2000 ticks each
        CHECK(recording.snapshots.size() == 2);
        CHECK(recording.controls.size() == 2);
        CHECK(recording.controls.back().control.proper_acceleration == glm::dvec3(0.1, 0.0, 0.0));
        // Versions 1 and 2 added up Lambda's changes with other roundings; later ones fly as they were recorded.
        if (version >= 3) {
            CHECK(engine::fly_again(recording).ticks == 600);
        } else {
            CHECK_THROWS_MATCHES(engine::fly_again(recording), engine::Failure,
                                 MessageMatches(ContainsSubstring("flies differently")));
        }
    }
}

TEST_CASE("one changed demand is found at the next heartbeat or snapshot, by the program's exit code") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "a.rapidity", 1500);
    CHECK(exit_code_of_replay(folder / "a.rapidity") == 0);

    const engine::Recording recording = engine::read_recording(folder / "a.rapidity");
    {
        engine::Database database = engine::Database::create(folder / "a.rapidity");
        change_demand(database, 700, [](sim::ControlFrame& control) { control.angular_velocity.x *= 0.999; });
    }
    sim::Tick found = 720; // the snapshot after the changed demand, unless a heartbeat comes before
    for (const engine::Heartbeat& heartbeat : recording.heartbeats) {
        if (heartbeat.tick >= 700) {
            found = std::min(found, heartbeat.tick);
        }
    }
    CHECK(exit_code_of_replay(folder / "a.rapidity") == 1);
    const engine::Recording changed = engine::read_recording(folder / "a.rapidity");
    CHECK_THROWS_MATCHES(engine::fly_again(changed), engine::Failure,
                         MessageMatches(ContainsSubstring(fmt::format("at tick {}", found))));
    CHECK_THROWS_AS(engine::read_sound_recording(folder / "a.rapidity"), sim::BadInput);
}

TEST_CASE("a demand that fits its checksum but not the flight is found by the state's hash") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "a.rapidity", 1500);
    engine::Recording recording = engine::read_recording(folder / "a.rapidity");
    for (input::TimedControl& timed : recording.controls) {
        if (timed.tick >= 480) {
            timed.control.angular_velocity.x = 0.125; // as a forger would, who mends the checksums too
            break;
        }
    }
    CHECK_THROWS_MATCHES(engine::fly_again(recording), engine::Failure, MessageMatches(ContainsSubstring("at tick ")));
}

TEST_CASE("a changed head pose, which moves no ship, is found by its checksum") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "a.rapidity", 1500);
    engine::Database database = engine::Database::create(folder / "a.rapidity");
    change_demand(database, 700, [](sim::ControlFrame& control) { control.head_position.y += 1e-12; });
    CHECK_THROWS_MATCHES(engine::fly_again(engine::read_recording(folder / "a.rapidity")), engine::Failure,
                         MessageMatches(ContainsSubstring("demands do not match")));
}

TEST_CASE("what is no recording of this program is refused in one line") {
    const recorded_flight::Folder folder;
    const auto file = folder / "a.rapidity";
    const auto expect = [&file](const char* words) {
        CHECK_THROWS_MATCHES(engine::read_recording(file), sim::BadInput, MessageMatches(ContainsSubstring(words)));
        CHECK(exit_code_of_replay(file) == 2);
    };
    expect("no such file");
    write_bytes(file, "");
    expect("is empty");
    write_bytes(file, "once upon a time there was a ship");
    expect("not a recording");
    std::filesystem::remove(file);
    engine::Database::create(file).execute("CREATE TABLE diary (day)");
    expect("not a recording");
    std::filesystem::remove(file);

    recorded_flight::record(file, 500);
    engine::Database::create(file).execute("PRAGMA user_version = 99");
    expect("newer Rapidity");
    engine::Database::create(file).execute("PRAGMA user_version = -1");
    expect("no such version");
    engine::Database::create(file).execute("PRAGMA user_version = " + std::to_string(engine::recording_format_version));
    engine::Database::create(file).execute("UPDATE metadata SET value = 'elsewhere' WHERE key = 'scenario'");
    expect("metadata");
    std::filesystem::remove(file);

    recorded_flight::record(file, 500);
    write_bytes(file, bytes_of(file).substr(0, 5000));
    expect("damaged");
}

TEST_CASE("a scenario that has changed since the flight is told of") {
    const recorded_flight::Folder folder;
    write_bytes(folder / "place.toml", "title = \"A place\"\n");
    content::Scenario place = recorded_flight::scenario();
    place.file = folder / "place.toml";
    const engine::RecordingHeader header = engine::describe_flight(place);
    CHECK(header.scenario_text == "title = \"A place\"\n");
    CHECK(engine::changed_inputs(header).empty());
    write_bytes(folder / "place.toml", "title = \"Another\"\n");
    REQUIRE(engine::changed_inputs(header).size() == 1);
    CHECK_THAT(engine::changed_inputs(header).front(), ContainsSubstring("place.toml has changed"));
}
