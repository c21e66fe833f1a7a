#pragma once

#include "sim/flight_log.h"
#include "sim/vehicle.h"

#include <optional>
#include <string>
#include <vector>

namespace engine {

class ImguiLayer;

/// The panel beside the settings: target, cruise rapidity, turn acceleration, and the log of the flight.
class VoyagePanel {
  public:
    /// What the panel was asked to change in the flight; each once, when the hand lets go.
    struct Changes {
        std::optional<std::size_t> target; ///< of Present::destinations
        std::optional<double> cruise;      ///< rapidity
        std::optional<sim::VehicleSettings> vehicle;
        std::string what; ///< of the vehicle's change, for the recording
    };

    /// What the flight has now.
    struct Present {
        std::vector<std::string> destinations;
        std::optional<std::size_t> target;
        double cruise = 0.0;
        std::string clock_unit = "s";
        sim::VehicleSettings vehicle;
        const std::vector<sim::FlightEvent>& events;
    };

    Changes draw(const ImguiLayer& layer, const Present& present);

  private:
    // What a slider shows while the hand holds it.
    std::optional<float> held_cruise_;
    std::optional<float> held_turn_;
};

} // namespace engine
