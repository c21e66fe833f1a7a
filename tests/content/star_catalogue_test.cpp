#include "content/data_folders.h"
#include "content/scenario.h"
#include "content/spectrum.h"
#include "content/star_catalogue.h"
#include "sim/bad_input.h"
#include "tests/content/temporary_folder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

constexpr double arc_seconds_per_radian = 206264.806;

double angle_in_arc_seconds(const glm::dvec3& a, const glm::dvec3& b) {
    return arc_seconds_per_radian * 2.0 * std::asin(0.5 * glm::distance(glm::normalize(a), glm::normalize(b)));
}

const std::string header = "right_ascension_deg,declination_deg,parallax_mas,v_mag,b_minus_v,spectral_type\n";

const std::vector<content::Star>& catalogue() {
    static const auto stars = content::load_star_catalogue(content::content_folder() / "data" / "stars.rstars");
    return stars;
}

/// The star nearest in the sky to a direction.
const content::Star& star_towards(double right_ascension, double declination) {
    const glm::dvec3 direction = content::world_direction(right_ascension, declination);
    return *std::max_element(catalogue().begin(), catalogue().end(), [&](const auto& a, const auto& b) {
        return glm::dot(glm::normalize(a.position), direction) < glm::dot(glm::normalize(b.position), direction);
    });
}

} // namespace

TEST_CASE("the sky's axes") {
    constexpr double rounding = 1e-15;
    CHECK(glm::distance(content::world_direction(0, 0), glm::dvec3(1, 0, 0)) < rounding);
    CHECK(glm::distance(content::world_direction(90, 0), glm::dvec3(0, 0, -1)) < rounding);
    CHECK(glm::distance(content::world_direction(123, 90), glm::dvec3(0, 1, 0)) < rounding);
}

TEST_CASE("the catalogue holds the known neighbours") {
    CHECK(catalogue().size() == 125982);
    // Sirius: J2000 06h45m08.9s -16d42m58s, 8.60 light-years (parallax 379.2 mas), V = -1.46 (-1.44 in Hipparcos).
    const auto& sirius = star_towards(101.28717, -16.71611);
    CHECK(std::abs(glm::length(sirius.position) - 8.60) < 0.01);
    CHECK(std::abs(sirius.visual_magnitude + 1.44f) < 0.01f);
    CHECK(angle_in_arc_seconds(sirius.position, content::world_direction(101.28717, -16.71611)) < 0.1);
    CHECK(sirius.temperature > 9000.0f);
    // Alpha Centauri A at 4.39 light-years: 1000 / 742.1 parsec.
    const auto& alpha_centauri = star_towards(219.90208, -60.83397);
    CHECK(std::abs(glm::length(alpha_centauri.position) - 4.395) < 0.001);
    // Betelgeuse and Rigel in Orion, ahead of a ship that looks along -z: one red, one blue.
    const auto& betelgeuse = star_towards(88.793, 7.407);
    const auto& rigel = star_towards(78.634, -8.202);
    CHECK(glm::normalize(betelgeuse.position).z < -0.98);
    CHECK(betelgeuse.temperature < 4000.0f);
    CHECK(rigel.temperature > 9000.0f);
    // Polaris stands 0.74 degrees from the pole.
    CHECK(std::abs(glm::degrees(std::asin(glm::normalize(star_towards(37.95, 89.26).position).y)) - 89.26) < 0.01);
}

TEST_CASE("stars of unknown distance stand on the far shell") {
    std::size_t unknown = 0;
    double farthest = 0.0;
    for (const auto& star : catalogue()) {
        const double distance = glm::length(star.position);
        if (!star.distance_known) {
            ++unknown;
            // Rounding of a double.
            CHECK(std::abs(distance / content::far_shell_light_years - 1.0) < 1e-12);
        } else {
            farthest = std::max(farthest, distance);
        }
    }
    // Counted in the table: 1,374 parallaxes of zero or less and 2,226 of 0.1 to 0.3 mas.
    CHECK(unknown == 3600);
    CHECK(farthest <= content::far_shell_light_years);
}

TEST_CASE("a scene with stars says how many are at no known distance") {
    content::Scenario scenario;
    scenario.stars = true;
    const auto scene = content::load_scene(scenario);
    CHECK(scene.stars.size() == 125982);
    REQUIRE(scene.notes.size() == 1);
    CHECK_THAT(scene.notes[0], ContainsSubstring("3600 of 125982 stars are at no known distance"));
}

TEST_CASE("temperature from B-V") {
    // Ballesteros' formula for the Sun (B-V = 0.65) gives 5,778 K within a per cent; Vega (0.00) is an A0 star of about
    // 9,600 K, Betelgeuse (1.85) one of 3,300 to 3,600 K.
    CHECK(std::abs(content::temperature_from_colour_index(0.65) / 5778.0f - 1.0f) < 0.01f);
    CHECK(std::abs(content::temperature_from_colour_index(0.0) - 10125.0f) < 1.0f);
    CHECK(content::temperature_from_colour_index(1.85) < 3600.0f);
    CHECK(content::temperature_from_colour_index(5.0) == content::temperature_from_colour_index(2.0));
    CHECK(content::temperature_from_colour_index(-3.0) == content::temperature_from_colour_index(-0.4));
}

namespace {

/// A passband in steps of 10 nm: Bessell, "UBVRI passbands", PASP 102 (1990) 1181, table 2, for integrals of energy.
struct Passband {
    double first_nm;
    std::vector<double> values;

    double mean(double kelvin) const {
        double sum = 0.0;
        double weight = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum += values[i] * content::black_body_radiance(first_nm + 10.0 * static_cast<double>(i), kelvin);
            weight += values[i];
        }
        return sum / weight;
    }
};

/// B-V of a black body by those filters; zero points 632 and 363.1e-11 erg / (cm^2 s A) (Bessell, Castelli, Plez 1998,
/// table A2).
double colour_index_of_black_body(double kelvin) {
    const Passband blue{360.0, {0.0,   0.030, 0.134, 0.567, 0.920, 0.978, 1.0,   0.978, 0.935, 0.853, 0.740,
                                0.640, 0.536, 0.424, 0.325, 0.235, 0.150, 0.095, 0.043, 0.009, 0.0}};
    const Passband visual{470.0, {0.0,   0.030, 0.163, 0.458, 0.780, 0.967, 1.0,   0.973, 0.898, 0.792, 0.684, 0.574,
                                  0.461, 0.359, 0.270, 0.197, 0.135, 0.081, 0.045, 0.025, 0.017, 0.013, 0.009, 0.0}};
    return -2.5 * std::log10(blue.mean(kelvin) / visual.mean(kelvin)) + 2.5 * std::log10(632.0 / 363.1);
}

} // namespace

TEST_CASE("black bodies of the catalogue's temperatures have the stars' colours through real filters") {
    const auto off = [](double b_minus_v) {
        return colour_index_of_black_body(static_cast<double>(content::temperature_from_colour_index(b_minus_v))) -
               b_minus_v;
    };
    // Stars like the Sun are black bodies to the eye. Away from it stars part from black bodies of their effective
    // temperature by a quarter of a magnitude for each: hot ones lack the light beyond the Balmer jump (they look less
    // blue than a black body), cool ones are reddened by lines and molecules. Effective temperatures are kept, which is
    // what blueshift reveals. The quarter bends by a tenth over the catalogue's range.
    CHECK(std::abs(off(0.65)) < 0.02);
    for (double b_minus_v = -0.3; b_minus_v <= 1.5; b_minus_v += 0.1) {
        CHECK(std::abs(off(b_minus_v) + 0.25 * (b_minus_v - 0.6)) < 0.035);
    }
}

TEST_CASE("what a table says survives the catalogue within its stated errors") {
    const samples::TemporaryFolder folder;
    std::string table = header;
    for (int i = 0; i < 500; ++i) {
        table += std::to_string(std::fmod(i * 137.50776, 360.0)) + "," + std::to_string(-90.0 + i * 180.0 / 499.0) +
                 "," + std::to_string(0.4 + 1.7 * i) + "," + std::to_string(-1.5 + 0.025 * i) + "," +
                 std::to_string(-0.4 + 0.005 * i) + ",X\n";
    }
    const auto imported = content::import_star_table(folder.write("table.csv", table));
    const auto read = content::parse_star_catalogue(content::star_catalogue_bytes(imported), "stars");
    REQUIRE(read.size() == imported.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        // Half a millionth of a degree each way: 0.0026 arc seconds. The chord of so small an angle loses digits: 1e-15
        // rad.
        CHECK(angle_in_arc_seconds(read[i].position, imported[i].position) < 0.003);
        // Single precision.
        CHECK(std::abs(glm::length(read[i].position) / glm::length(imported[i].position) - 1.0) < 1e-7);
        CHECK(std::abs(read[i].visual_magnitude - imported[i].visual_magnitude) < 0.00051f);
        CHECK(std::abs(read[i].temperature - imported[i].temperature) <= 0.5f);
        CHECK(read[i].distance_known);
    }
}

TEST_CASE("a parallax that tells nothing") {
    const samples::TemporaryFolder folder;
    const std::string parallax = GENERATE("0", "-3.2", "", "0.3");
    const auto stars =
        content::import_star_table(folder.write("table.csv", header + "90,45," + parallax + ",5.5,,K0\n"));
    REQUIRE(stars.size() == 1);
    CHECK_FALSE(stars[0].distance_known);
    const auto read = content::parse_star_catalogue(content::star_catalogue_bytes(stars), "stars");
    CHECK_FALSE(read.at(0).distance_known);
    CHECK(glm::distance(read[0].position, content::far_shell_light_years * content::world_direction(90, 45)) < 1e-6);
}

TEST_CASE("tables of stars that cannot be are refused with line and column") {
    const samples::TemporaryFolder folder;
    const auto check = [&](const std::string& text, const std::string& message) {
        CHECK_THROWS_MATCHES(content::import_star_table(folder.write("table.csv", text)), sim::BadInput,
                             MessageMatches(ContainsSubstring(message)));
    };
    check("ra,dec\n1,2\n", "right_ascension_deg: this column is missing");
    check(header + "90,95,1,5,0.5,K\n", "line 2, declination_deg = 95: must be in -90 to 90");
    check(header + "nan,5,1,5,0.5,K\n", "line 2, right_ascension_deg = nan");
    check(header + "90,5,1,five,0.5,K\n", "line 2, v_mag = five");
    CHECK_THROWS_MATCHES(content::import_star_table(folder.write("table.csv.gz", std::string("\x1F\x8B\x08 broken"))),
                         sim::BadInput, MessageMatches(ContainsSubstring("truncated or damaged")));
}

TEST_CASE("a damaged star catalogue is refused") {
    const samples::TemporaryFolder folder;
    const auto stars = content::import_star_table(
        folder.write("table.csv", header + "10,20,30,4,0.5,A\n40,-50,60,7,0.8,B\n70,80,90,1,1.1,C\n"));
    const auto whole = content::star_catalogue_bytes(stars);
    for (std::size_t kept = 0; kept < whole.size(); ++kept) {
        CHECK_THROWS_AS(content::parse_star_catalogue(std::span(whole).first(kept), "stars"), sim::BadInput);
    }
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        auto damaged = whole;
        damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
        // A bit that packing ignores may change; then the stars are the same.
        try {
            const auto read = content::parse_star_catalogue(damaged, "stars");
            REQUIRE(read.size() == stars.size());
            CHECK(std::abs(read[1].visual_magnitude - 7.0f) < 0.001f);
        } catch (const sim::BadInput&) {
        }
    }
    auto later = whole;
    later[8] = 2;
    CHECK_THROWS_MATCHES(content::parse_star_catalogue(later, "stars"), sim::BadInput,
                         MessageMatches(ContainsSubstring("stars: version = 2")));
    CHECK_THROWS_MATCHES(content::load_star_catalogue(folder.write("text.rstars", "hello, this is a text")),
                         sim::BadInput, MessageMatches(ContainsSubstring("not a star catalogue")));
}
