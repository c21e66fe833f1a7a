#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "recorded_flight.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <new>
#include <random>
#include <sys/mman.h>
#include <sys/prctl.h>
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
    Victim() = default;
    ~Victim() { end(); }
    Victim(const Victim&) = delete;
    Victim& operator=(const Victim&) = delete;
    /// kill -9.
    void end() {
        if (process > 0) {
            kill(process, SIGKILL);
            waitpid(process, nullptr, 0);
            process = 0;
        }
    }

    SharedTimes times;
    std::filesystem::path file;
    pid_t process = 0;
    bool real_time = true;
};

} // namespace

TEST_CASE("kill -9 at any moment leaves a recording that opens, flies the same, and lacks half a second at most") {
    constexpr int waves = 5; // fifty flights, ten at a time: more would wait for a processor, not for the disk
    constexpr int victims = 10;
    const recorded_flight::Folder folder;
    std::mt19937 random(std::random_device{}());
    std::uniform_int_distribution<int> milliseconds(20, 200);
    for (int wave = 0; wave < waves; ++wave) {
        std::array<Victim, victims> flights;
        for (int i = 0; i < victims; ++i) {
            Victim& victim = flights[static_cast<std::size_t>(i)];
            victim.real_time = i % 4 != 3;
            victim.file = folder / ("flight" + std::to_string(wave) + "-" + std::to_string(i) + ".rapidity");
            victim.process = fork();
            REQUIRE(victim.process >= 0);
            if (victim.process == 0) {
                prctl(PR_SET_PDEATHSIG, SIGKILL); // no flight outlives the test
                fly_for_ever(victim.file, victim.real_time ? 1 : 100, *victim.times);
            }
        }
        for (Victim& victim : flights) {
            while (victim.times->last == 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
            victim.end();

            const engine::Recording recording = engine::read_sound_recording(victim.file);
            CHECK_FALSE(recording.ending);
            CHECK(engine::fly_again(recording).ticks == recording.end());
            INFO("flown " << victim.times->last << " ticks, recorded " << recording.end());
            // Flights a hundred times as fast give the writer more to be killed in; the promise is for a pilot's
            // flight. Commits are 0.1 s apart, which leaves 0.4 s for a busy machine.
            const auto recorded_until = victim.times->at[std::max(recording.end(), sim::Tick{1})];
            const auto lost = victim.times->at[victim.times->last] - recorded_until;
            CHECK((!victim.real_time || lost <= std::chrono::milliseconds(500)));
        }
    }
}
