#pragma once

#include "content/spectrum.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace content {

/// What a measured spectrum is used for, which decides what it may hold.
enum class SpectrumUse : std::uint8_t {
    reflectance, ///< values in [0, 1], held beyond its ends
    light,       ///< values not negative, some within the visible; nothing beyond its ends
};

/// A spectrum from its samples (nm, value); a light's are scaled so that the largest is 1. Throws sim::BadInput naming
/// `source`, `field[sample][0 or 1]` and the value for: no samples, wavelengths that are not positive, do not rise, or
/// all lie outside of 40 nm to 12 um, values outside of what the use allows, a light of one sample or without any in
/// the visible. What the picture survives is noted: gaps within the visible, ends within it, samples of a reflectance
/// beyond 40 nm to 12 um.
Spectrum checked_spectrum(const std::vector<std::pair<double, double>>& samples, SpectrumUse use,
                          const std::string& source, const std::string& field, std::vector<std::string>& notes);

/// The same from a CSV file with the columns wavelength_nm and value; BadInput names line and column.
Spectrum read_spectrum(const std::filesystem::path& file, SpectrumUse use, std::vector<std::string>& notes);

} // namespace content
