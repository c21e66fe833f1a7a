#pragma once

#include "content/spectrum.h"

#include <glm/mat3x3.hpp>

#include <vector>

namespace render {

/// Reflectances of white and of red, yellow, green, cyan, blue and magenta (linear RGB 0 or 1) after the dominant
/// wavelength model (Weiskopf, Kobras, Ruder 2000, 5.3): as much white as it takes, and a line of 4 nm standard
/// deviation at the hue's dominant wavelength; magenta, which has none, is red and blue. Under `light` each gives its
/// RGB back exactly; lines reach far above 1. `rgb_from_xyz`: adapted RGB of XYZ whose Y is 1 for white under `light`.
std::vector<content::Spectrum> dominant_wavelength_terms(const content::Spectrum& light,
                                                         const glm::dmat3& rgb_from_xyz);

} // namespace render
