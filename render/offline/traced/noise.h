#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace render {

/// A sum of `octaves` of smooth noise, each of about twice the frequency and half the strength of the one before;
/// within (-1, 1). Smooth noise: random values on the integer lattice, joined by quintic curves. The same every time.
double fractal_noise(glm::dvec3 point, int octaves, std::uint64_t seed);

} // namespace render
