#pragma once

#include "input/pilot.h"
#include "input/xr_pose.h"

#include <utility>

namespace input {

/// From the pilot's room to the ship's units.
struct RoomScale {
    double metres_per_light_unit = 299792458.0;
    double clock_units_per_second = 1.0; ///< of ship time, per second of the pilot's
};

/// Nobody's head moves as fast as light, however slow that is: c.
inline constexpr double fastest_head = 0.9;

/// The demand with a head: `vehicle_head` in the vehicle, metres and metres a second of the pilot's time.
sim::ControlFrame with_head(sim::ControlFrame demand, const XrMotion& vehicle_head, const RoomScale& scale);

/// Puts a head on another pilot's demands.
class HeadPilot final : public Pilot {
  public:
    /// `hands` must outlive this.
    HeadPilot(Pilot& hands, XrMotion vehicle_head, const RoomScale& scale)
        : hands_(hands), vehicle_head_(std::move(vehicle_head)), scale_(scale) {}

    std::optional<sim::ControlFrame> control(sim::Tick tick) override;

  private:
    Pilot& hands_;
    XrMotion vehicle_head_;
    RoomScale scale_;
};

} // namespace input
