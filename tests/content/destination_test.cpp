#include "content/destination.h"

#include "content/data_folders.h"
#include "content/scenario.h"
#include "sim/bad_input.h"
#include "tests/content/temporary_folder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <glm/geometric.hpp>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<content::Destination> of(const content::Scenario& scenario) {
    return content::destinations(scenario, scenario.metres_per_light_unit());
}

content::Scenario load(const std::string& toml) {
    const samples::TemporaryFolder folder;
    return content::load_scenario(folder.write("test.toml", toml).string());
}

} // namespace

TEST_CASE("stars are found by name and number, where the catalogue has them") {
    const std::vector<content::Destination> all = of(content::load_scenario("stars"));
    // Every name of the table has its star, and Earth is a clock besides.
    CHECK(all.size() == 1 + content::load_star_names(content::content_folder() / "data" / "star_names.csv").size());
    struct Known {
        const char* name;
        const char* number;
        double parallax; ///< thousandths of an arc second, as the catalogue's facts are known elsewhere
    };
    for (const Known& known : {Known{"alpha centauri", "HIP 71683", 742.12}, Known{"Sirius", "32349", 379.21},
                               Known{"Mintaka", "hip25930", 3.56}}) {
        const content::Destination star = content::find_destination(all, "--to", known.name);
        CHECK(content::find_destination(all, "--to", known.number).name == star.name);
        // The table is rounded to a tenth of a thousandth of an arc second or so.
        CHECK_THAT(glm::length(star.object.position_at_zero) + content::star_clearance_light_years,
                   WithinRel(3261.5638 / known.parallax, 0.02));
    }
}

TEST_CASE("beacons are destinations in light clock units, and clocks") {
    const content::Scenario scenario =
        load("speed_of_light = 10\n[[beacon]]\nname = \"home\"\nposition = [5, 0, -20]\n"
             "[[beacon]]\nname = \"bus\"\nposition = [0, 0, 0]\nvelocity = [0, 0, 0.5]\n");
    const std::vector<content::Destination> all = of(scenario);
    REQUIRE(all.size() == 2);
    CHECK(all[0].object.position_at_zero == glm::dvec3(0.5, 0.0, -2.0));
    CHECK(all[1].object.velocity == glm::dvec3(0.0, 0.0, 0.5));
    CHECK(all[1].is_beacon);
}

TEST_CASE("what is not there, and beacons that cannot be, are refused by name and value") {
    const auto refused = [](const auto& act, const char* a, const char* b) {
        CHECK_THROWS_MATCHES(act(), sim::BadInput, MessageMatches(ContainsSubstring(a) && ContainsSubstring(b)));
    };
    const std::vector<content::Destination> all = of(content::load_scenario("stars"));
    refused([&] { return content::find_destination(all, "--to", "Sirus"); }, "--to = Sirus", "did you mean Sirius?");
    refused([&] { return content::find_destination(all, "--to", "HIP 1"); }, "--to = HIP 1", "no star of that number");
    refused([&] { return content::find_destination({}, "--to", "Vega"); }, "--to = Vega", "nothing to fly to");
    refused([] { return load("[[beacon]]\nname = \"a\"\nposition = [0, 0, 0]\nvelocity = [1, 0, 0]\n"); },
            "beacon.velocity", "slower than light");
    refused([] { return load("[[beacon]]\nname = \"a\"\n"); }, "beacon = a", "a position");
    refused([] { return load("[[beacon]]\nname = \"a\"\nposition = [0, 0, 0]\ncolour = 1\n"); }, "beacon.colour",
            "not known");
    refused([] { return load("beacon = 3\n"); }, "beacon = 3", "[[beacon]]");
    refused([] { return load("[vehicle]\nexhaust_speed = 1.5\n"); }, "vehicle.exhaust_speed = 1.5", "x <= 1");
    refused([] { return load("[vehicle]\npropellant = -1\n"); }, "vehicle.propellant = -1", "0 <= x");
    refused([] { return load("[vehicle]\nmaximum_turn_acceleration = 0\n"); }, "maximum_turn_acceleration", "0 < x");
}
