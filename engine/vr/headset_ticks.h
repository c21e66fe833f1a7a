#pragma once

#include "engine/fixed_step.h"
#include "engine/vr/headset.h"
#include "input/head_pilot.h"

namespace engine {

/// The ticks of one frame, flown with the headset's head. `ticks` ticks lead up to the frame, which stands `fraction`
/// of the way from the last but one to the last: so the head of the last tick is that of a moment after the frame is
/// seen, and pictures between ticks lie between heads that were measured.
class HeadsetTicks {
  public:
    /// `headset` must outlive this.
    HeadsetTicks(Headset& headset, const input::RoomScale& scale, const FixedStep::Steps& steps,
                 double seconds_per_tick);

    /// Flies the next tick as `hands` demand, with the head where it is then; see Flight::tick.
    bool tick(Flight& flight, input::Pilot& hands);

  private:
    Headset& headset_;
    input::RoomScale scale_;
    double seconds_per_tick_;
    double next_seconds_; ///< of the next tick, after the frame is seen
};

/// Puts into the recording what a frame shows.
void note_frame(Flight& flight, const HeadsetFrame& frame, const input::RoomScale& scale, double fraction);

/// How hard the ship thrusts: the share of its limit, without boost, in [0, 1].
double thrust_felt(const Flight& flight);

} // namespace engine
