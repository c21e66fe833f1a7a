#pragma once

#include "render/offline/traced/ray_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace render {

/// The share of a nearly straight curve's own parameter at which it is beside a point of its chord: along the chord it
/// need not run evenly. Newton's method.
inline double share_beside(const RestCurve& curve, double fraction_of_chord) {
    const glm::dvec3 chord = curve[3] - curve[0];
    const double length2 = glm::dot(chord, chord);
    const double first = glm::dot(curve[1] - curve[0], chord) / length2;
    const double second = glm::dot(curve[2] - curve[0], chord) / length2;
    double s = fraction_of_chord;
    for (int i = 0; i < 4; ++i) {
        const double r = 1.0 - s;
        const double reached = 3.0 * r * r * s * first + 3.0 * r * s * s * second + s * s * s;
        const double rate = 3.0 * (r * r * first + 2.0 * r * s * (second - first) + s * s * (1.0 - second));
        if (!(rate > 0.0)) {
            break;
        }
        s = std::clamp(s - (reached - fraction_of_chord) / rate, 0.0, 1.0);
    }
    return s;
}

/// First meeting of a curve with something within `radius` of the origin: the curve is halved until its pieces are
/// straight to `straightness` (same unit) and those that pass the ball by are left out. `meet(from, to)` returns the
/// fraction of the chord at which it is met, or nothing. Returns s in [0, 1].
template <class Meet>
std::optional<double> first_on_curve(const RestCurve& curve, double radius, double straightness, const Meet& meet,
                                     double s_from = 0.0, double s_to = 1.0, int depth = 0) {
    constexpr int deepest = 24;
    // All of the curve lies within `reach` of the chord's middle.
    const glm::dvec3 middle = 0.5 * (curve[0] + curve[3]);
    double reach2 = 0.0;
    for (const glm::dvec3& point : curve) {
        reach2 = std::max(reach2, glm::dot(point - middle, point - middle));
    }
    const double bound = radius + std::sqrt(reach2);
    if (glm::dot(middle, middle) > bound * bound) {
        return std::nullopt;
    }
    const glm::dvec3 third = (curve[3] - curve[0]) / 3.0;
    const double bend = std::max(glm::length(curve[1] - curve[0] - third), glm::length(curve[3] - curve[2] - third));
    if (bend <= straightness || depth == deepest) {
        const std::optional<double> fraction = meet(curve[0], curve[3]);
        return fraction ? std::optional(s_from + share_beside(curve, *fraction) * (s_to - s_from)) : std::nullopt;
    }
    const auto [near_half, far_half] = halves(curve);
    const double s_middle = 0.5 * (s_from + s_to);
    if (const auto s = first_on_curve(near_half, radius, straightness, meet, s_from, s_middle, depth + 1)) {
        return s;
    }
    return first_on_curve(far_half, radius, straightness, meet, s_middle, s_to, depth + 1);
}

/// Fraction of the chord at which it enters, or from inside leaves, the ball of `radius` about the origin.
inline std::optional<double> meet_ball(const glm::dvec3& from, const glm::dvec3& to, double radius) {
    const glm::dvec3 along = to - from;
    const double a = glm::dot(along, along);
    const double b = glm::dot(from, along);
    const double c = glm::dot(from, from) - radius * radius;
    const double discriminant = b * b - a * c;
    if (a == 0.0 || discriminant < 0.0) {
        return std::nullopt;
    }
    // The root with the sum is free of cancellation; the other is c over it.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    double first = q / a;
    double second = q != 0.0 ? c / q : first;
    if (first > second) {
        std::swap(first, second);
    }
    if (first >= 0.0 && first <= 1.0) {
        return first;
    }
    return second >= 0.0 && second <= 1.0 ? std::optional(second) : std::nullopt;
}

} // namespace render
