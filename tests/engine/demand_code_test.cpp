#include "engine/demand_code.h"

#include "engine/recording_format.h"
#include "engine/recording_writer.h"
#include "input/demand_grid.h"
#include "recorded_flight.h"

#include <catch2/catch_test_macros.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace {

bool same(const std::vector<input::TimedControl>& a, const std::vector<input::TimedControl>& b) {
    bool equal = a.size() == b.size();
    for (std::size_t i = 0; equal && i < a.size(); ++i) {
        equal = a[i].tick == b[i].tick && engine::identical(a[i].control, b[i].control);
    }
    return equal;
}

input::TimedControl random_demand(sim::Tick tick, std::mt19937_64& random) {
    auto numbers = engine::numbers_of({});
    for (double& number : numbers) {
        switch (random() % 4) {
        case 0:
            number = std::bit_cast<double>(random()); // any bits at all
            break;
        case 1:
            number = -0.0;
            break;
        case 2:
            number = std::numeric_limits<double>::denorm_min();
            break;
        default:
            break;
        }
    }
    return {tick, engine::control_of(numbers, static_cast<std::uint32_t>(random()))};
}

} // namespace

TEST_CASE("packed demands come back bit for bit, whatever their bits are") {
    std::mt19937_64 random(1);
    std::vector<input::TimedControl> demands;
    sim::Tick tick = 0;
    for (int i = 0; i < 2000; ++i) {
        demands.push_back(random_demand(tick, random));
        tick += i % 3 == 0 ? 1 : 1 + random() % 1'000'000;
    }
    CHECK(same(engine::unpack_demands(engine::pack_demands(demands)), demands));
    CHECK(engine::unpack_demands("").empty());
}

TEST_CASE("bytes that are no demands are refused, and none reads beyond its end") {
    std::mt19937_64 random(2);
    std::vector<input::TimedControl> demands;
    for (sim::Tick tick = 5; tick < 25; ++tick) {
        demands.push_back(random_demand(tick, random));
    }
    const std::string pack = engine::pack_demands(demands);
    int refused = 0;
    for (std::size_t size = 1; size < pack.size(); ++size) { // cut between two demands it is a shorter pack
        try {
            const std::size_t count = engine::unpack_demands(pack.substr(0, size)).size();
            CHECK(count < demands.size());
        } catch (const engine::DatabaseError&) {
            ++refused;
        }
    }
    CHECK(refused == static_cast<int>(pack.size()) - 1 - 19);
    CHECK_THROWS_AS(engine::unpack_demands(std::string(12, '\xff')), engine::DatabaseError);
    CHECK_THROWS_AS(engine::unpack_demands(std::string("\x00\x05\x00\x00", 4)), engine::DatabaseError); // tick twice
}

TEST_CASE("short numbers come back bit for bit and take two bytes each") {
    std::mt19937 random(4);
    std::uniform_int_distribution<int> count(-16384, 16384);
    std::vector<input::TimedControl> demands;
    for (sim::Tick tick = 1; tick <= 240; ++tick) {
        sim::ControlFrame control;
        for (int axis = 0; axis < 3; ++axis) {
            control.proper_acceleration[axis] = std::ldexp(count(random), -16);
            control.angular_velocity[axis] = std::ldexp(count(random), -13);
        }
        demands.push_back({tick, control});
    }
    const std::string pack = engine::pack_demands(demands);
    CHECK(same(engine::unpack_demands(pack), demands));
    // Two bytes of mask, one that says that all is short, twelve; and a step found anew now and then at the start.
    CHECK(pack.size() < 240 * 15 + 250);
    for (sim::Tick i = 0; i < demands.size(); i += 7) { // others between them, and steps at and beyond the ends
        std::mt19937_64 seeded(i);
        demands[i] = random_demand(demands[i].tick, seeded);
        demands[i].control.head_position = {std::ldexp(3.0, 127), std::ldexp(3.0, 128), std::ldexp(3.0, -128)};
        demands[i].control.head_velocity = {std::ldexp(3.0, -129), 32767.0, 32769.0};
    }
    CHECK(same(engine::unpack_demands(engine::pack_demands(demands)), demands));
}

TEST_CASE("an hour of six axes that never rest takes less than 20 MB") {
    const recorded_flight::Folder folder;
    const engine::FlightChange start = recorded_flight::start(recorded_flight::scenario());
    engine::RecordingWriter writer(folder / "a.rapidity", {}, start);
    engine::Database database = engine::Database::create(folder / "a.rapidity");
    const auto size = [&database] {
        return database.integer("PRAGMA page_count") * database.integer("PRAGMA page_size");
    };
    const std::int64_t empty = size();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    engine::FlightBatch batch;
    batch.latest = start.state;
    constexpr sim::Tick minute = 14'400;
    for (sim::Tick tick = 0; tick < minute; ++tick) {
        sim::ControlFrame control;
        for (int axis = 0; axis < 3; ++axis) { // as hands demand it
            control.proper_acceleration[axis] = input::on_grid(any(random), 1.0);
            control.angular_velocity[axis] = input::on_grid(any(random), 1.0);
        }
        batch.controls.push_back({tick, control});
        batch.latest = sim::advance(batch.latest, start.vehicle, control);
        if (batch.latest.tick % engine::snapshot_interval == 0) {
            batch.snapshots.push_back(batch.latest);
        }
        if (batch.latest.tick % 24 == 0) { // as the recorder commits
            writer.write(batch);
            batch.controls.clear();
            batch.snapshots.clear();
        }
    }
    writer.finish(minute);
    CHECK(empty + 60 * (size() - empty) < 20'000'000);
}
