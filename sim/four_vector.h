#pragma once

#include "sim/conventions.h"

#include <glm/vec3.hpp>

namespace sim {

/// A four-vector's components (t, x, y, z) in the frame `Frame`, c = 1.
template <class Frame>
struct FourVector {
    double t = 0.0;
    glm::dvec3 space{0.0};

    friend FourVector operator+(const FourVector& a, const FourVector& b) { return {a.t + b.t, a.space + b.space}; }
    friend FourVector operator-(const FourVector& a, const FourVector& b) { return {a.t - b.t, a.space - b.space}; }
    friend FourVector operator*(double s, const FourVector& a) { return {s * a.t, s * a.space}; }
    friend bool operator==(const FourVector&, const FourVector&) = default;
};

/// Minkowski product, signature (-,+,+,+).
template <class Frame>
double dot(const FourVector<Frame>& a, const FourVector<Frame>& b) {
    return a.space.x * b.space.x + a.space.y * b.space.y + a.space.z * b.space.z - a.t * b.t;
}

/// A point of spacetime, relative to the world's origin.
using Event = FourVector<World>;

/// Unit vector in `Frame` that says where light is seen coming from.
template <class Frame>
struct Direction {
    glm::dvec3 unit{0.0, 0.0, -1.0};
};

} // namespace sim
