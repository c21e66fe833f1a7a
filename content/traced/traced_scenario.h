#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// A picture of a curved spacetime as `rapidity trace` makes it: what a TOML file says, as plain data.
///
/// Lengths and times are in the spacetime's own unit, G = c = 1 (black holes: any unit; a mass of 1 makes it GM/c^2).
/// Positions are in the Cartesian-like axes of the spacetime's chart; +z, the axis of spin, is up.
namespace content {

/// Which spacetime, by the names that `rapidity spacetimes` lists.
struct TracedSpacetime {
    std::string name = "minkowski";           ///< or a .toml with metric components, relative to the scenario's folder
    std::map<std::string, double> parameters; ///< every other key of the table; unset ones take the spacetime's default
};

enum class Projection : std::uint8_t {
    perspective,     ///< a plane screen
    fisheye,         ///< angle from the axis proportional to the distance from the picture's middle (equidistant)
    equirectangular, ///< all of the sky, laid out as panoramas are
};

/// How the camera moves at its event.
enum class ObserverKind : std::uint8_t { at_rest, zero_angular_momentum, circular, free_falling };

/// The camera at one event. A path is a list of these, joined smoothly.
struct CameraMoment {
    double at = 0.0;                     ///< moment of the sequence, its own unit
    double time = 0.0;                   ///< coordinate time
    glm::dvec3 position{20.0, 0.0, 0.0}; ///< chart
    glm::dvec3 look{0.0};                ///< direction of the view, chart axes; zero: towards the chart's origin
};

struct TracedCamera {
    Projection projection = Projection::perspective;
    double field_of_view = 1.0471975511965976; ///< radians across the picture's width
    ObserverKind observer = ObserverKind::at_rest;
    glm::dvec3 velocity{0.0};     ///< relative to that observer, along the camera's own chart axes, c = 1
    glm::dvec3 up{0.0, 0.0, 1.0}; ///< chart axes
    CameraMoment moment;
    std::vector<CameraMoment> path; ///< of a sequence, in the order of `at`; empty: `moment` alone
};

/// What is seen of light from infinity.
struct TracedSky {
    std::filesystem::path panorama; ///< absolute; "": none
    double panorama_scale = 1.0;    ///< factor on its radiance
    double panorama_turn = 0.0;     ///< radians about the up axis
    double checkerboard = 0.0;      ///< radians: side of the squares of directions; 0: none
    bool stars = false;             ///< the star catalogue, as points
    double star_scale = 1.0;        ///< factor on the stars' light
    glm::dvec3 colour{0.0};         ///< radiance of what is left
};

/// A thin disk of matter on circular orbits in the plane z = 0, optically thick, that radiates as black bodies.
struct TracedDisk {
    double inner_radius = 0.0; ///< 0: the innermost stable circular orbit
    double outer_radius = 20.0;
    double peak_temperature = 10000.0; ///< kelvin, of the hottest ring
    double brightness = 1.0;           ///< factor on the radiance
    bool retrograde = false;           ///< against the spin
    double texture = 0.0;              ///< depth of the streaks in brightness, 0 to 1
};

/// A ball at rest in the chart, or on a world line.
struct TracedSphere {
    std::string name;
    glm::dvec3 centre{0.0};
    double radius = 1.0;            ///< coordinate radius
    glm::dvec3 velocity{0.0};       ///< coordinate velocity, c = 1; `centre` is its place at t = 0
    glm::dvec3 reflectance{0.7};    ///< linear sRGB
    glm::dvec3 emission{0.0};       ///< linear radiance
    double temperature = 0.0;       ///< kelvin: radiates as a black body; 0: does not
    double checkerboard = 0.0;      ///< radians: squares of latitude and longitude; 0: none
    std::string texture;            ///< "": none, "generated:planet", or an equirectangular picture's absolute path
    glm::dvec3 axis{0.0, 0.0, 1.0}; ///< of the texture, chart axes
    double turn = 0.0;              ///< radians of the texture about its axis
};

/// A place that a ship passes at a coordinate time.
struct WorldLinePoint {
    double time = 0.0;
    glm::dvec3 position{0.0};
};

/// A glTF model, at rest in the chart or on a world line of straight pieces.
struct TracedModel {
    std::string name;
    std::filesystem::path file;       ///< .glb or .gltf, or generated:NAME
    double scale = 1.0;               ///< chart lengths per metre of the model
    glm::dvec3 position{0.0};         ///< of the model's origin, where there is no world line
    glm::dvec3 look{1.0, 0.0, 0.0};   ///< where the model's -z points, chart axes
    glm::dvec3 up{0.0, 0.0, 1.0};     ///< where its +y points, as near as can be
    std::vector<WorldLinePoint> path; ///< straight between, at rest before the first and after the last
};

/// The distant light that falls on spheres and models, parallel in the chart: gravity bends what is seen, not what
/// lights it.
struct TracedLight {
    glm::dvec3 direction{1.0, 0.0, 0.5};      ///< towards the light
    glm::dvec3 irradiance{3.141592653589793}; ///< pi gives a white surface square to it radiance 1
    glm::dvec3 ambient{0.02};                 ///< radiance of a white surface under all of the rest
    double temperature = 5762.0;              ///< kelvin: the black body whose light it is, for Doppler shifts
};

struct TracedScenario {
    std::string name;           ///< file stem
    std::string title;          ///< one line
    std::filesystem::path file; ///< absolute
    TracedSpacetime spacetime;
    TracedCamera camera;
    TracedSky sky;
    std::optional<TracedSky> other_sky; ///< beyond a wormhole; unset: the same as `sky`
    std::optional<TracedDisk> disk;
    std::vector<TracedSphere> spheres;
    std::vector<TracedModel> models;
    TracedLight light;
    double exposure_stops = 0.0;
    bool automatic_exposure = true;
};

/// A scenario for `rapidity trace` by name (built in) or file. Throws sim::BadInput with file, key and value.
TracedScenario load_traced_scenario(const std::string& name_or_file);

/// The built-in ones, by name.
std::vector<TracedScenario> built_in_traced_scenarios();

/// Every key of such a file with its unit, meaning, range and default, one entry each, as `rapidity trace --keys`
/// prints them.
std::vector<std::string> traced_scenario_keys();

/// The camera on its path: `moment` between the path's ends, by Catmull-Rom splines through its points (C^1; exact in
/// them); beyond the ends the end's. Without a path the camera's own moment.
CameraMoment camera_at(const TracedCamera& camera, double moment);

} // namespace content
