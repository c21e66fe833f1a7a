#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace render {

/// Smooth noise in [-1, 1]: random values on the integer lattice, joined by quintic curves. The same every time.
double smooth_noise(const glm::dvec3& point, std::uint64_t seed);

/// A sum of `octaves` of it, each of about twice the frequency and half the strength of the one before; within
/// (-1, 1).
double fractal_noise(glm::dvec3 point, int octaves, std::uint64_t seed);

} // namespace render
