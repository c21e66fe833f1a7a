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

/// A spectrum from its samples (nm, value). Throws sim::BadInput naming `source`, `field` and the value for: no
/// samples, wavelengths that are not positive or do not rise, values outside of what the use allows. What the picture
/// survives is noted: gaps within the visible, ends within it.
Spectrum checked_spectrum(const std::vector<std::pair<double, double>>& samples, SpectrumUse use,
                          const std::string& source, const std::string& field, std::vector<std::string>& notes);

/// The same from a CSV file with the columns wavelength_nm and value.
Spectrum read_spectrum(const std::filesystem::path& file, SpectrumUse use, std::vector<std::string>& notes);

} // namespace content
