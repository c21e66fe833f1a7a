#include "render/colour/dominant_wavelength.h"

#include "render/colour/observer.h"

#include <array>
#include <cmath>

namespace render {
namespace {

constexpr double deviation_nm = 4.0;
constexpr double first_nm = 360.0;
constexpr double last_nm = 830.0;

double line_at(double nm, double centre_nm) {
    const double x = (nm - centre_nm) / deviation_nm;
    return std::exp(-0.5 * x * x);
}

class Lines {
  public:
    Lines(const content::Spectrum& light, const glm::dmat3& rgb_from_xyz)
        : light_(light), rgb_from_xyz_(rgb_from_xyz),
          white_y_(observer_.xyz([&](double nm) { return light.at(nm); }).y) {}

    /// Adapted RGB of a line of height 1 on black.
    glm::dvec3 rgb(double centre_nm) const {
        return rgb_from_xyz_ *
               (observer_.xyz([&](double nm) { return light_.at(nm) * line_at(nm, centre_nm); }) / white_y_);
    }

    /// The wavelength between `from` and `to` where components i and j of a line's RGB are equal.
    double where_equal(int i, int j, double from, double to) const {
        const auto difference = [&](double nm) { return rgb(nm)[i] - rgb(nm)[j]; };
        const bool rising = difference(from) < 0.0;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (from + to);
            ((difference(middle) < 0.0) == rising ? from : to) = middle;
        }
        return 0.5 * (from + to);
    }

    /// a + b line so that the RGB is 1 in component `high` and 0 in `low`, and between them by the line's own hue.
    content::TabulatedSpectrum hue(double centre_nm, int high, int low) const {
        const glm::dvec3 line = rgb(centre_nm);
        const double height = 1.0 / (line[high] - line[low]);
        content::TabulatedSpectrum spectrum;
        spectrum.first_nm = first_nm;
        spectrum.beyond = content::TabulatedSpectrum::Beyond::held;
        for (double nm = first_nm; nm <= last_nm; nm += 1.0) {
            spectrum.values.push_back(height * (line_at(nm, centre_nm) - line[low]));
        }
        return spectrum;
    }

  private:
    Observer observer_;
    const content::Spectrum& light_;
    glm::dmat3 rgb_from_xyz_;
    double white_y_;
};

} // namespace

std::vector<content::Spectrum> dominant_wavelength_terms(const content::Spectrum& light,
                                                         const glm::dmat3& rgb_from_xyz) {
    constexpr int red = 0;
    constexpr int green = 1;
    constexpr int blue = 2;
    const Lines lines(light, rgb_from_xyz);
    content::TabulatedSpectrum white;
    white.first_nm = first_nm;
    white.step_nm = last_nm - first_nm;
    white.values = {1.0, 1.0};
    white.beyond = content::TabulatedSpectrum::Beyond::held;
    // Brackets: within each the two components' order along the spectrum changes once.
    const auto red_hue = lines.hue(lines.where_equal(green, blue, 590.0, 680.0), red, green);
    const auto yellow = lines.hue(lines.where_equal(red, green, 555.0, 600.0), red, blue);
    const auto green_hue = lines.hue(lines.where_equal(red, blue, 510.0, 570.0), green, red);
    const auto cyan = lines.hue(lines.where_equal(green, blue, 480.0, 505.0), green, red);
    const auto blue_hue = lines.hue(lines.where_equal(red, green, 440.0, 478.0), blue, red);
    content::TabulatedSpectrum magenta = red_hue;
    for (std::size_t i = 0; i < magenta.values.size(); ++i) {
        magenta.values[i] += blue_hue.values[i];
    }
    std::vector<content::Spectrum> terms;
    for (const auto& table : {white, red_hue, yellow, green_hue, cyan, blue_hue, magenta}) {
        terms.emplace_back(content::Spectrum::Factor(table));
    }
    return terms;
}

} // namespace render
