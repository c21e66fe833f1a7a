#pragma once

#include "content/spectrum.h"

#include <array>
#include <vector>

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

/// The same three with what real greens and reds do in the infrared and ultraviolet: their sum is 1; then a term of
/// greens and one of reds, nothing within the visible. Constant below 300 and above 2500 nm.
std::array<TabulatedSpectrum, 5> reflectance_five_terms();

/// Vegetation: red, green, blue (sum 1) and a term of what is dark. Constant below 300 and above 2500 nm.
std::array<TabulatedSpectrum, 4> reflectance_vegetation_terms();

/// Reflectances of the CIE's 15 test colours, measured 360 to 830 nm, held beyond.
std::vector<TabulatedSpectrum> cie_test_colours();

} // namespace content
