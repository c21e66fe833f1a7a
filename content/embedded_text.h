#pragma once

#include <string_view>

/// Data files compiled into the program; see content/data/README.md for what they are.
namespace content::embedded {

std::string_view cie1931_2deg_xyz_5nm();
std::string_view cie_d65_5nm();
std::string_view cie_test_colour_reflectances();
std::string_view reflectance_primaries();

} // namespace content::embedded
