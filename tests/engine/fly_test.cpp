#include "engine/recording_file.h"
#include "tests/content/temporary_folder.h"
#include "tests/engine/command.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

using Folder = samples::TemporaryFolder;
using tests::rapidity;

constexpr const char* script_header = "duration,ax,ay,az,wx,wy,wz\n";

} // namespace

TEST_CASE("a headless flight follows its script and is recorded") {
    const Folder folder;
    const std::string scenario = folder.write("empty.toml", "title = \"nothing at all\"\n");
    const std::string script = folder.write("s.csv", std::string(script_header) + "1,0,0,-1,0,0,0\n0.5,0,0,0,0,0,0\n");
    const std::string recording = folder / "f.rapidity";
    REQUIRE(rapidity({"fly", scenario, "--headless", "--script", script, "--record", recording}) == 0);

    const engine::Recording read = engine::read_recording(recording);
    CHECK(read.end() == 360); // 1.5 clock units at 240 ticks
    CHECK(rapidity({"replay", recording, "--verify"}) == 0);
}

TEST_CASE("a flight ends when its seconds are over") {
    const Folder folder;
    const std::string scenario = folder.write("empty.toml", "title = \"nothing at all\"\npace = 2.0\n");
    const std::string script = folder.write("s.csv", std::string(script_header) + "100,0,0,-0.01,0,0,0\n");
    const std::string recording = folder / "f.rapidity";
    REQUIRE(rapidity({"fly", scenario, "--headless", "--script", script, "--record", recording, "--seconds", "0.5"}) ==
            0);
    CHECK(engine::read_recording(recording).end() == 240); // half a second at twice the pace
}

TEST_CASE("a script beyond rapidity 300 ends in a clear stop with what was flown recorded") {
    const Folder folder;
    const std::string scenario =
        folder.write("strong.toml", "title = \"strong\"\n[vehicle]\nmaximum_acceleration = 1000.0\n");
    const std::string script = folder.write("s.csv", std::string(script_header) + "2,0,0,-1000,0,0,0\n");
    const std::string recording = folder / "f.rapidity";
    CHECK(rapidity({"fly", scenario, "--headless", "--script", script, "--record", recording}) == 2);
    const engine::Recording read = engine::read_sound_recording(recording);
    CHECK(read.end() > 71); // 300 at 1000/240 a tick is reached in tick 72, or a little later for RK4's error
    CHECK(read.end() < 200);
    CHECK(read.changes.back().what.find("stopped at tick") == 0);
    CHECK(rapidity({"replay", recording, "--verify"}) == 0);
    CHECK(rapidity({"replay", recording, "--csv", folder / "f.csv"}) == 0);
    std::ifstream table(folder / "f.csv");
    const std::string text((std::istreambuf_iterator<char>(table)), std::istreambuf_iterator<char>());
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("inf") == std::string::npos);
    CHECK(rapidity({"simulate", "--script", script, "--csv", folder / "s-out.csv"}) == 2);
    CHECK_FALSE(fs::exists(folder / "s-out.csv"));
}

TEST_CASE("what cannot be flown is refused in one line with exit code 2") {
    const Folder folder;
    const std::string scenario = folder.write("empty.toml", "title = \"nothing at all\"\n");
    const std::string good = folder.write("good.csv", std::string(script_header) + "1,0,0,-1,0,0,0\n");
    const std::string nan = folder.write("nan.csv", std::string(script_header) + "1,nan,0,0,0,0,0\n");
    const std::string fast = folder.write("fast.toml", "title = \"too fast\"\n[start]\nbeta = 1.0\n");
    const std::string record = folder / "f.rapidity";
    CHECK(rapidity({"fly", "no-such-scenario", "--headless"}) == 2);
    CHECK(rapidity({"fly", fast, "--headless", "--script", good, "--record", record}) == 2);
    CHECK(rapidity({"fly", scenario, "--headless", "--script", nan, "--record", record}) == 2);
    CHECK(rapidity({"fly", scenario, "--headless", "--script", folder / "none.csv", "--record", record}) == 2);
    CHECK(rapidity({"fly", scenario, "--headless", "--script", good, "--record", record, "--size", "0x9"}) == 2);
    CHECK(rapidity({"fly", scenario, "--headless", "--script", good, "--record", record, "--seconds", "nan"}) == 2);
    for (const auto& [option, value] :
         {std::pair("--vignette", "1.5"), {"--snap-turn", "500"}, {"--brightest", "0"}, {"--demo-idle", "5"}}) {
        CHECK(rapidity({"fly", scenario, "--headless", "--script", good, "--record", record, option, value}) == 2);
    }
    CHECK(rapidity({"fly", scenario, "--headless", "--script", good, "--record", record, "--demo"}) == 2);
    CHECK_FALSE(fs::exists(record));
    const std::string taken = folder.write("taken.rapidity", "not empty");
    CHECK(rapidity({"fly", scenario, "--headless", "--script", good, "--record", taken}) == 2);
}

TEST_CASE("a recording that cannot be written does not stop the flight") {
    const Folder folder;
    const std::string scenario = folder.write("empty.toml", "title = \"nothing at all\"\n");
    const std::string script = folder.write("s.csv", std::string(script_header) + "0.1,0,0,-1,0,0,0\n");
    CHECK(rapidity({"fly", scenario, "--headless", "--script", script, "--record", folder / "no/such/f.rapidity"}) ==
          0);
}
