#pragma once

#include "content/spectrum.h"

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <vector>

/// The dominant wavelength model (Weiskopf, Kobras, Ruder 2000, 5.3): an RGB reflectance is as much white as it takes,
/// and a line at the dominant wavelength of its hue. Purples, which have none, mix the lines at both ends.
namespace render {

/// Of which tabulated hues a hue is mixed. std430 layout.
struct HueStep {
    std::uint32_t hue = 0; ///< the tabulated hue at `start`; the other is the next, after the last the first
    float start = 0.0f;    ///< sextants
    float per_sextant = 0.0f;
};

/// Hues (content::Hue) in even steps, each within one pair of neighbours among the tabulated ones.
class HueWheel {
  public:
    static constexpr int steps_per_sextant = 64;
    static constexpr int step_count = 6 * steps_per_sextant;

    HueWheel() = default; ///< of no hues
    /// `marks`: rising steps at which the tabulated hues lie, the first 0.
    explicit HueWheel(const std::vector<int>& marks);

    std::size_t hues() const { return hues_; }
    const std::vector<HueStep>& steps() const { return steps_; } ///< step_count of them

    struct Beside {
        std::size_t hue = 0;
        double share = 0.0; ///< of the next hue, [0, 1]
    };
    /// `sextants` in [0, 6].
    Beside beside(double sextants) const;

  private:
    std::size_t hues_ = 0;
    std::vector<HueStep> steps_;
};

/// Reflectances of white, then of the wheel's hues, of linear RGB whose greatest component is 1 and whose least is 0.
struct DominantWavelengths {
    std::vector<content::Spectrum> terms;
    HueWheel wheel;
};

/// Lines have a standard deviation of 4 nm, lie from 440 to 640 nm and at most 5 nm from one tabulated hue to the next,
/// so two neighbours make one peak; under `light` each hue gives its RGB back exactly. Lines reach about 10.
/// `rgb_from_xyz`: adapted RGB of XYZ whose Y is 1 for white under `light`.
DominantWavelengths dominant_wavelengths(const content::Spectrum& light, const glm::dmat3& rgb_from_xyz);

} // namespace render
