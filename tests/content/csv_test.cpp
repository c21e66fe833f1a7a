#include "content/csv.h"
#include "sim/bad_input.h"

#include <catch2/catch_test_macros.hpp>

#include <sstream>

TEST_CASE("a missing table is named") {
    CHECK_THROWS_AS(content::read_csv("no/such/table.csv"), sim::BadInput);
}

TEST_CASE("a table that a spreadsheet saved begins after its byte order mark") {
    std::istringstream text("\xEF\xBB\xBFwavelength_nm,value\r\n400,0.5\r\n");
    const content::CsvTable table = content::parse_csv(text, "sheet.csv");
    CHECK(table.column("wavelength_nm") == 0);
    CHECK(table.number(0, table.column("value")) == 0.5);
}
