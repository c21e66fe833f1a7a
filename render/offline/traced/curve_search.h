#pragma once

#include "render/offline/traced/ray_curve.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace render {

/// A curve's Bezier points as places, and how they lie about its chord.
struct CurveShape {
    std::array<glm::dvec3, 4> place;
    std::array<double, 2> share; ///< of the inner points' feet on the chord's line, 0 to 1 between its ends
    double bend = 0.0;           ///< the inner points' largest distance from that line
    double spread = 0.0;         ///< and from the chord: the curve is nowhere further from it

    explicit CurveShape(const RestCurve& curve) {
        for (std::size_t i = 0; i < 4; ++i) {
            place[i] = glm::dvec3(curve[i]) / curve[i].w;
        }
        const glm::dvec3 chord = place[3] - place[0];
        const double length2 = glm::dot(chord, chord);
        for (std::size_t i = 0; i < 2; ++i) {
            const glm::dvec3 offset = place[i + 1] - place[0];
            share[i] = length2 > 0.0 ? glm::dot(offset, chord) / length2 : 0.5;
            bend = std::max(bend, glm::length(offset - share[i] * chord));
            spread = std::max(spread, glm::length(offset - glm::clamp(share[i], 0.0, 1.0) * chord));
        }
    }
    /// Whether it runs along its chord, never back.
    bool runs_on() const { return 0.0 <= share[0] && share[0] <= share[1] && share[1] <= 1.0; }
    double distance_from_origin() const {
        const glm::dvec3 chord = place[3] - place[0];
        const double length2 = glm::dot(chord, chord);
        const double foot = length2 > 0.0 ? glm::clamp(-glm::dot(place[0], chord) / length2, 0.0, 1.0) : 0.0;
        return glm::length(place[0] + foot * chord);
    }
};

/// The s at which a curve that runs on is beside a point of its chord, a share of it: of a Bezier polynomial that
/// changes its sign once, the root. Newton's method, kept between bounds.
inline double s_beside(const RestCurve& curve, const CurveShape& shape, double fraction) {
    const std::array<double, 4> ahead{-fraction * curve[0].w, (shape.share[0] - fraction) * curve[1].w,
                                      (shape.share[1] - fraction) * curve[2].w, (1.0 - fraction) * curve[3].w};
    double low = 0.0;
    double high = 1.0;
    double s = fraction;
    for (int i = 0; i < 40 && high - low > 1e-15; ++i) {
        const double r = 1.0 - s;
        const double value =
            r * r * r * ahead[0] + 3.0 * r * r * s * ahead[1] + 3.0 * r * s * s * ahead[2] + s * s * s * ahead[3];
        const double rate =
            3.0 * (r * r * (ahead[1] - ahead[0]) + 2.0 * r * s * (ahead[2] - ahead[1]) + s * s * (ahead[3] - ahead[2]));
        (value > 0.0 ? high : low) = s;
        const double next = s - value / rate;
        const double before = s;
        s = next > low && next < high ? next : 0.5 * (low + high);
        if (std::abs(s - before) < 1e-14) {
            break;
        }
    }
    return s;
}

/// First meeting of a curve with something within `radius` of the origin: the curve is halved until its pieces are
/// straight to `straightness` (same unit) and those that pass the ball by are left out. `meet(from, to)` returns the
/// fraction of the chord at which it is met, or nothing. The curve's weight must be positive all along. Returns s in
/// [0, 1].
template <class Meet>
std::optional<double> first_on_curve(const RestCurve& curve, double radius, double straightness, const Meet& meet,
                                     double s_from = 0.0, double s_to = 1.0, int depth = 0) {
    constexpr int deepest = 24;
    // Points of no positive weight enclose nothing; those of the halves do sooner or later.
    if (curve[1].w > 0.0 && curve[2].w > 0.0) {
        const CurveShape shape(curve);
        if (!(shape.distance_from_origin() <= radius + shape.spread)) {
            return std::nullopt;
        }
        if ((shape.bend <= straightness && shape.runs_on()) || depth == deepest) {
            const std::optional<double> fraction = meet(shape.place[0], shape.place[3]);
            return fraction ? std::optional(s_from + s_beside(curve, shape, *fraction) * (s_to - s_from))
                            : std::nullopt;
        }
    } else if (depth == deepest) {
        return std::nullopt;
    }
    const auto [near_half, far_half] = parts(curve, 0.5);
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
