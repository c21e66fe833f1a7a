#include "engine/proof/hard_cases.h"

#include "engine/proof/geodesic_cost.h"
#include "tests/engine/command.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <set>
#include <string>

namespace {

// A hundred million ticks take some twelve seconds with optimisation; without, the same flight is cut short.
#ifdef NDEBUG
constexpr sim::Tick tumbling_ticks = 100'000'000;
#else
constexpr sim::Tick tumbling_ticks = 1'000'000;
#endif

constexpr const char* tumbling = "tumbling for a long time";

void check(const engine::HardCase& hard, sim::Tick ticks) {
    const auto results = hard.fly(ticks);
    CHECK_FALSE(results.empty());
    for (const engine::HardCaseResult& result : results) {
        INFO(hard.name << ": " << result.quantity << ": " << result.measured << ", allowed " << result.allowed);
        CHECK(engine::holds(result));
        CHECK_FALSE(result.reason.empty());
    }
}

} // namespace

TEST_CASE("every hard case but the long one is within what is allowed, with a reason") {
    std::set<std::string> names;
    for (const engine::HardCase& hard : engine::hard_cases()) {
        names.insert(hard.name);
        if (hard.name != tumbling) {
            check(hard, 0);
        }
    }
    CHECK(names.size() == engine::hard_cases().size());
    CHECK(names.contains(tumbling));
}

TEST_CASE("a long tumbling drifts by no more than the root of its ticks") {
    for (const engine::HardCase& hard : engine::hard_cases()) {
        if (hard.name == tumbling) {
            check(hard, tumbling_ticks);
        }
    }
}

TEST_CASE("an error that is not a number does not hold") {
    CHECK_FALSE(engine::holds({"", std::nan(""), 1.0, ""}));
}

TEST_CASE("bench hard-cases refuses a tumbling without ticks") {
    CHECK(tests::rapidity({"bench", "hard-cases", "--ticks", "0"}) == 2);
}

TEST_CASE("a light ray's step has its cost") {
    for (const engine::GeodesicCost& cost : engine::geodesic_costs(1)) {
        CHECK(cost.nanoseconds_a_step > 0.0);
    }
}
