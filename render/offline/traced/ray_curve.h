#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>

namespace render {

/// A piece of a light ray between two steps of its integrator, in chart components (t, x, y, z): the cubic that has the
/// ray's events and directions at both ends, as Bezier points, which enclose it. s runs over [0, 1] along the way that
/// the ray is traced, back from the eye.
struct RayCurve {
    std::array<glm::dvec4, 4> points;

    /// `slope`s: dx/ds, that is dx/dlambda times the step in lambda.
    static RayCurve between(const glm::dvec4& from, const glm::dvec4& from_slope, const glm::dvec4& to,
                            const glm::dvec4& to_slope) {
        return {{from, from + from_slope / 3.0, to - to_slope / 3.0, to}};
    }
    glm::dvec4 at(double s) const {
        const double r = 1.0 - s;
        return r * r * r * points[0] + 3.0 * r * r * s * points[1] + 3.0 * r * s * s * points[2] +
               s * s * s * points[3];
    }
    glm::dvec4 slope(double s) const {
        const double r = 1.0 - s;
        return 3.0 * (r * r * (points[1] - points[0]) + 2.0 * r * s * (points[2] - points[1]) +
                      s * s * (points[3] - points[2]));
    }
};

/// The same piece in the three coordinates in which an object is at rest.
using RestCurve = std::array<glm::dvec3, 4>;

/// The two halves of a curve (de Casteljau).
inline std::pair<RestCurve, RestCurve> halves(const RestCurve& c) {
    const glm::dvec3 a = 0.5 * (c[0] + c[1]);
    const glm::dvec3 b = 0.5 * (c[1] + c[2]);
    const glm::dvec3 d = 0.5 * (c[2] + c[3]);
    const glm::dvec3 ab = 0.5 * (a + b);
    const glm::dvec3 bd = 0.5 * (b + d);
    const glm::dvec3 middle = 0.5 * (ab + bd);
    return {{c[0], a, ab, middle}, {middle, bd, d, c[3]}};
}

} // namespace render
