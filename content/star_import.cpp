#include "content/csv.h"
#include "content/star_catalogue.h"
#include "sim/bad_input.h"

#include <fmt/format.h>

namespace content {
namespace {

/// The numbers of one table of stars, checked.
class StarTable {
  public:
    explicit StarTable(const CsvTable& table)
        : table_(table), right_ascension_(table.column("right_ascension_deg")),
          declination_(table.column("declination_deg")), parallax_(table.column("parallax_mas")),
          magnitude_(table.column("v_mag")), colour_index_(table.column("b_minus_v")) {}

    Star star(std::size_t row) const {
        Star star;
        const double parallax = number(row, parallax_, -1e4, 1e4, 0.0);
        const double smallest = 1000.0 * light_years_per_parsec / far_shell_light_years;
        star.distance_known = parallax >= smallest;
        const double distance =
            star.distance_known ? 1000.0 * light_years_per_parsec / parallax : far_shell_light_years;
        star.position = distance * world_direction(number(row, right_ascension_, 0.0, 360.0),
                                                   number(row, declination_, -90.0, 90.0));
        star.visual_magnitude = static_cast<float>(number(row, magnitude_, -30.0, 30.0));
        constexpr double of_the_sun = 0.65;
        star.temperature = temperature_from_colour_index(number(row, colour_index_, -10.0, 10.0, of_the_sun));
        return star;
    }

  private:
    double number(std::size_t row, std::size_t column, double lowest, double highest) const {
        const double value = table_.number(row, column);
        if (value < lowest || value > highest) {
            throw sim::BadInput(table_.source,
                                fmt::format("line {}, {}", table_.line_numbers[row], table_.header[column]),
                                table_.rows[row][column], fmt::format("must be in {} to {}", lowest, highest));
        }
        return value;
    }

    double number(std::size_t row, std::size_t column, double lowest, double highest, double when_empty) const {
        return table_.rows[row][column].empty() ? when_empty : number(row, column, lowest, highest);
    }

    const CsvTable& table_;
    std::size_t right_ascension_;
    std::size_t declination_;
    std::size_t parallax_;
    std::size_t magnitude_;
    std::size_t colour_index_;
};

} // namespace

std::vector<Star> import_star_table(const std::filesystem::path& csv_file) {
    const CsvTable table = read_csv(csv_file);
    const StarTable reader(table);
    std::vector<Star> stars;
    stars.reserve(table.rows.size());
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        stars.push_back(reader.star(row));
    }
    return stars;
}

} // namespace content
