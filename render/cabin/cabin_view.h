#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace render {

/// A pinhole view's edges as tangents from straight ahead, right and up counted positive: `left` < `right`,
/// `down` < `up`. For a headset's eye they are the tangents of its four angles.
struct ViewTangents {
    double left = -1.0;
    double right = 1.0;
    double down = -1.0;
    double up = 1.0;
};

/// An eye in the cabin and what its screen covers. The cabin is at rest with the pilot: nothing of it is aberrated.
struct CabinView {
    glm::dvec3 eye{0.0};                           ///< cabin frame, metres
    glm::dquat cabin_from_eye{1.0, 0.0, 0.0, 0.0}; ///< rotation
    ViewTangents tangents;

    /// Where a point of the cabin is seen: tangents from straight ahead; only for points ahead of the eye.
    glm::dvec2 tangents_of(const glm::dvec3& point) const {
        const glm::dvec3 from_eye = glm::conjugate(cabin_from_eye) * (point - eye);
        return {from_eye.x / -from_eye.z, from_eye.y / -from_eye.z};
    }
    /// Shares of the picture, from its lower left corner, of a place given by its tangents.
    glm::dvec2 place_of(const glm::dvec2& at) const {
        return {(at.x - tangents.left) / (tangents.right - tangents.left),
                (at.y - tangents.down) / (tangents.up - tangents.down)};
    }
};

} // namespace render
