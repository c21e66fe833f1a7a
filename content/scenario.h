#pragma once

#include "content/scene_desc.h"
#include "sim/vehicle.h"

#include <glm/vec3.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace content {

inline constexpr double julian_year_seconds = 31557600.0;

/// How the picture is exposed at the start.
struct ExposureSettings {
    bool automatic = true;
    double stops = 0.0; ///< manual: log2 of the factor on radiance; automatic: compensation
};

/// A clock in uniform motion, which the instruments show as it is seen, and a place to fly to.
struct Beacon {
    std::string name;
    glm::dvec3 position{0.0}; ///< at world time 0, scene metres, world
    glm::dvec3 velocity{0.0}; ///< c = 1, shorter than 1
    bool ship = false;        ///< a ship is there to be seen, and to be the other twin's
};

/// A flight to be flown: everything a scenario's TOML says, in the units of the file unless said otherwise.
struct Scenario {
    std::string name;                    ///< file stem or model name
    std::string title;                   ///< one line for `rapidity scenes`
    std::filesystem::path file;          ///< "" for a bare model
    std::filesystem::path model;         ///< glTF, absolute; "" when the scene has no meshes
    std::filesystem::path panorama;      ///< absolute; "" for the built-in gradient
    bool stars = false;                  ///< show the star catalogue
    double speed_of_light = 299792458.0; ///< scene metres per second of the ship's clock
    double clock_unit_seconds = 1.0;     ///< seconds of ship time in one clock unit (stars: a year)
    std::string clock_unit_name = "s";
    double pace = 1.0;                     ///< clock units of ship time per second of the pilot's time at the start
    glm::dvec3 start_position{0.0};        ///< scene metres, world
    glm::dvec3 start_look{0.0, 0.0, -1.0}; ///< direction the nose points, world, as at rest
    double start_beta = 0.0;               ///< in [0, 1), along start_heading
    glm::dvec3 start_heading{0.0, 0.0, -1.0};
    double horizontal_field_of_view = 1.5707963267948966; ///< radians
    sim::VehicleSettings vehicle;                         ///< c per clock unit, radians per clock unit
    ExposureSettings exposure;
    std::optional<Sun> sun; ///< overrides or adds to the model's
    glm::vec3 ambient{0.0f};
    GradientSky gradient_sky;
    float panorama_scale = 1.0f; ///< factor on the panorama's radiance
    double panorama_turn = 0.0;  ///< radians about +y
    float light_temperature = 5762.0f;
    ReflectanceModel reflectance_model = ReflectanceModel::five_terms;
    bool microwave_background = false; ///< black body of 2.725 K behind the sky
    std::vector<Beacon> beacons;
    std::string demonstration; ///< flight script (CSV) for a headless demonstration, absolute; "" for none

    /// Scene metres in one light clock unit: the factor from sim lengths to scene lengths.
    double metres_per_light_unit() const { return speed_of_light * clock_unit_seconds; }
};

/// A scenario named on a command line: the name of a built-in one, a .toml, or a bare .glb/.gltf.
/// Throws sim::BadInput with file, field and value; an unknown key is named with its nearest known one.
Scenario load_scenario(const std::string& name_or_file);

/// Loads everything the scenario's picture needs from disk. Throws sim::BadInput.
SceneDesc load_scene(const Scenario& scenario);

/// What a scenario can use and this machine has not, one line each with the way to get it.
std::vector<std::string> missing_content(const Scenario& scenario);

/// The built-in scenarios, in the order they are listed.
std::vector<Scenario> built_in_scenarios();

} // namespace content
