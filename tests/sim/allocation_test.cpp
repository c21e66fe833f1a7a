#include "sim/readings.h"
#include "sim/snapshot.h"
#include "sim/spacetime/geodesic.h"
#include "sim/spacetime/schwarzschild.h"
#include "sim/state_hash.h"

#include <catch2/catch_test_macros.hpp>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

std::atomic<long> allocations{0};

} // namespace

// Not inlined: GCC would take free() for the wrong partner of a new that it no longer sees as malloc().
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) {
        return memory;
    }
    throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

TEST_CASE("a step along a geodesic allocates nothing") {
    const sim::Schwarzschild hole(1.0);
    sim::GeodesicState<double> ray{{0.0, 30.0, 6.0, 1.0}, {-1.0, -1.0, 0.0, 0.0}};
    const long before = allocations;
    for (int i = 0; i < 1000; ++i) {
        ray = sim::geodesic_step(hole, ray, 0.01);
    }
    CHECK(allocations == before);
    CHECK(std::isfinite(ray.position.x));
}

TEST_CASE("a tick, its hash, its snapshot and its instruments allocate nothing") {
    sim::ControlFrame control;
    control.proper_acceleration = {0.1, 0.2, -0.3};
    control.angular_velocity = {0.3, 0.2, 0.1};
    sim::VehicleState state;
    state.guidance.target = {{3.0, 1.0, -7.0}, {0.0, 0.5, 0.0}};
    state.guidance.has_target = 1;
    std::uint64_t hashes = 0;
    double read = 0.0;
    const long before = allocations;
    for (int i = 0; i < 1000; ++i) {
        // The autopilot plans anew each time that it is switched on, and aims each tick that it flies.
        control.buttons = i < 500        ? (i % 2 == 0 ? sim::ControlFrame::brake : sim::ControlFrame::boost)
                          : i % 100 == 0 ? 0u
                                         : sim::ControlFrame::autopilot;
        state = sim::advance(state, {}, control);
        hashes ^= sim::state_hash(state);
        read += sim::readings(sim::restore(sim::snapshot(state))).gamma;
    }
    const long after = allocations;
    CHECK(after == before);
    CHECK(hashes != 0);
    CHECK(read >= 1000.0);
    // The counter counts: otherwise the test above would prove nothing.
    const std::vector<double> allocated(hashes % 7 + 1);
    CHECK(!allocated.empty());
    CHECK(allocations > after);
}
