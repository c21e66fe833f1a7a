#pragma once

#include "content/spectrum.h"

#include <array>

/// The standard spectra that colour is computed with, read from the data files that the program carries
/// (content/data/README.md).
namespace content {

/// CIE 1931 2-degree colour matching functions x, y, z; nothing outside 360 to 830 nm.
std::array<TabulatedSpectrum, 3> cie_1931_observer();

/// Standard illuminant D65, relative power, 300 to 830 nm.
TabulatedSpectrum illuminant_d65();

/// Reflectances of linear sRGB red, green and blue: within [0, 1] (to 1e-5), their sum is 1, constant outside 380 to
/// 730 nm.
std::array<TabulatedSpectrum, 3> reflectance_primaries();

} // namespace content
