#include "content/destination.h"

#include "content/csv.h"
#include "content/data_folders.h"
#include "content/nearest_name.h"
#include "content/star_catalogue.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>

namespace content {
namespace {

std::string lower(std::string text) {
    for (char& c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return text;
}

/// The brightest star within a twentieth of a degree: names go to what the eye sees there.
const Star* star_at(const std::vector<Star>& stars, const glm::dvec3& direction) {
    constexpr double near = 9e-4;
    const Star* brightest = nullptr;
    for (const Star& star : stars) {
        if (star.distance_known && glm::distance(glm::normalize(star.position), direction) < near &&
            (brightest == nullptr || star.visual_magnitude < brightest->visual_magnitude)) {
            brightest = &star;
        }
    }
    return brightest;
}

/// "HIP 71683", "hip71683", "71683"; 0 for anything else.
int hip_number(const std::string& text) {
    std::string digits = lower(text);
    if (digits.starts_with("hip")) {
        digits.erase(0, 3);
    }
    digits.erase(0, digits.find_first_not_of(' '));
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return error == std::errc() && end == digits.data() + digits.size() ? number : 0;
}

} // namespace

std::vector<StarName> load_star_names(const std::filesystem::path& file) {
    const CsvTable table = read_csv(file);
    const std::size_t name = table.column("name");
    const std::size_t hip = table.column("hip");
    const std::size_t right_ascension = table.column("right_ascension_deg");
    const std::size_t declination = table.column("declination_deg");
    std::vector<StarName> names;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        names.push_back({table.rows[row][name], static_cast<int>(table.number(row, hip)),
                         world_direction(table.number(row, right_ascension), table.number(row, declination))});
    }
    return names;
}

std::vector<Destination> destinations(const Scenario& scenario, double metres_per_light_unit) {
    std::vector<Destination> all;
    for (const Beacon& beacon : scenario.beacons) {
        all.push_back({beacon.name, {beacon.position / metres_per_light_unit, beacon.velocity}, 0, true});
    }
    if (!scenario.stars) {
        return all;
    }
    const double light_units_per_light_year = julian_year_seconds / scenario.clock_unit_seconds;
    const std::filesystem::path folder = content_folder() / "data";
    const std::vector<Star> stars = load_star_catalogue(folder / "stars.rstars");
    for (const StarName& name : load_star_names(folder / "star_names.csv")) {
        if (const Star* star = star_at(stars, name.direction)) {
            const double distance = glm::length(star->position);
            const double to_go = distance - star_clearance_light_years;
            all.push_back(
                {name.name, {star->position * (to_go / distance * light_units_per_light_year), {}}, name.hip});
        }
    }
    return all;
}

Destination find_destination(const std::vector<Destination>& all, const std::string& option, const std::string& text) {
    const int hip = hip_number(text);
    std::vector<std::string> names;
    for (const Destination& destination : all) {
        if (lower(destination.name) == lower(text) || (hip != 0 && destination.hip == hip)) {
            return destination;
        }
        names.push_back(destination.name);
    }
    if (names.empty()) {
        throw sim::BadInput(option, "", text, "this scenario has nothing to fly to: neither beacons nor stars");
    }
    throw sim::BadInput(option, "", text,
                        hip != 0
                            ? fmt::format("no star of that number has a name here; `rapidity plan --list` shows "
                                          "the {} that have",
                                          names.size())
                            : fmt::format("nothing of that name here; did you mean {}?", nearest_name(text, names)));
}

} // namespace content
