#pragma once

#include "render/cabin/comfort_pass.h"

namespace engine {

/// What a pilot has chosen against feeling ill. All off: the picture is what the eye sees.
struct ComfortSettings {
    float vignette = 0.0F;       ///< how far the view narrows while the ship turns fast, in [0, 1]
    bool snap_turn = false;      ///< the controls that turn left and right turn by steps
    float snap_degrees = 30.0F;  ///< of a step, in [smallest_snap, largest_snap]
    float brightest = 1.0F;      ///< render::Display::brightest, in [darkest_limit, 1]: for the searchlight
    bool steady_horizon = false; ///< seat, hands and view stay level while the ship rolls (sim::level_roll)

    static constexpr float smallest_snap = 5.0F;
    static constexpr float largest_snap = 90.0F;
    static constexpr float darkest_limit = 0.1F;
};

/// Narrows the view while the ship turns: faster than it opens again.
class TurnVignette {
  public:
    /// `turn_rate`: radians in a second of the pilot's time. Returns what the picture is narrowed by, in [0, 1]: of the
    /// chosen strength the share of full_rate that the ship turns with.
    float advance(double turn_rate, float strength, double elapsed_seconds);

    static constexpr double full_rate = 1.0471975511965976; ///< 60 degrees a second
    static constexpr double closing_seconds = 0.1;          ///< time constants
    static constexpr double opening_seconds = 0.4;

  private:
    double share_ = 0.0;
};

/// Widgets for all of it, in the current ImGui window.
void draw_comfort_settings(ComfortSettings& comfort);

} // namespace engine
