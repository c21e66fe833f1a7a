#include "engine/application.h"

#include <array>
#include <catch2/catch_test_macros.hpp>

TEST_CASE("where nothing moves the renderer shows every colour as it came, within 1/255") {
    const std::array<const char*, 3> arguments{"rapidity", "bench", "white"};
    CHECK(engine::run_application(3, arguments.data()) == 0);
}
