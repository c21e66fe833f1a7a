#include "content/nearest_name.h"
#include "content/scenario.h"
#include "content/scenario_keys.h"
#include "sim/bad_input.h"
#include "tests/content/gltf_samples.h"
#include "tests/content/temporary_folder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

content::Scenario load(const samples::TemporaryFolder& folder, const std::string& toml) {
    return content::load_scenario(folder.write("test.toml", toml).string());
}

void check_refused(const std::string& toml, const std::string& field, const std::string& reason = "") {
    const samples::TemporaryFolder folder;
    CHECK_THROWS_MATCHES(load(folder, toml), sim::BadInput,
                         MessageMatches(ContainsSubstring("test.toml: " + field) && ContainsSubstring(reason)));
}

} // namespace

TEST_CASE("a scenario keeps what its file says") {
    const samples::TemporaryFolder folder;
    folder.write("square.glb", samples::square_glb());
    folder.write("flight.csv", "duration,ax,ay,az,wx,wy,wz\n1,0,0,-1,0,0,0\n");
    const auto scenario = load(folder, R"(
        title = "A square"
        model = "square.glb"
        speed_of_light = 5
        pace = 0.5
        demonstration = "flight.csv"
        ambient = [0.1, 0.2, 0.3]
        [start]
        position = [1, 2, 3]
        look = [0, 0, -2]
        beta = 0.5
        field_of_view = 60
        [vehicle]
        maximum_acceleration = 2
        maximum_turn_rate = [1, 2, 3]
        [exposure]
        automatic = false
        stops = -1.5
        [sun]
        direction = [0, 3, 4]
    )");
    CHECK(scenario.name == "test");
    CHECK(scenario.title == "A square");
    CHECK(scenario.model == folder.path() / "square.glb");
    CHECK(scenario.demonstration == (folder.path() / "flight.csv").string());
    CHECK(scenario.speed_of_light == 5.0);
    CHECK(scenario.pace == 0.5);
    CHECK(scenario.ambient == glm::vec3(0.1f, 0.2f, 0.3f));
    CHECK(scenario.start_position == glm::dvec3(1, 2, 3));
    CHECK(scenario.start_look == glm::dvec3(0, 0, -1));
    CHECK(scenario.start_beta == 0.5);
    CHECK(std::abs(scenario.horizontal_field_of_view - std::acos(0.5)) < 1e-15);
    CHECK(scenario.vehicle.maximum_acceleration == glm::dvec3(2.0));
    CHECK(scenario.vehicle.maximum_turn_rate == glm::dvec3(1, 2, 3));
    CHECK_FALSE(scenario.exposure.automatic);
    CHECK(scenario.exposure.stops == -1.5);
    REQUIRE(scenario.sun);
    CHECK(glm::distance(scenario.sun->direction, glm::vec3(0.0f, 0.6f, 0.8f)) < 1e-7f);
    CHECK(scenario.sun->irradiance == content::Sun{}.irradiance);

    const auto scene = content::load_scene(scenario);
    CHECK(scene.instances.size() == 1);
    CHECK(scene.ambient == scenario.ambient);
    // The scenario's sun replaces the model's.
    CHECK(scene.sun->direction == scenario.sun->direction);
}

TEST_CASE("keys that are not known are named with the nearest that is") {
    check_refused("speed_of_ligth = 3", "speed_of_ligth = 3: this key is not known; did you mean speed_of_light?");
    check_refused("[start]\nbetta = 0.5", "start.betta = 0.5: this key is not known; did you mean start.beta?");
    check_refused("[startt]\nbeta = 0.5", "startt");
    check_refused("beta = 0.5", "beta = 0.5", "did you mean start.beta?");
}

TEST_CASE("values that cannot be are refused with their key") {
    check_refused("[start]\nbeta = 1.0", "start.beta = 1.0: must be a finite number with 0 <= x < 1");
    check_refused("[start]\nbeta = nan", "start.beta = nan");
    check_refused("[start]\nposition = [0, inf, 0]", "start.position = ");
    check_refused("[start]\nposition = [0, 1]", "start.position = [ 0, 1 ]: must be three numbers in brackets");
    check_refused("[start]\nlook = [0, 0, 0]", "start.look = [ 0, 0, 0 ]: must not be zero");
    check_refused("start = 3", "start = 3");
    check_refused("speed_of_light = 0", "speed_of_light = 0");
    check_refused("light_temperature = 0", "light_temperature = 0: must be a finite number with 1000 <= x");
    check_refused("light_temperature = -5", "light_temperature = -5");
    check_refused("light_temperature = nan", "light_temperature = nan");
    check_refused("light_temperature = 1e30", "light_temperature = 1e+30");
    check_refused("reflectance = \"nice\"", "reflectance = 'nice': must be one of five-terms");
    check_refused("microwave_background = 1", "microwave_background = 1: must be true or false");
    check_refused("ambient = [0, -1, 0]", "ambient = -1: must be a finite number with 0 <= x");
    check_refused("speed_of_light = -inf", "speed_of_light = -inf");
    check_refused("speed_of_light = \"fast\"", "speed_of_light = ");
    check_refused("stars = 1", "stars = 1: must be true or false");
    check_refused("title = 5", "title = 5: must be a text in quotes");
    check_refused("model = \"\"", "model = ");
    check_refused("model = \"nowhere.glb\"", "model = ", "there is no file");
    check_refused("model = \"generated:latice\"", "model = ", "did you mean generated:lattice?");
    check_refused("demonstration = \"nowhere.csv\"", "demonstration = ", "there is no file");
    check_refused("[vehicle]\nboost_factor = 0.5", "vehicle.boost_factor = 0.5");
    check_refused("[sun]\nirradiance = [1e39, 0, 0]", "sun.irradiance = ", "beyond the range of single precision");
    check_refused("title = \"one\"\ntitle = \"two\"", "line 2");
    check_refused("[start\n", "line 1");
}

TEST_CASE("a bare model starts at its camera") {
    const samples::TemporaryFolder folder;
    const auto file = folder.write("square.glb", samples::square_glb());
    const auto scenario = content::load_scenario(file.string());
    CHECK(scenario.name == "square");
    CHECK(scenario.start_position == glm::dvec3(5, 6, 7));
    CHECK(scenario.start_look == glm::dvec3(-1, 0, 0));
    CHECK_FALSE(scenario.sun);
    CHECK(content::load_scene(scenario).sun);
}

TEST_CASE("a bare model without camera and light is framed and lit") {
    const samples::TemporaryFolder folder;
    samples::GltfSample sample;
    const int positions = sample.floats({100, 0, 0, 104, 0, 0, 100, 3, 0}, 3);
    const auto file = folder.write(
        "far.glb",
        sample.glb(fmt::format(
            R"("nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}}}]}}])",
            positions)));
    const auto scenario = content::load_scenario(file.string());
    CHECK(scenario.sun);
    // Every corner lies within 30 degrees of the middle of a picture that is 90 degrees wide.
    for (const auto& corner : {glm::dvec3(100, 0, 0), glm::dvec3(104, 0, 0), glm::dvec3(100, 3, 0)}) {
        const glm::dvec3 towards = glm::normalize(corner - scenario.start_position);
        CHECK(glm::dot(towards, scenario.start_look) > std::sqrt(0.75) - 1e-6);
    }
    // Light crosses the diagonal of 5 m in four seconds.
    CHECK(std::abs(scenario.speed_of_light - 1.25) < 1e-6);
}

TEST_CASE("a scenario without a start begins at the model's camera") {
    const samples::TemporaryFolder folder;
    folder.write("square.glb", samples::square_glb());
    CHECK(load(folder, "model = \"square.glb\"").start_position == glm::dvec3(5, 6, 7));
    CHECK(load(folder, "model = \"square.glb\"\n[start]\nposition = [0, 0, 0]").start_position == glm::dvec3(0.0));
}

TEST_CASE("a panorama that was not fetched is missed, not refused") {
    const samples::TemporaryFolder folder;
    const auto scenario = load(folder, "panorama = \"studiolight:no such sky.exr\"");
    REQUIRE(content::missing_content(scenario).size() == 1);
    CHECK_THAT(content::missing_content(scenario)[0],
               ContainsSubstring("no such sky.exr is missing; ./fly fetches it"));
    const auto scene = content::load_scene(scenario);
    CHECK_FALSE(scene.panorama);
    CHECK(scene.notes == content::missing_content(scenario));
    check_refused("panorama = \"nowhere.exr\"", "panorama = ", "there is no file");
}

TEST_CASE("a scenario's own panorama is turned and scaled") {
    const samples::TemporaryFolder folder;
    folder.write("sky.png", samples::png);
    const auto scene =
        content::load_scene(load(folder, "panorama = \"sky.png\"\npanorama_scale = 2\npanorama_turn = 180"));
    REQUIRE(scene.panorama);
    // Half way round, red and green change places.
    CHECK(scene.panorama->radiance[0] == glm::vec3(0.0f, 2.0f, 0.0f));
    CHECK(scene.panorama->radiance[1] == glm::vec3(2.0f, 0.0f, 0.0f));
}

TEST_CASE("every built-in scenario is read and has a title of its own") {
    const auto scenarios = content::built_in_scenarios();
    CHECK_FALSE(scenarios.empty());
    std::set<std::string> titles;
    for (const auto& scenario : scenarios) {
        INFO(scenario.name);
        CHECK_FALSE(scenario.title.empty());
        CHECK(titles.insert(scenario.title).second);
        CHECK(content::load_scenario(scenario.name).title == scenario.title);
    }
}

TEST_CASE("a scenario that is not there is named with the nearest that is") {
    CHECK_THROWS_MATCHES(content::load_scenario("latice"), sim::BadInput,
                         MessageMatches(ContainsSubstring("did you mean lattice?")));
    CHECK_THROWS_AS(content::load_scenario("nowhere.toml"), sim::BadInput);
    CHECK_THROWS_AS(content::load_scenario("nowhere.glb"), sim::BadInput);
}

TEST_CASE("every key is documented and its default is in its range") {
    std::set<std::string_view> names;
    const content::Scenario defaults;
    for (const auto& key : content::scenario_keys()) {
        INFO(key.name);
        CHECK(names.insert(key.name).second);
        CHECK_FALSE(key.meaning.empty());
        CHECK_FALSE(content::value_text(key, defaults).empty());
    }
}

TEST_CASE("the nearest name has the fewest letters to change") {
    CHECK(content::nearest_name("lattise", {"street", "lattice", "stars"}) == "lattice");
    CHECK(content::nearest_name("str", {"stars", "street"}) == "stars");
    CHECK(content::nearest_name("", {"ab", "a"}) == "a");
    CHECK(content::nearest_name("x", {}).empty());
}
