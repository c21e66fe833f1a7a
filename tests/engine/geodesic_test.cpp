#include "tests/engine/command.h"

#include <catch2/catch_test_macros.hpp>

#include <string>
#include <vector>

namespace {

using tests::rapidity;

int geodesic(std::vector<std::string> options) {
    options.insert(options.begin(), "geodesic");
    return rapidity(options);
}

} // namespace

TEST_CASE("geodesic follows light and ships in every spacetime") {
    CHECK(rapidity({"spacetimes"}) == 0);
    for (const std::string name :
         {"minkowski", "schwarzschild", "kerr", "reissner-nordstroem", "alcubierre", "wormhole", "plane-wave"}) {
        CHECK(geodesic({"--spacetime", name, "--position", "8,1,0", "--observer", "falling", "--magnification"}) == 0);
        CHECK(geodesic({"--spacetime", name, "--position", "8,1,0", "--observer", "falling", "--fly", "3", "--thrust",
                        "0,0,0.1", "--json"}) == 0);
    }
    CHECK(geodesic({"--spacetime", "kerr", "--position", "8,0,0", "--observer", "circular", "--velocity", "0,0,-0.5",
                    "--kernel", "generic", "--json"}) == 0);
}

TEST_CASE("geodesic refuses what cannot be") {
    CHECK(geodesic({"--spacetime", "ker", "--position", "8,0,0"}) == 2);
    CHECK(geodesic({"--spacetime", "kerr", "--param", "spin=1.1", "--position", "8,0,0"}) == 2);
    CHECK(geodesic({"--spacetime", "kerr", "--param", "mass=-1", "--position", "8,0,0"}) == 2);
    CHECK(geodesic({"--spacetime", "kerr", "--param", "spin", "--position", "8,0,0"}) == 2);
    CHECK(geodesic({"--spacetime", "kerr", "--position", "0,0,0"}) == 2);   // the singularity
    CHECK(geodesic({"--spacetime", "kerr", "--position", "1.1,0,0"}) == 2); // static in the ergosphere
    CHECK(geodesic({"--spacetime", "kerr", "--position", "8,0,3", "--observer", "circular"}) == 2);
    CHECK(geodesic({"--spacetime", "kerr", "--position", "8,0,0", "--velocity", "0,0,-1"}) == 2);
    CHECK(geodesic({"--spacetime", "wormhole", "--position", "8,0,0", "--kernel", "mino"}) == 2);
    CHECK(geodesic({"--spacetime", "kerr", "--position", "8,0,0", "--error", "0"}) == 2);
    CHECK(geodesic({"--spacetime", "no-such-file.toml", "--position", "8,0,0"}) == 2);
}
