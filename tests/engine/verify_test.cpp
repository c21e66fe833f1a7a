#include "content/csv.h"
#include "engine/verify/truth_table.h"
#include "tests/content/temporary_folder.h"
#include "tests/engine/command.h"
#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;

using tests::rapidity;

std::string reference(const std::string& name) {
    return tests::source_folder() + "/tests/reference/" + name + ".csv";
}

using Folder = samples::TemporaryFolder;

const std::string script_header = "duration,ax,ay,az,wx,wy,wz\n";

} // namespace

TEST_CASE("the production code meets every truth table that it knows") {
    for (const std::string name : {"flights", "aberration", "retarded", "sphere_outline", "schwarzschild_deflection",
                                   "schwarzschild_static_observer", "kerr_equatorial_deflection", "kerr_critical_curve",
                                   "warp_bridge", "wormhole"}) {
        INFO(name);
        CHECK(rapidity({"verify", reference(name)}) == 0);
    }
    // No code is exact to this: the comparison must be able to fail.
    CHECK(rapidity({"verify", reference("flights"), "--tolerance", "1e-14"}) == 1);
}

TEST_CASE("verify writes inputs as they stood and outputs that verify exactly") {
    const Folder folder;
    const std::string computed = folder / "computed.csv";
    REQUIRE(rapidity({"verify", reference("aberration"), "--csv", computed}) == 0);
    const content::CsvTable before = content::read_csv(reference("aberration"));
    const content::CsvTable after = content::read_csv(computed);
    CHECK(after.header == before.header);
    REQUIRE(after.rows.size() == before.rows.size());
    CHECK(after.rows[40][after.column("theta_observer_rad")] == before.rows[40][before.column("theta_observer_rad")]);
    CHECK(rapidity({"verify", computed, "--tolerance", "0"}) == 0); // 17 digits bring the same bits back
}

TEST_CASE("an unknown table, an empty one and a bad tolerance are bad input") {
    const Folder folder;
    CHECK(rapidity({"verify", folder.write("other.csv", "a,b\n1,2\n")}) == 2);
    CHECK(rapidity({"verify", folder / "missing.csv"}) == 2);
    CHECK(rapidity({"verify", reference("flights"), "--tolerance", "nan"}) == 2);
}

TEST_CASE("simulate flies a script to its exact end") {
    const Folder folder;
    const std::string script = folder.write("script.csv", script_header + "0.1,0,0,-1,0,0,0\n0.05,0,0,-1,0,0,0\n");
    const std::string out = folder / "out.csv";
    REQUIRE(rapidity({"simulate", "--script", script, "--csv", out, "--rate", "97"}) == 0);
    const content::CsvTable flight = content::read_csv(out);
    REQUIRE(flight.rows.size() == 2);
    // 97 Hz does not divide the durations; RK4 leaves (1/97)^4 of 0.15.
    CHECK(std::abs(flight.number(1, flight.column("t")) - std::sinh(0.1 + 0.05)) < 1e-10);
    CHECK(flight.number(1, flight.column("tau")) == 0.1 + 0.05);
    CHECK(flight.header[0] == "tau [clock unit]");
    CHECK(flight.header[4] == "z [light clock unit]");
    CHECK(flight.header[20] == "e3_z [1]");

    // In closed form a coarse rate is as good: a few roundings of sinh.
    REQUIRE(rapidity({"simulate", "--script", script, "--csv", out, "--rate", "8", "--exact"}) == 0);
    const content::CsvTable exact = content::read_csv(out);
    CHECK(std::abs(exact.number(1, exact.column("t")) - std::sinh(0.1 + 0.05)) < 1e-16);
}

TEST_CASE("simulate refuses scripts that cannot be flown, and leaves no file") {
    const Folder folder;
    const std::string out = folder / "out.csv";
    for (const std::string& text :
         {std::string(), script_header, script_header + "1,nan,0,0,0,0,0\n", script_header + "1,inf,0,0,0,0,0\n",
          script_header + "0,1,0,0,0,0,0\n", script_header + "1,1,0\n", script_header + "400,1,0,0,0,0,0\n",
          script_header + "1e300,0,0,0,0,0,0\n", std::string("duration,ax\n1,1\n"),
          std::string("duration,ax,ay,az,wx,wy,wz,ww\n1,1,0,0,0,0,0,0\n")}) {
        INFO(text);
        CHECK(rapidity({"simulate", "--script", folder.write("script.csv", text), "--csv", out}) == 2);
        CHECK_FALSE(fs::exists(out));
    }
    const std::string good = folder.write("good.csv", script_header + "1,1,0,0,0,0,0\n");
    CHECK(rapidity({"simulate", "--script", good, "--csv", folder / "no/such/folder/out.csv"}) == 2);
    for (const std::string rate : {"0", "-1", "nan", "inf", "1e9"}) {
        CHECK(rapidity({"simulate", "--script", good, "--csv", out, "--rate", rate}) == 2);
    }
}
