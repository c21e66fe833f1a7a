#pragma once

#include "engine/option_values.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace engine {

/// Whose eyes a picture of a flight is seen by.
enum class CameraKind : std::uint8_t {
    pilot, ///< the pilot's own, recorded head and all
    free,  ///< rests in the ship wherever it is put, and looks where the viewer looks
    world, ///< an inertial observer, who sees the ship come and go
    chase, ///< behind and above the ship
    twin,  ///< in the other ship
};

inline constexpr NamedValues<CameraKind, 5> camera_names{{{"pilot", CameraKind::pilot},
                                                          {"free", CameraKind::free},
                                                          {"world", CameraKind::world},
                                                          {"chase", CameraKind::chase},
                                                          {"twin", CameraKind::twin}}};

/// Which camera, and where it is.
struct CameraSettings {
    CameraKind kind = CameraKind::pilot;
    /// World: where it is at the world's time 0, scene metres; none: beside the ship's way. Free and chase: from the
    /// pilot's eyes, right, up and back along the ship, scene metres; none: at them, and 4 above and 16 behind.
    std::optional<glm::dvec3> place;
    glm::dvec3 velocity{0.0};       ///< of the world's camera, c = 1, shorter than 1
    std::optional<glm::dvec3> look; ///< of the world's camera, unit; none: it turns to where the ship is seen
};

} // namespace engine
