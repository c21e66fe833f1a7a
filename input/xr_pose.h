#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <array>

#include <openxr/openxr.h>

namespace input {

/// Where something is and how it is turned: metres; axes as a camera's (x right, y up, -z ahead), as OpenXR's are.
struct XrPlace {
    glm::dvec3 position{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
};

/// a_from_b and b_from_c make a_from_c.
inline XrPlace operator*(const XrPlace& a, const XrPlace& b) {
    return {a.position + a.orientation * b.position, a.orientation * b.orientation};
}
inline XrPlace inverse(const XrPlace& a) {
    const glm::dquat back = glm::conjugate(a.orientation);
    return {-(back * a.position), back};
}

/// A head or a hand, and how it moves, metres a second of the pilot's time.
struct XrMotion {
    XrPlace place;
    glm::dvec3 velocity{0.0};
    bool tracked = false;  ///< false: the runtime does not know; the place is the last that it knew
    bool measured = false; ///< the runtime told the velocity; false: it is 0, or whoever knows more filled it in
};

/// Of a head: one eye. Edges of its screen as tangents of the angles from its axis, left and down negative.
struct XrEye {
    XrPlace head_from_eye;
    double left = -1.0;
    double right = 1.0;
    double down = -1.0;
    double up = 1.0;
};
using XrEyes = std::array<XrEye, 2>; ///< left, right

inline XrPlace place_of(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    return {{pose.position.x, pose.position.y, pose.position.z},
            glm::normalize(glm::dquat(static_cast<double>(q.w), static_cast<double>(q.x), static_cast<double>(q.y),
                                      static_cast<double>(q.z)))};
}

inline XrPosef pose_of(const XrPlace& place) {
    const glm::dquat& q = place.orientation;
    return {{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)},
            {static_cast<float>(place.position.x), static_cast<float>(place.position.y),
             static_cast<float>(place.position.z)}};
}

} // namespace input
