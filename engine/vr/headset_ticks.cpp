#include "engine/vr/headset_ticks.h"

#include <algorithm>
#include <cmath>

namespace engine {

HeadsetTicks::HeadsetTicks(Headset& headset, const input::RoomScale& scale, const FixedStep::Steps& steps,
                           double seconds_per_tick)
    : headset_(headset), scale_(scale), seconds_per_tick_(seconds_per_tick),
      next_seconds_(seconds_per_tick * (2.0 - static_cast<double>(steps.ticks) - steps.fraction)) {}

bool HeadsetTicks::tick(Flight& flight, input::Pilot& hands) {
    input::HeadPilot pilot(hands, headset_.head_after(next_seconds_), scale_);
    const bool flown = flight.tick(pilot);
    next_seconds_ += flown ? seconds_per_tick_ : 0.0;
    return flown;
}

void note_frame(Flight& flight, const HeadsetFrame& frame, const input::RoomScale& scale, double fraction) {
    if (frame.shown) {
        flight.note_frame(fraction, input::with_head({}, frame.head, scale));
    }
}

double thrust_felt(const Flight& flight) {
    const glm::dvec3& felt = flight.state().felt_acceleration;
    const glm::dvec3& limit = flight.vehicle().maximum_acceleration;
    double share = 0.0;
    for (glm::length_t i = 0; i < 3; ++i) {
        const double most = std::isfinite(limit[i]) && limit[i] > 0.0 ? limit[i] : 1.0;
        share = std::max(share, std::abs(felt[i]) / most);
    }
    return std::min(share, 1.0);
}

} // namespace engine
