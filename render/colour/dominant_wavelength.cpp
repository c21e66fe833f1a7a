#include "render/colour/dominant_wavelength.h"

#include "content/reflectance.h"
#include "render/colour/observer.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double deviation_nm = 4.0;
constexpr double first_nm = 360.0;
constexpr double last_nm = 830.0;
/// Ends of the dominant wavelengths. Beyond, a hue turns by less than a fourteenth of a sextant more, but its line
/// would have to be twice as high and more: the eye hardly sees it.
constexpr double shortest_nm = 440.0;
constexpr double longest_nm = 640.0;
/// Two lines of 4 nm make one peak where they are less than 8 nm apart.
constexpr double widest_gap_nm = 5.0;

/// Exactly nothing beyond six deviations, so that tables need not look there.
double line_at(double nm, double centre_nm) {
    const double x = (nm - centre_nm) / deviation_nm;
    return std::abs(x) < 6.0 ? std::exp(-0.5 * x * x) : 0.0;
}

/// Linear RGB with greatest component 1 and least 0.
glm::dvec3 pure_colour(int step) {
    const int sextant = step / HueWheel::steps_per_sextant;
    const double t = static_cast<double>(step % HueWheel::steps_per_sextant) / HueWheel::steps_per_sextant;
    switch (sextant) {
    case 0:
        return {1.0, t, 0.0};
    case 1:
        return {1.0 - t, 1.0, 0.0};
    case 2:
        return {0.0, 1.0, t};
    case 3:
        return {0.0, 1.0 - t, 1.0};
    case 4:
        return {t, 0.0, 1.0};
    default:
        return {1.0, 0.0, 1.0 - t};
    }
}

/// Lines on white, and their places on the wheel.
class Lines {
  public:
    Lines(const content::Spectrum& light, const glm::dmat3& rgb_from_xyz) {
        rgb_from_xyz_ = rgb_from_xyz;
        Observer().xyz_each([&](double nm, const glm::dvec3& matching) {
            white_.push_back({nm, light.at(nm) * matching});
            white_y_ += white_.back().xyz.y;
        });
    }

    /// The hue of a line, in steps that go on below 0 in the deep red.
    double step_of(double centre_nm) const {
        const double steps = HueWheel::steps_per_sextant * content::hue_of(rgb(centre_nm)).sextants;
        return steps > 0.9 * HueWheel::step_count ? steps - HueWheel::step_count : steps;
    }

    /// The wavelength whose line has this hue; steps fall as wavelengths rise.
    double wavelength_of(int step) const {
        double below = shortest_nm;
        double above = longest_nm;
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (below + above);
            (step_of(middle) > step ? below : above) = middle;
        }
        return 0.5 * (below + above);
    }

    /// White and lines that have this RGB.
    content::Spectrum reflectance(const glm::dvec3& wanted, double first_centre_nm, double second_centre_nm) const {
        const glm::dvec3 weights =
            glm::inverse(glm::dmat3(glm::dvec3(1.0), rgb(first_centre_nm), rgb(second_centre_nm))) * wanted;
        return tabulated([&](double nm) {
            return weights.x + weights.y * line_at(nm, first_centre_nm) + weights.z * line_at(nm, second_centre_nm);
        });
    }
    content::Spectrum reflectance(double centre_nm) const {
        const glm::dvec3 line = rgb(centre_nm);
        const content::Hue hue = content::hue_of(line);
        return tabulated([&](double nm) { return (line_at(nm, centre_nm) - hue.least) / hue.chroma; });
    }

  private:
    /// Adapted RGB of a line of height 1 on black.
    glm::dvec3 rgb(double centre_nm) const {
        glm::dvec3 xyz(0.0);
        for (const Received& received : white_) {
            xyz += line_at(received.nm, centre_nm) * received.xyz;
        }
        return rgb_from_xyz_ * (xyz / white_y_);
    }

    template <class Reflectance>
    static content::Spectrum tabulated(const Reflectance& reflectance) {
        content::TabulatedSpectrum spectrum;
        spectrum.first_nm = first_nm;
        spectrum.beyond = content::TabulatedSpectrum::Beyond::held;
        for (double nm = first_nm; nm <= last_nm; nm += 1.0) {
            spectrum.values.push_back(reflectance(nm));
        }
        return content::Spectrum(content::Spectrum::Factor(spectrum));
    }

    struct Received {
        double nm;
        glm::dvec3 xyz;
    };
    std::vector<Received> white_; ///< what the eye sees of white, by wavelengths
    double white_y_ = 0.0;
    glm::dmat3 rgb_from_xyz_{1.0};
};

/// Steps from the deep red (below 0) to the violet that are tabulated, with their wavelengths.
struct SpectralMarks {
    std::vector<int> steps;
    std::vector<double> nanometres;
};

SpectralMarks spectral_marks(const Lines& lines) {
    SpectralMarks marks;
    const auto add = [&](int step) {
        marks.steps.push_back(step);
        marks.nanometres.push_back(lines.wavelength_of(step));
    };
    const int last = static_cast<int>(std::floor(lines.step_of(shortest_nm)));
    add(static_cast<int>(std::ceil(lines.step_of(longest_nm))));
    while (marks.steps.back() < last) {
        const int before = marks.steps.back();
        // Within a sextant hues are mixed linearly, so each of its corners is a mark.
        int corner = before + 1;
        while (corner % HueWheel::steps_per_sextant != 0) {
            ++corner;
        }
        const int within_gap = static_cast<int>(std::floor(lines.step_of(marks.nanometres.back() - widest_gap_nm)));
        add(std::clamp(within_gap, before + 1, std::min(corner, last)));
    }
    return marks;
}

} // namespace

HueWheel::HueWheel(const std::vector<int>& marks) : hues_(marks.size()), steps_(step_count) {
    for (std::size_t hue = 0; hue < marks.size(); ++hue) {
        const int end = hue + 1 < marks.size() ? marks[hue + 1] : step_count;
        for (int step = marks[hue]; step < end; ++step) {
            steps_[static_cast<std::size_t>(step)] = {static_cast<std::uint32_t>(hue),
                                                      static_cast<float>(marks[hue]) / steps_per_sextant,
                                                      steps_per_sextant / static_cast<float>(end - marks[hue])};
        }
    }
}

HueWheel::Beside HueWheel::beside(double sextants) const {
    const int step = std::clamp(static_cast<int>(sextants * steps_per_sextant), 0, step_count - 1);
    const HueStep& found = steps_[static_cast<std::size_t>(step)];
    const double share = (sextants - static_cast<double>(found.start)) * static_cast<double>(found.per_sextant);
    return {found.hue, std::clamp(share, 0.0, 1.0)};
}

DominantWavelengths dominant_wavelengths(const content::Spectrum& light, const glm::dmat3& rgb_from_xyz) {
    const Lines lines(light, rgb_from_xyz);
    const SpectralMarks spectral = spectral_marks(lines);

    content::TabulatedSpectrum white;
    white.first_nm = first_nm;
    white.step_nm = last_nm - first_nm;
    white.values = {1.0, 1.0};
    white.beyond = content::TabulatedSpectrum::Beyond::held;
    DominantWavelengths result;
    result.terms.emplace_back(content::Spectrum::Factor(white));

    std::vector<int> marks;
    const auto add = [&](int step, content::Spectrum spectrum) {
        marks.push_back(step);
        result.terms.push_back(std::move(spectrum));
    };
    const auto add_spectral = [&](bool deep_red) {
        for (std::size_t i = 0; i < spectral.steps.size(); ++i) {
            if ((spectral.steps[i] < 0) == deep_red) {
                add(spectral.steps[i] + (deep_red ? HueWheel::step_count : 0),
                    lines.reflectance(spectral.nanometres[i]));
            }
        }
    };
    add_spectral(false);
    const int deepest_red = std::min(spectral.steps.front(), 0) + HueWheel::step_count;
    for (int corner = 0; corner < HueWheel::step_count; corner += HueWheel::steps_per_sextant) {
        if (corner > spectral.steps.back() && corner < deepest_red) {
            add(corner,
                lines.reflectance(pure_colour(corner), spectral.nanometres.front(), spectral.nanometres.back()));
        }
    }
    add_spectral(true);
    result.wheel = HueWheel(marks);
    return result;
}

} // namespace render
