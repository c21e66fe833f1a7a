#include "content/csv.h"
#include "sim/bad_input.h"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("a missing table is named") {
    CHECK_THROWS_AS(content::read_csv("no/such/table.csv"), sim::BadInput);
}
