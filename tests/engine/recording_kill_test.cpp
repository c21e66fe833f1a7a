#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "recorded_flight.h"

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <new>
#include <random>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using Clock = std::chrono::steady_clock;

/// When each tick was flown, in memory that outlives a killed child.
struct FlightTimes {
    std::atomic<sim::Tick> last{0};
    std::array<Clock::time_point, 200'000> at{};
};

class SharedTimes {
  public:
    SharedTimes() {
        void* memory = mmap(nullptr, sizeof(FlightTimes), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        REQUIRE(memory != MAP_FAILED);
        times_ = new (memory) FlightTimes;
    }
    ~SharedTimes() { munmap(times_, sizeof(FlightTimes)); }
    SharedTimes(const SharedTimes&) = delete;
    SharedTimes& operator=(const SharedTimes&) = delete;
    FlightTimes& operator*() const { return *times_; }
    FlightTimes* operator->() const { return times_; }

  private:
    FlightTimes* times_;
};

/// Flies and records in real time until it is killed.
[[noreturn]] void fly_for_ever(const std::filesystem::path& file, sim::Tick ticks_per_step, FlightTimes& times) {
    const content::Scenario place = recorded_flight::scenario();
    engine::Recorder recorder(file, engine::describe_flight(place), recorded_flight::start(place));
    recorded_flight::Flight flight(recorder, recorded_flight::start(place));
    auto next = Clock::now();
    while (flight.state().tick + ticks_per_step < times.at.size()) {
        flight.fly(ticks_per_step);
        for (sim::Tick tick = times.last + 1; tick <= flight.state().tick; ++tick) {
            times.at[tick] = Clock::now();
        }
        times.last = flight.state().tick;
        next += std::chrono::microseconds(4167);
        std::this_thread::sleep_until(next);
    }
    _exit(3); // the parent kills long before
}

struct Victim {
    SharedTimes times;
    std::filesystem::path file;
    pid_t process = 0;
};

} // namespace

TEST_CASE("kill -9 at any moment leaves a recording that opens, flies the same, and lacks half a second at most") {
    constexpr int victims = 16;
    const recorded_flight::Folder folder;
    std::mt19937 random(std::random_device{}());
    std::array<Victim, victims> flights;
    for (int i = 0; i < victims; ++i) {
        Victim& victim = flights[static_cast<std::size_t>(i)];
        victim.file = folder / ("flight" + std::to_string(i) + ".rapidity");
        victim.process = fork();
        REQUIRE(victim.process >= 0);
        if (victim.process == 0) {
            fly_for_ever(victim.file, i % 2 == 0 ? 1 : 100, *victim.times); // 240 ticks/s, and much work for the writer
        }
    }
    std::uniform_int_distribution<int> milliseconds(20, 200);
    for (Victim& victim : flights) {
        while (victim.times->last == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
        REQUIRE(kill(victim.process, SIGKILL) == 0);
        int status = 0;
        REQUIRE(waitpid(victim.process, &status, 0) == victim.process);
        REQUIRE(WIFSIGNALED(status));

        const engine::Recording recording = engine::read_sound_recording(victim.file);
        CHECK_FALSE(recording.ending);
        CHECK(engine::fly_again(recording).ticks == recording.end());
        const auto lost = victim.times->at[victim.times->last] - victim.times->at[recording.end()];
        INFO("flown " << victim.times->last << " ticks, recorded " << recording.end());
        // The promise itself; commits are 0.2 s apart, which leaves 0.3 s for a busy machine.
        CHECK((recording.end() == 0 ? victim.times->at[victim.times->last] - victim.times->at[1] : lost) <=
              std::chrono::milliseconds(500));
    }
}
