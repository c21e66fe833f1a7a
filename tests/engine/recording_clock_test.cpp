#include "engine/recorder.h"

#include "engine/flight_file.h"
#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "recorded_flight.h"

#include <catch2/catch_test_macros.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <set>
#include <sys/syscall.h>
#include <sys/time.h>
#include <thread>
#include <unistd.h>

// The wall's clock of this program is what a test wants it to be: the system's calls are taken over. The steady clock
// stays as it is.
namespace {

std::atomic<std::int64_t> wall_clock_offset{0}; // seconds

int real_clock(clockid_t id, timespec* shown) {
    const long result = syscall(SYS_clock_gettime, id, shown);
    if (result == 0 && (id == CLOCK_REALTIME || id == CLOCK_REALTIME_COARSE)) {
        shown->tv_sec += wall_clock_offset;
    }
    return static_cast<int>(result);
}

} // namespace

// Their declarations are the C library's.
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
extern "C" {
int clock_gettime(clockid_t id, timespec* shown) noexcept {
    return real_clock(id, shown);
}
std::time_t time(std::time_t* seconds) noexcept {
    timespec now{};
    real_clock(CLOCK_REALTIME, &now);
    if (seconds != nullptr) {
        *seconds = now.tv_sec;
    }
    return now.tv_sec;
}
int gettimeofday(timeval* now, void* /*zone*/) noexcept {
    timespec shown{};
    real_clock(CLOCK_REALTIME, &shown);
    now->tv_sec = shown.tv_sec;
    now->tv_usec = shown.tv_nsec / 1000;
    return 0;
}
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)

TEST_CASE("a wall clock that jumps by hours and years costs a recording nothing") {
    const recorded_flight::Folder folder;
    const std::filesystem::path file = folder / "a.rapidity";
    const std::time_t before = std::time(nullptr);
    wall_clock_offset = 3600;
    REQUIRE(std::time(nullptr) - before >= 3600); // the clock does jump
    const content::Scenario place = recorded_flight::scenario();
    {
        engine::Recorder recorder(file, engine::describe_flight(place), recorded_flight::start(place));
        recorded_flight::Flight flight(recorder, recorded_flight::start(place));
        constexpr std::int64_t year = 31'557'600;
        for (const std::int64_t offset : {-3600L, 86400L, -86400L, year, -10 * year, 0L}) {
            wall_clock_offset = offset;
            for (int tenth = 0; tenth < 4; ++tenth) {
                flight.fly(24);
                std::this_thread::sleep_for(std::chrono::milliseconds(100));
                CHECK(recorder.trouble().empty());
            }
            // What was flown is in the file before long, whatever the clock says: on a free machine 0.1 s later.
            flight.fly(24);
            sim::Tick written = 0;
            for (int wait = 0; wait < 200 && written != flight.state().tick; ++wait) {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                written = engine::read_recording(file).end();
            }
            CHECK(written == flight.state().tick);
        }
        recorder.close();
        CHECK(recorder.trouble().empty());
    }
    CHECK(engine::fly_again(engine::read_sound_recording(file)).ticks == 6 * 5 * 24);
}

TEST_CASE("flights that a clock set back gives the same time still get files of their own") {
    const recorded_flight::Folder folder;
    std::set<std::filesystem::path> files;
    for (int i = 0; i < 5; ++i) {
        wall_clock_offset = -(i % 2); // the same two seconds again and again
        files.insert(engine::new_flight_file("nowhere", folder.path()));
    }
    wall_clock_offset = 0;
    CHECK(files.size() == 5);
}
