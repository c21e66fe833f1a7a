#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace render {

/// A piece of a light ray between two steps of its integrator, in chart components (t, x, y, z): a cubic Bezier curve,
/// rational where weights differ from 1. Its projected points enclose it where the weights are positive. s runs over
/// [0, 1] along the way that the ray is traced, back from the eye.
struct RayCurve {
    std::array<glm::dvec4, 4> points; ///< each times its weight
    std::array<double, 4> weights{1.0, 1.0, 1.0, 1.0};
    bool has_time = true;

    /// The cubic that has the ray's events and directions at both ends. `slope`s: dx/ds, that is dx/dlambda times the
    /// step in lambda.
    static RayCurve between(const glm::dvec4& from, const glm::dvec4& from_slope, const glm::dvec4& to,
                            const glm::dvec4& to_slope) {
        return {{from, from + from_slope / 3.0, to - to_slope / 3.0, to}};
    }
    /// A curve of places at no particular time, for what never moves. `homogeneous`: (w x, w y, w z, w).
    static RayCurve timeless(const std::array<glm::dvec4, 4>& homogeneous) {
        RayCurve curve{};
        curve.has_time = false;
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec4& h = homogeneous[i];
            curve.points[i] = {0.0, h.x, h.y, h.z};
            curve.weights[i] = h.w;
        }
        return curve;
    }
    glm::dvec4 at(double s) const { return blend(points, s) / blend(weights, s); }
    double weight(double s) const { return blend(weights, s); }
    glm::dvec4 slope(double s) const { return (rate(points, s) - rate(weights, s) * at(s)) / blend(weights, s); }

  private:
    template <class Value>
    static Value blend(const std::array<Value, 4>& p, double s) {
        const double r = 1.0 - s;
        return r * r * r * p[0] + 3.0 * r * r * s * p[1] + 3.0 * r * s * s * p[2] + s * s * s * p[3];
    }
    template <class Value>
    static Value rate(const std::array<Value, 4>& p, double s) {
        const double r = 1.0 - s;
        return 3.0 * (r * r * (p[1] - p[0]) + 2.0 * r * s * (p[2] - p[1]) + s * s * (p[3] - p[2]));
    }
};

/// The same piece in the three coordinates in which an object is at rest: Bezier points (w x, w y, w z, w).
using RestCurve = std::array<glm::dvec4, 4>;

/// The two parts of a curve, split at s (de Casteljau).
inline std::pair<RestCurve, RestCurve> parts(const RestCurve& c, double s) {
    const auto between = [s](const glm::dvec4& from, const glm::dvec4& to) { return (1.0 - s) * from + s * to; };
    const glm::dvec4 a = between(c[0], c[1]);
    const glm::dvec4 b = between(c[1], c[2]);
    const glm::dvec4 d = between(c[2], c[3]);
    const glm::dvec4 ab = between(a, b);
    const glm::dvec4 bd = between(b, d);
    const glm::dvec4 middle = between(ab, bd);
    return {{c[0], a, ab, middle}, {middle, bd, d, c[3]}};
}

} // namespace render
