#pragma once

#include "sim/quantities.h"

namespace engine {

/// Turns the pilot's time into whole ticks of ship time and says where between two ticks the picture stands. Pure: it
/// reads no clock. A slow frame never changes the physics: what exceeds the cap is dropped, and said.
class FixedStep {
  public:
    /// What one frame has to do.
    struct Steps {
        sim::Tick ticks = 0;        ///< whole ticks to fly now
        double fraction = 0.0;      ///< in [0, 1): the picture stands this far from the last tick but one to the last
        double dropped_seconds = 0; ///< pilot's time given up because the frame was slower than the cap
    };

    /// `tick_rate`: ticks per clock unit of ship time, > 0; `longest_frame_seconds`: pilot's time that one frame may
    /// make up for, > 0.
    explicit FixedStep(double tick_rate, double longest_frame_seconds = 0.25);

    /// A frame took `elapsed_seconds` of the pilot's time (negative counts as none).
    Steps advance(double elapsed_seconds);

    /// Clock units of ship time per second of the pilot's time, > 0: slow and fast motion.
    void set_pace(double clock_units_per_second);
    double pace() const { return pace_; }

    /// While paused only single ticks pass.
    void set_paused(bool paused) { paused_ = paused; }
    bool paused() const { return paused_; }
    void request_single_tick() { ++single_ticks_; }

  private:
    double tick_rate_;
    double longest_frame_seconds_;
    double pace_ = 1.0;
    bool paused_ = false;
    sim::Tick single_ticks_ = 0;
    double fraction_ = 0.0;
};

} // namespace engine
