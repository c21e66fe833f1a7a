#include "engine/application.h"

#include <array>
#include <catch2/catch_test_macros.hpp>

TEST_CASE("an unknown verb is bad usage") {
    const std::array<const char*, 2> arguments{"rapidity", "no-such-verb"};
    CHECK(engine::run_application(2, arguments.data()) == 2);
}
