#include "engine/trace/tile_farm.h"
#include "engine/trace/tile_store.h"
#include "sim/bad_input.h"
#include "tests/content/temporary_folder.h"

#include <catch2/catch_test_macros.hpp>

#include <atomic>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>

namespace {

const engine::TilePlan plan(2, 150, 70); // 3 x 2 tiles a frame, the last ones narrow

std::vector<float> made(std::size_t tile) {
    const render::TracedTile place = plan.place_of(tile);
    std::vector<float> values(static_cast<std::size_t>(place.width) * static_cast<std::size_t>(place.height) *
                              render::traced_channel_count);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(1000 * tile + i % 997);
    }
    return values;
}

const engine::TileProgress silent{[](std::size_t) {}, [] {}, [] { return false; }};

} // namespace

TEST_CASE("a plan's tiles cover every pixel of every frame once") {
    CHECK(plan.count() == 12);
    std::vector<int> covered(2 * 150 * 70, 0);
    for (std::size_t tile = 0; tile < plan.count(); ++tile) {
        const render::TracedTile place = plan.place_of(tile);
        for (int y = place.top; y < place.top + place.height; ++y) {
            for (int x = place.left; x < place.left + place.width; ++x) {
                ++covered[static_cast<std::size_t>((plan.frame_of(tile) * 70 + y) * 150 + x)];
            }
        }
    }
    CHECK(std::set<int>(covered.begin(), covered.end()) == std::set<int>{1});
}

TEST_CASE("a store gives back what was stored, and damaged or cut tiles count as not done") {
    const samples::TemporaryFolder folder;
    const engine::TileStore store(folder.path() / "a.tiles", "job", plan);
    store.store(0, made(0));
    store.store(7, made(7));
    store.store(8, made(8));
    CHECK(store.load(7) == made(7));
    { // one flipped bit
        std::fstream file(folder.path() / "a.tiles" / "00000000.tile", std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(100);
        file.put('\x55');
    }
    std::filesystem::resize_file(folder.path() / "a.tiles" / "00000008.tile", 1000);
    const std::vector<bool> done = store.done();
    CHECK_FALSE(done[0]);
    CHECK(done[7]);
    CHECK_FALSE(done[8]);
    CHECK_FALSE(done[1]);
    store.finish_frame(1);
    CHECK(store.done()[11]); // its picture is written
    CHECK_FALSE(store.load(7));
}

TEST_CASE("a store refuses tiles of another job") {
    const samples::TemporaryFolder folder;
    { const engine::TileStore store(folder.path() / "a.tiles", "one", plan); }
    CHECK_NOTHROW(engine::TileStore(folder.path() / "a.tiles", "one", plan));
    CHECK_THROWS_AS(engine::TileStore(folder.path() / "a.tiles", "another", plan), sim::BadInput);
}

TEST_CASE("a farm makes what is missing, once, and stops when told") {
    const samples::TemporaryFolder folder;
    const engine::TileStore store(folder.path() / "a.tiles", "job", plan);
    store.store(3, made(3));
    std::mutex mutex;
    std::multiset<std::size_t> asked;
    const auto make = [&](std::size_t tile) {
        const std::scoped_lock lock(mutex);
        asked.insert(tile);
        return made(tile);
    };
    std::atomic<int> stored = 0;
    engine::TileProgress progress = silent;
    progress.finished = [&](std::size_t) { ++stored; };
    progress.stop = [&] { return stored >= 4; };
    CHECK_FALSE(engine::farm_tiles(store.done(), 2, make, &store, nullptr, progress));
    CHECK(asked.size() < 11);
    progress.stop = [] { return false; };
    CHECK(engine::farm_tiles(store.done(), 3, make, &store, nullptr, progress));
    CHECK(asked.size() == 11); // all but tile 3, none twice
    CHECK(asked.count(3) == 0);
    for (std::size_t tile = 0; tile < plan.count(); ++tile) {
        CHECK(store.load(tile) == made(tile));
    }
}

TEST_CASE("a tile that throws ends the farm with its reason, and the others' tiles are kept") {
    const samples::TemporaryFolder folder;
    const engine::TileStore store(folder.path() / "a.tiles", "job", plan);
    const auto make = [](std::size_t tile) {
        if (tile == 5) {
            throw std::runtime_error("five");
        }
        return made(tile);
    };
    CHECK_THROWS_AS(engine::farm_tiles(store.done(), 1, make, &store, nullptr, silent), std::runtime_error);
    CHECK(store.done()[4]);
    CHECK_FALSE(store.done()[5]);
}
