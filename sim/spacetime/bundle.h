#pragma once

#include "sim/spacetime/ray.h"

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

namespace sim {

/// A thin bundle of light around one ray: its Jacobi field, from an eye into the past, by automatic differentiation of
/// every step (the linearised geodesic equation, discretised exactly as the ray itself).
struct RayBundle {
    RayResult ray; ///< without drifts
    /// d(direction at infinity)/d(direction seen): how offsets along eye_axes show in offsets along sky_axes, both unit
    /// vectors across the ray, right-handed with it. Meaningful for escaped rays.
    glm::dmat2 sky_from_eye{0.0};
    std::array<glm::dvec3, 2> eye_axes; ///< in the eye's right, up, back
    std::array<glm::dvec3, 2> sky_axes; ///< in the chart's axes

    /// Solid angle seen over solid angle of sky; without end on a caustic. A point source looks that much larger: its
    /// irradiance is this times D^-4 that of its own.
    double magnification() const { return 1.0 / std::abs(glm::determinant(sky_from_eye)); }
    /// Whether the image is mirrored.
    bool mirrored() const { return glm::determinant(sky_from_eye) < 0.0; }
};

/// Two unit vectors across a unit vector, right-handed with it.
inline std::array<glm::dvec3, 2> axes_across(const glm::dvec3& n) {
    const glm::dvec3 other = std::abs(n.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 first = glm::normalize(glm::cross(other, n));
    return {first, glm::cross(n, first)};
}

/// The momentum far away in coordinates at rest there.
template <class Spacetime, class T>
Components<T> far_momentum(const Spacetime& spacetime, const GeodesicState<T>& state) {
    if constexpr (requires { spacetime.far_momentum(state); }) {
        return spacetime.far_momentum(state);
    } else {
        return state.momentum;
    }
}

/// As trace_ray, with the bundle. `visit` sees the ray's own segments.
template <class Spacetime, class Visitor = NoVisitor>
RayBundle trace_bundle(const Spacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                       const glm::dvec3& seen, const RaySettings& settings, Visitor&& visit = {}) {
    using D = Dual<double, 2>;
    RayBundle bundle;
    bundle.eye_axes = axes_across(seen);
    const GeodesicState<double> photon = seen_photon(spacetime, event, tetrad, seen);
    GeodesicState<D> state;
    const SymmetricTensor<double> g = spacetime.metric(event);
    for (int mu = 0; mu < 4; ++mu) {
        state.position[mu] = event[mu];
        state.momentum[mu] = photon.momentum[mu];
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& axis = bundle.eye_axes[i];
        const auto& e = tetrad.legs;
        const Components<double> change = g * (-axis.x * e[1] - axis.y * e[2] - axis.z * e[3]);
        for (int mu = 0; mu < 4; ++mu) {
            state.momentum[mu].slope[i] = change[mu];
        }
    }
    // The plain ray decides how many steps there are; the bundle takes the same.
    bundle.ray = follow_ray(spacetime, photon, settings, std::forward<Visitor>(visit));
    if (bundle.ray.outcome != RayOutcome::escaped) {
        return bundle;
    }
    const std::uint32_t reversed_steps = bundle.ray.reversed_steps;
    if (reversed_steps > 0) {
        state = in_other_chart(spacetime, state);
    }
    for (std::uint32_t i = 0; i < bundle.ray.steps; ++i) {
        state = geodesic_step(spacetime, state, -settings.step);
        if (i + 1 == reversed_steps) {
            state = in_other_chart(spacetime, state);
        }
    }
    const Components<D> p = far_momentum(spacetime, state);
    const D length = chart_radius(p);
    const std::array<D, 3> direction{-p.x / length, -p.y / length, -p.z / length};
    bundle.sky_axes = axes_across(bundle.ray.infinity.direction);
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3 moved(direction[0].slope[i], direction[1].slope[i], direction[2].slope[i]);
        bundle.sky_from_eye[static_cast<glm::length_t>(i)] = {glm::dot(moved, bundle.sky_axes[0]),
                                                              glm::dot(moved, bundle.sky_axes[1])};
    }
    return bundle;
}

} // namespace sim
