#include "content/file_bytes.h"
#include "content/panorama.h"
#include "render/picture_file.h"
#include "tests/content/temporary_folder.h"
#include "tests/engine/png_text.h"
#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

constexpr const char* small_scene = R"(title = "a ball behind a hole"
[spacetime]
name = "schwarzschild"
[camera]
position = [15.0, 0.0, 1.0]
field_of_view = 60.0
[[camera.path]]
at = 0.0
position = [15.0, 0.0, 1.0]
[[camera.path]]
at = 1.0
position = [15.0, 2.0, 1.0]
[[sphere]]
centre = [-9.0, 0.5, 0.0]
radius = 2.0
emission = [0.5, 0.2, 0.1]
[sky]
checkerboard = 15.0
)";

constexpr const char* disk_scene = R"([spacetime]
name = "kerr"
spin = 0.9
[camera]
position = [25.0, 0.0, 6.0]
[disk]
outer_radius = 12.0
[sky]
checkerboard = 10.0
)";

struct Run {
    int status = -1;
    std::string said; ///< both streams
};

Run run(const samples::TemporaryFolder& folder, const std::string& arguments, const std::string& before = "") {
    const fs::path log = folder.path() / "log.txt";
    const std::string line = "cd '" + folder.path().string() + "' && " + before + " '" + tests::program() + "' trace " +
                             arguments + " >'" + log.string() + "' 2>&1";
    const int status = std::system(line.c_str());
    std::ostringstream said;
    said << std::ifstream(log).rdbuf();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said.str()};
}

std::vector<std::uint8_t> bytes_of(const samples::TemporaryFolder& folder, const std::string& name) {
    return content::read_file_bytes(folder.path() / name);
}

// Open MPI leaves bytes behind and is unloaded before a leak checker could name, and so suppress, them.
const std::vector<std::string> mpi_environment{"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                                               "ASAN_OPTIONS=detect_leaks=0"};

std::string mpirun(const std::string& ranks) {
    std::string line;
    for (const std::string& setting : mpi_environment) {
        line += setting + " ";
    }
    return line + "mpirun --oversubscribe -n " + ranks;
}

/// Starts a program in the folder, waits until some tiles are in theirs, and does `strike` to it, which is given its
/// process. Returns the exit status, or minus the signal that ended it.
int interrupted(const samples::TemporaryFolder& folder, const std::string& program,
                const std::vector<std::string>& arguments, const fs::path& tiles,
                const std::function<void(pid_t)>& strike) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (chdir(folder.path().c_str()) != 0 || freopen("child.txt", "w", stderr) == nullptr ||
            freopen("/dev/null", "w", stdout) == nullptr) {
            _exit(3);
        }
        std::vector<char*> words{const_cast<char*>(program.c_str())};
        for (const std::string& argument : arguments) {
            words.push_back(const_cast<char*>(argument.c_str()));
        }
        words.push_back(nullptr);
        execvp(program.c_str(), words.data());
        _exit(3);
    }
    const auto count = [&] {
        std::error_code error;
        std::ptrdiff_t tiles_there = 0;
        for (const auto& entry : fs::directory_iterator(tiles, error)) {
            tiles_there += entry.path().extension() == ".tile" ? 1 : 0;
        }
        return tiles_there;
    };
    for (int i = 0; i < 60000 && count() < 3; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    strike(child);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

int interrupted(const samples::TemporaryFolder& folder, const std::vector<std::string>& arguments,
                const fs::path& tiles, int signal) {
    return interrupted(folder, tests::program(), arguments, tiles, [signal](pid_t child) { kill(child, signal); });
}

/// The process that mpirun started as this rank, with this word on its command line; 0: not found.
pid_t process_of_rank(int rank, const std::string& word) {
    const auto holds = [](const fs::path& file, const std::string& text) {
        std::ostringstream content;
        content << std::ifstream(file).rdbuf();
        return content.str().find(text + '\0') != std::string::npos;
    };
    std::error_code error;
    for (const auto& entry : fs::directory_iterator("/proc", error)) {
        const std::string name = entry.path().filename().string();
        if (name.find_first_not_of("0123456789") == std::string::npos && holds(entry.path() / "cmdline", word) &&
            holds(entry.path() / "environ", "OMPI_COMM_WORLD_RANK=" + std::to_string(rank))) {
            return static_cast<pid_t>(std::stol(name));
        }
    }
    return 0;
}

double stops_of(const fs::path& png) {
    return std::stod(tests::png_text(tests::contents(png), "exposure_stops"));
}

} // namespace

TEST_CASE("a traced picture is the same on any number of threads, and after kill -9 and Ctrl-C") {
    const samples::TemporaryFolder folder;
    folder.write("disk.toml", disk_scene);
    const std::string options = "disk.toml --size 320x192 ";
    const std::vector<std::string> words{"trace", "disk.toml", "--size", "320x192", "-o"};
    REQUIRE(run(folder, options + "-o one.exr --threads 1").status == 0);
    REQUIRE(run(folder, options + "-o three.exr --threads 3").status == 0);
    CHECK(bytes_of(folder, "one.exr") == bytes_of(folder, "three.exr"));
    CHECK_FALSE(fs::exists(folder.path() / "one.exr.tiles"));

    auto killed = words;
    killed.insert(killed.end(), {"killed.exr", "--threads", "1"});
    REQUIRE(interrupted(folder, killed, folder.path() / "killed.exr.tiles", SIGKILL) == -SIGKILL);
    CHECK_FALSE(fs::exists(folder.path() / "killed.exr"));
    const Run resumed = run(folder, options + "-o killed.exr --threads 2");
    CHECK(resumed.status == 0);
    CHECK(resumed.said.find("going on from") != std::string::npos);
    CHECK(bytes_of(folder, "killed.exr") == bytes_of(folder, "one.exr"));

    auto stopped = words;
    stopped.insert(stopped.end(), {"stopped.exr", "--threads", "1"});
    REQUIRE(interrupted(folder, stopped, folder.path() / "stopped.exr.tiles", SIGINT) == 1);
    std::ostringstream said;
    said << std::ifstream(folder.path() / "child.txt").rdbuf();
    CHECK(said.str().find("the same command goes on") != std::string::npos);
    // Other settings are another picture: refused until its tiles are thrown away.
    const Run other = run(folder, "disk.toml --size 320x192 --samples 3 -o stopped.exr");
    CHECK(other.status == 2);
    CHECK(other.said.find("--restart") != std::string::npos);
    CHECK(run(folder, options + "-o stopped.exr").status == 0);
    CHECK(bytes_of(folder, "stopped.exr") == bytes_of(folder, "one.exr"));
}

TEST_CASE("mpirun on two and three ranks makes the very same picture") {
    if (std::system("command -v mpirun >/dev/null 2>&1") != 0) {
        FAIL("no mpirun on this machine: openmpi-bin and libopenmpi-dev are needed");
    }
    const samples::TemporaryFolder folder;
    folder.write("disk.toml", disk_scene);
    const std::string options = "disk.toml --size 320x192 --threads 1 ";
    REQUIRE(run(folder, options + "-o alone.exr").status == 0);
    for (const std::string ranks : {"2", "3"}) {
        const std::string name = "ranks" + ranks + ".exr";
        const Run many = run(folder, std::string(options).append("-o ").append(name), mpirun(ranks));
        INFO(many.said);
        CHECK(many.status == 0);
        CHECK(bytes_of(folder, name) == bytes_of(folder, "alone.exr"));
        CHECK_FALSE(fs::exists(folder.path() / (name + ".tiles")));
    }
    // Bad input on every rank ends the run, with its line.
    const Run bad = run(folder, "disk.toml --param spin=2 -o bad.exr", mpirun("2"));
    CHECK(bad.status != 0);
    CHECK(bad.said.find("spin") != std::string::npos);
}

TEST_CASE("after a rank died under mpirun the same command makes the very same picture of the tiles it left") {
    const samples::TemporaryFolder folder;
    folder.write("disk.toml", disk_scene);
    REQUIRE(run(folder, "disk.toml --size 384x256 -o alone.exr").status == 0);
    const std::string picture = (folder.path() / "ranks.exr").string();
    std::vector<std::string> words = mpi_environment;
    words.insert(words.end(), {"mpirun", "--oversubscribe", "-n", "2", "--", tests::program(), "trace", "disk.toml",
                               "--threads", "1", "--size", "384x256", "-o", picture});
    bool struck = false;
    const int status = interrupted(folder, "env", words, picture + ".tiles", [&](pid_t) {
        const pid_t rank = process_of_rank(1, picture);
        struck = rank > 0 && kill(rank, SIGKILL) == 0;
    });
    REQUIRE(struck);
    CHECK(status != 0);
    CHECK_FALSE(fs::exists(picture));
    const Run again = run(folder, "disk.toml --threads 1 --size 384x256 -o ranks.exr", mpirun("2"));
    INFO(again.said);
    CHECK(again.status == 0);
    CHECK(again.said.find("going on from") != std::string::npos);
    CHECK(bytes_of(folder, "ranks.exr") == bytes_of(folder, "alone.exr"));
}

TEST_CASE(
    "the exposure of a sequence adapts from picture to picture, and an interrupted one goes on as it would have") {
    const samples::TemporaryFolder folder;
    // The camera nears a glowing ball under a dim sky.
    folder.write("scene.toml", R"([spacetime]
name = "minkowski"
[[camera.path]]
at = 0.0
position = [60.0, 0.0, 1.0]
[[camera.path]]
at = 1.0
position = [3.0, 0.0, 1.0]
[[sphere]]
radius = 1.5
emission = [40.0, 20.0, 10.0]
[sky]
colour = [0.02, 0.02, 0.03]
)");
    const std::string options = "scene.toml --size 200x150 --frames 5 --fps 25 ";
    REQUIRE(run(folder, options + "-o whole-##.png").status == 0);
    double factor = 0.0;
    for (int frame = 0; frame < 5; ++frame) {
        const std::string number = std::to_string(frame);
        // A picture alone is exposed at once.
        REQUIRE(
            run(folder, "scene.toml --size 200x150 --at " + std::to_string(0.25 * frame) + " -o alone.png").status ==
            0);
        const double alone = stops_of(folder.path() / "alone.png");
        const double time_constant = alone < factor ? 0.25 : 0.7; // AutoExposure's, faster to the bright
        factor = frame == 0 ? alone : factor + (alone - factor) * (1.0 - std::exp(-1.0 / 25.0 / time_constant));
        CHECK_THAT(stops_of(folder.path() / ("whole-0" + number + ".png")),
                   Catch::Matchers::WithinAbs(factor, 1e-5)); // metered in single precision
    }
    CHECK(std::abs(factor - stops_of(folder.path() / "alone.png")) > 0.5); // or there was nothing to adapt to

    const std::vector<std::string> words{"trace", "scene.toml", "--size",    "200x150", "--frames", "5",
                                         "--fps", "25",         "--threads", "1",       "-o",       "killed-##.png"};
    REQUIRE(interrupted(folder, words, folder.path() / "killed-##.png.tiles", SIGKILL) == -SIGKILL);
    CHECK_FALSE(fs::exists(folder.path() / "killed-04.png"));
    REQUIRE(run(folder, options + "-o killed-##.png").status == 0);
    for (int frame = 0; frame < 5; ++frame) {
        const std::string end = "-0" + std::to_string(frame) + ".png";
        CHECK(bytes_of(folder, "killed" + end) == bytes_of(folder, "whole" + end));
    }
}

TEST_CASE("a sequence along the camera's path writes a picture a frame, and its ends are the path's") {
    const samples::TemporaryFolder folder;
    folder.write("scene.toml", small_scene);
    REQUIRE(run(folder, "scene.toml --size 16x12 --frames 3 -o f-####.exr").status == 0);
    REQUIRE(run(folder, "scene.toml --size 16x12 --at 1 -o last.exr").status == 0);
    CHECK(bytes_of(folder, "f-0002.exr") == bytes_of(folder, "last.exr"));
    const auto middle = render::read_exr_metadata(folder.path() / "f-0001.exr");
    CHECK(std::get<glm::dvec3>(middle.at("camera_position")) == glm::dvec3(15.0, 1.0, 1.0));
    CHECK_FALSE(fs::exists(folder.path() / "f-####.exr.tiles"));
}

TEST_CASE("a picture of all the sky is a panorama with every direction in its place") {
    const samples::TemporaryFolder folder;
    // In flat space, a glowing ball low on the left.
    folder.write("scene.toml", R"([spacetime]
name = "minkowski"
[camera]
position = [0.0, 0.0, 0.0]
look = [0.0, 1.0, 0.0]
projection = "equirectangular"
[[sphere]]
centre = [-5.0, 0.0, -2.0]
radius = 1.0
emission = [3.0, 3.0, 3.0]
reflectance = [0.0, 0.0, 0.0]
)");
    REQUIRE(run(folder, "scene.toml --size 128x64 -o sky.exr").status == 0);
    const content::Panorama panorama = content::load_panorama(folder.path() / "sky.exr").panorama;
    REQUIRE(panorama.width == 128);
    // The camera looks along the panorama's -z with its up +y, so the ball is at (-5, -2, 0): longitude -90 degrees,
    // column a quarter of the width; 21.8 degrees below the horizon.
    const int row = static_cast<int>((90.0 + 21.8) / 180.0 * 64.0);
    CHECK_THAT(panorama.radiance[static_cast<std::size_t>(row * 128 + 32)].x, Catch::Matchers::WithinRel(3.0f, 1e-4f));
    CHECK(panorama.radiance[static_cast<std::size_t>(row * 128 + 96)].x == 0.0f);
    CHECK(panorama.radiance[static_cast<std::size_t>((63 - row) * 128 + 32)].x == 0.0f);
}

TEST_CASE("bad input of trace is told in one line and exits with 2") {
    const samples::TemporaryFolder folder;
    folder.write("scene.toml", small_scene);
    folder.write("spin.toml", "[spacetime]\nname = \"kerr\"\nspin = 1.01\n");
    folder.write("mass.toml", "[spacetime]\nname = \"schwarzschild\"\nmass = -1.0\n");
    folder.write("inside.toml", "[spacetime]\nname = \"schwarzschild\"\n[camera]\nposition = [0.001, 0.0, 0.0]\n");
    folder.write("within.toml", "[spacetime]\nname = \"kerr\"\n[[sphere]]\ncentre = [20.0, 0.0, 0.0]\n");
    folder.write("fast.toml", "[spacetime]\nname = \"kerr\"\n[[sphere]]\nvelocity = [0.0, 1.0, 0.0]\n");
    folder.write("key.toml", "[spacetime]\nname = \"kerr\"\n[camera]\npositoin = [1.0, 0.0, 0.0]\n");
    folder.write("nowhere.toml", "title = \"no spacetime\"\n");
    folder.write("disk.toml", "[spacetime]\nname = \"minkowski\"\n[disk]\nouter_radius = 9.0\n");
    folder.write("half.toml", "[metric]\ntt = -1\nxx = 1\nyy = 1\n");
    folder.write("metric.toml", "[spacetime]\nname = \"half.toml\"\n");
    folder.write("no-metric.toml", "[spacetime]\nname = \"no-such-metric.toml\"\n");
    folder.write("itself.toml", "[spacetime]\nname = \"itself.toml\"\n[camera]\nposition = [9.0, 0.0, 0.0]\n");
    const auto refused = [&](const std::string& arguments, const std::string& word) {
        const Run result = run(folder, arguments);
        INFO(arguments << "\n" << result.said);
        CHECK(result.status == 2);
        CHECK(result.said.find(word) != std::string::npos);
        CHECK(std::count(result.said.begin(), result.said.end(), '\n') == 1);
    };
    refused("spin.toml -o a.png", "spin");
    refused("mass.toml -o a.png", "mass");
    refused("inside.toml -o a.png", "camera");
    refused("within.toml -o a.png", "within an object");
    refused("fast.toml -o a.png", "slower than light");
    refused("key.toml -o a.png", "did you mean position");
    refused("nowhere.toml -o a.png", "spacetime");
    refused("disk.toml -o a.png", "disk");
    refused("metric.toml -o a.png", "metric.zz");
    refused("no-metric.toml -o a.png", "no-such-metric.toml");
    refused("itself.toml -o a.png", "itself.toml");
    CHECK_FALSE(fs::exists(folder.path() / "a.png.tiles")); // nothing is begun that cannot be done
    refused("scene.toml -o a.jpg", "extension");
    refused("scene.toml -o a.png --frames 2", "####");
    refused("scene.toml -o a.png --error 0", "--error");
    refused("scene.toml -o a.png --param spin", "--param");
    refused("scene.toml -o a.png --param speed=2", "speed");
    refused("kerr-dsk -o a.png", "kerr-disk");
    refused("scene.toml", "-o");
}
