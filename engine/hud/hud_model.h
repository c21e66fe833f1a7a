#pragma once

#include "engine/hud/navigation_reading.h"
#include "render/render_frame.h"
#include "sim/readings.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace engine {

/// One pane of the picture that the instruments lie over. Places and lengths are shares of the whole, from its upper
/// left corner.
struct HudPane {
    std::string name;
    double left = 0.0;
    double top = 0.0;
    double width = 1.0;
    double height = 1.0;
    double horizontal_field_of_view = 1.5707963267948966;
    render::Display display;
    double exposure_stops_used = 0.0;
};

/// A spectrum at a point of the picture.
struct HudProbe {
    static constexpr double first_nm = 100.0; ///< of the curves, which are even in the logarithm
    static constexpr double last_nm = 10000.0;

    double x = 0.0; ///< shares of the whole picture, from its upper left corner
    double y = 0.0;
    std::vector<std::string> lines;
    std::string unit;              ///< of the curves
    double wavelength_ratio = 1.0; ///< D
    std::vector<double> emitted;   ///< spectral radiance
    std::vector<double> received;
};

/// The readouts along the lower edge are as high, in points.
inline constexpr float readouts_height = 90.0F;

/// Everything the instruments show, as plain data.
struct HudModel {
    std::string title;
    sim::Readings readings;
    double ship_clock = 0.0;  ///< clock units
    double world_clock = 0.0; ///< clock units
    std::string clock_unit = "s";
    double felt_g = 0.0; ///< in g

    glm::dvec3 nose_in_head{0.0, 0.0, -1.0};              ///< unit; where the nose points, head axes
    glm::dvec3 motion_in_head{0.0};                       ///< unit; where the ship is going, head axes; zero at rest
    double horizontal_field_of_view = 1.5707963267948966; ///< of the whole picture
    std::vector<HudPane> panes;                           ///< at least one

    render::Mode mode = render::Mode::full;
    render::Exposure exposure;

    double frame_seconds = 0.0;    ///< 0: no frame rate to show (film)
    double resolution_scale = 1.0; ///< < 1: dynamic resolution is at work
    double relative_pace = 1.0;    ///< of the scenario's own pace
    bool paused = false;
    bool recording = false;
    std::string recording_trouble; ///< "" while all is well
    std::vector<std::string> notices;
    std::optional<HudProbe> probe;
    NavigationReading navigation;
    std::string camera;          ///< name and clock of a camera that is not the pilot's; "" for the pilot's
    bool cockpit = false;        ///< motion, clocks and navigation are read on the cockpit's screens
    float above_readouts = 0.0F; ///< points above the readouts that somebody else draws in
};

/// "everything", "geometry and Doppler", ...
std::string mode_name(render::Mode mode);

} // namespace engine
