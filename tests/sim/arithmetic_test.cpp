#include "sim/arithmetic.h"

#include <catch2/catch_test_macros.hpp>

#include <cfenv>

TEST_CASE("this build rounds every operation on its own, to nearest") {
    CHECK(sim::arithmetic_trouble().empty());
}

TEST_CASE("another rounding is found out") {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        REQUIRE(std::fesetround(mode) == 0);
        const std::string_view trouble = sim::arithmetic_trouble();
        std::fesetround(FE_TONEAREST);
        CHECK(!trouble.empty());
    }
}
