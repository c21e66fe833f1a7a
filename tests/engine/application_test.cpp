#include "content/file_bytes.h"
#include "tests/content/temporary_folder.h"
#include "tests/engine/command.h"
#include "tests/program.h"

#include <catch2/catch_test_macros.hpp>

#include <filesystem>
#include <fstream>

TEST_CASE("an unknown verb is bad usage") {
    CHECK(tests::rapidity({"no-such-verb"}) == 2);
}

TEST_CASE("the version is a verb and an option, and says the same") {
    for (const std::string word : {"version", "--version"}) {
        const tests::Run run = tests::run_program({word});
        CHECK(run.exit_code == 0);
        CHECK(run.output == "rapidity " RAPIDITY_VERSION "\n");
    }
}

TEST_CASE("a sky has the microwave background that its scenario says, or that an option puts or takes") {
    const samples::TemporaryFolder folder;
    const auto rendered = [&](const std::string& scenario, const std::vector<std::string>& options) {
        const std::string file = (folder.path() / "sky.exr").string();
        std::ofstream(folder.path() / "sky.toml") << scenario;
        std::vector<std::string> words{"render", (folder.path() / "sky.toml").string(), "-o", file};
        words.insert(words.end(),
                     {"--method", "ray", "--samples", "1", "--size", "9x7", "--fov", "1", "--rapidity", "6.4"});
        words.insert(words.end(), options.begin(), options.end());
        REQUIRE(tests::rapidity(words) == 0);
        std::vector<std::uint8_t> bytes = content::read_file_bytes(file);
        std::filesystem::remove(file);
        return bytes;
    };
    const std::string without = "[sky]\nzenith = [0, 0, 0]\nhorizon = [0, 0, 0]\nnadir = [0, 0, 0]\n";
    const std::string with = "microwave_background = true\n" + without;
    const auto glowing = rendered(with, {});
    const auto plain = rendered(without, {});
    CHECK(glowing != plain);
    CHECK(rendered(with, {"--microwave-background"}) == glowing);
    CHECK(rendered(without, {"--microwave-background"}) == glowing);
    CHECK(rendered(with, {"--no-microwave-background"}) == plain);
    CHECK(rendered(without, {"--no-microwave-background"}) == plain);
}
