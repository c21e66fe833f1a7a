#pragma once

#include "content/reflectance.h"
#include "engine/cockpit/comfort.h"
#include "engine/frame_builder.h"
#include "sim/vehicle.h"

#include <optional>
#include <string>

namespace engine {

class ImguiLayer;

/// The settings panel: modes, exposure, speed of light, vehicle limits.
class Panel {
  public:
    /// What the panel was asked to change in the flight itself; each once, when the hand lets go.
    struct Changes {
        std::optional<double> speed_of_light; ///< metres per second
        std::optional<sim::VehicleSettings> vehicle;
        std::string what; ///< of the vehicle's change, for the recording
        std::optional<content::ReflectanceModel> reflectance_model;
        std::optional<bool> microwave_background;
    };

    /// What the flight has now.
    struct Present {
        double speed_of_light = 0.0;     ///< metres per second
        double clock_unit_seconds = 1.0; ///< seconds in a clock unit
        std::string clock_unit = "s";
        sim::VehicleSettings vehicle;
        content::ReflectanceModel reflectance_model = content::ReflectanceModel::five_terms;
        bool microwave_background = false;
    };

    /// Draws the panel; `picture` and `comfort` are changed at once.
    Changes draw(const ImguiLayer& layer, PictureSettings& picture, ComfortSettings& comfort, const Present& present);

  private:
    std::optional<double> draw_speed_of_light(double present);
    void draw_vehicle(const Present& present, Changes& changes);

    // What a slider shows while the hand holds it.
    std::optional<float> held_speed_;
    std::optional<float> held_thrust_;
    std::optional<float> held_turn_;
    std::optional<float> held_boost_;
};

} // namespace engine
