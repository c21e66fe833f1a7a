#include "tests/engine/command.h"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("where nothing moves the renderer shows every colour as it came, within 1/255") {
    CHECK(tests::rapidity({"bench", "white"}) == 0);
}
