#pragma once

#include "engine/hud/imgui_layer.h"
#include "engine/replay_timeline.h"

#include <optional>
#include <string>
#include <vector>

namespace engine {

/// A replay's timeline above the readouts: thrust, beta and gamma over ship time, marks, and where the replay stands.
/// A mouse on it scrubs.
class TimelineStrip {
  public:
    /// What it takes above the readouts, in points.
    static constexpr float height = 78.0F;

    explicit TimelineStrip(const ReplayDeck& deck);

    /// Draws into the current ImGui frame. Returns where the mouse has put the replay, in ticks.
    std::optional<double> draw(const ImguiLayer& layer, const ReplayDeck& deck, const std::string& clock_unit) const;

  private:
    std::vector<TimelinePoint> points_;
    double largest_thrust_ = 0.0;
    double largest_rapidity_ = 0.0;
};

} // namespace engine
