#include "input/head_pilot.h"

#include <glm/geometric.hpp>

namespace input {

sim::ControlFrame with_head(sim::ControlFrame demand, const XrMotion& vehicle_head, const RoomScale& scale) {
    demand.head_position = vehicle_head.place.position / scale.metres_per_light_unit;
    demand.vehicle_from_head = vehicle_head.place.orientation;
    demand.head_velocity = vehicle_head.velocity / (scale.clock_units_per_second * scale.metres_per_light_unit);
    if (const double speed = glm::length(demand.head_velocity); speed > fastest_head) {
        demand.head_velocity *= fastest_head / speed;
    }
    return demand;
}

std::optional<sim::ControlFrame> HeadPilot::control(sim::Tick tick) {
    std::optional<sim::ControlFrame> demand = hands_.control(tick);
    return demand ? with_head(*demand, vehicle_head_, scale_) : demand;
}

} // namespace input
