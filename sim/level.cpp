#include "sim/level.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

constexpr double tight = 0.1; ///< sines of the nose's angle from the vertical
constexpr double free = 0.3;

} // namespace

glm::dquat level_roll(const Lorentz<World, Vehicle>& world_from_vehicle) {
    const BoostAndRotation motion = split({world_from_vehicle.spin});
    const glm::dvec3 up = glm::transpose(motion.boosted_from_head) * glm::dvec3(0.0, 1.0, 0.0);
    const double across = std::hypot(up.x, up.y); // sine of the nose's angle from the vertical
    const double t = std::clamp((across - tight) / (free - tight), 0.0, 1.0);
    // About +z, to the left. Upside down a rounding must not decide which way around.
    const double aside = std::abs(up.x) < 1e-9 ? 0.0 : -up.x;
    const double roll = t == 0.0 ? 0.0 : std::atan2(aside, up.y);
    return glm::angleAxis(t * t * (3.0 - 2.0 * t) * roll, glm::dvec3(0.0, 0.0, 1.0));
}

} // namespace sim
