#include "content/scenario_keys.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace content {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double degrees_per_radian = 57.295779513082320877;

constexpr KeyRange positive{0.0, infinity, false, false};
constexpr KeyRange not_negative{0.0, infinity, true, false};
constexpr KeyRange any{-infinity, infinity, false, false};

Sun& sun(Scenario& scenario) {
    if (!scenario.sun) {
        scenario.sun.emplace();
    }
    return *scenario.sun;
}

} // namespace

const std::vector<ScenarioKey>& scenario_keys() {
    static const std::vector<ScenarioKey> keys = {
        {"title", "", "one line about the scene", +[](Scenario& s) -> std::string& { return s.title; }},
        {"model", "", "the scenery: a .glb or .gltf, or generated:NAME",
         +[](Scenario& s) -> std::filesystem::path& { return s.model; }, KeyKind::model_file},
        {"panorama", "", "equirectangular sky: a .exr, .hdr, .png or .jpg, or studiolight:NAME.exr of blender-data",
         +[](Scenario& s) -> std::filesystem::path& { return s.panorama; }, KeyKind::panorama_file},
        {"panorama_scale", "", "factor on the panorama's radiance",
         +[](Scenario& s) -> float& { return s.panorama_scale; }, KeyKind::plain, positive},
        {"panorama_turn",
         "degrees",
         "turns the panorama about +y",
         +[](Scenario& s) -> double& { return s.panorama_turn; },
         KeyKind::degrees,
         {-360.0, 360.0}},
        {"stars", "", "shows the star catalogue", +[](Scenario& s) -> bool& { return s.stars; }},
        {"ambient", "radiance",
         "light from all of the sky: radiance of a white surface facing up under it alone; 0.65 of it aside",
         +[](Scenario& s) -> glm::vec3& { return s.ambient; }, KeyKind::plain, not_negative},
        {"light_temperature",
         "K",
         "black body that lights the scene, for the colours under Doppler shift",
         +[](Scenario& s) -> float& { return s.light_temperature; },
         KeyKind::plain,
         {1000.0, 100000.0}},
        {"reflectance", "", "spectra of RGB reflectances: five-terms, three-primaries or dominant-wavelength",
         +[](Scenario& s) -> ReflectanceModel& { return s.reflectance_model; }},
        {"microwave_background", "", "shows the cosmic microwave background, 2.725 K, behind the sky",
         +[](Scenario& s) -> bool& { return s.microwave_background; }},
        {"speed_of_light",
         "m/s",
         "scene metres that light travels in one second of the ship's clock",
         +[](Scenario& s) -> double& { return s.speed_of_light; },
         KeyKind::plain,
         {1e-3, 1e12}},
        {"clock_unit_seconds",
         "s",
         "length of one clock unit; the vehicle's limits are per clock unit",
         +[](Scenario& s) -> double& { return s.clock_unit_seconds; },
         KeyKind::plain,
         {1e-9, 1e12}},
        {"clock_unit_name", "", "how the clocks name it",
         +[](Scenario& s) -> std::string& { return s.clock_unit_name; }},
        {"pace",
         "1/s",
         "clock units of ship time that pass in one second of the pilot's",
         +[](Scenario& s) -> double& { return s.pace; },
         KeyKind::plain,
         {1e-9, 1e6}},
        {"demonstration", "", "flight script (CSV) of the demonstration",
         +[](Scenario& s) -> std::string& { return s.demonstration; }, KeyKind::other_file},
        {"start.position", "m", "where the ship starts, world",
         +[](Scenario& s) -> glm::dvec3& { return s.start_position; }, KeyKind::plain, any},
        {"start.look", "", "where the nose points, world, as at rest",
         +[](Scenario& s) -> glm::dvec3& { return s.start_look; }, KeyKind::direction, any},
        {"start.beta",
         "c",
         "speed at the start",
         +[](Scenario& s) -> double& { return s.start_beta; },
         KeyKind::plain,
         {0.0, 1.0, true, false}},
        {"start.heading", "", "direction of that speed, world",
         +[](Scenario& s) -> glm::dvec3& { return s.start_heading; }, KeyKind::direction, any},
        {"start.field_of_view",
         "degrees",
         "width of the picture",
         +[](Scenario& s) -> double& { return s.horizontal_field_of_view; },
         KeyKind::degrees,
         {1.0, 170.0}},
        {"vehicle.maximum_acceleration", "c / clock unit", "largest thrust along x, y, z of the ship",
         +[](Scenario& s) -> glm::dvec3& { return s.vehicle.maximum_acceleration; }, KeyKind::per_axis, positive},
        {"vehicle.maximum_turn_rate", "rad / clock unit", "largest turn rate about x, y, z of the ship",
         +[](Scenario& s) -> glm::dvec3& { return s.vehicle.maximum_turn_rate; }, KeyKind::per_axis, positive},
        {"vehicle.maximum_turn_acceleration", "rad / clock unit^2", "largest change of the turn rate about x, y, z",
         +[](Scenario& s) -> glm::dvec3& { return s.vehicle.maximum_turn_acceleration; }, KeyKind::per_axis, positive},
        {"vehicle.propellant", "mass of the ship without it",
         "propellant at the start; without this key it lasts for ever",
         +[](Scenario& s) -> double& { return s.vehicle.propellant; }, KeyKind::plain, not_negative},
        {"vehicle.exhaust_speed",
         "c",
         "speed at which the propellant leaves the ship; 1 is a photon rocket",
         +[](Scenario& s) -> double& { return s.vehicle.exhaust_speed; },
         KeyKind::plain,
         {0.0, 1.0, false, true}},
        {"vehicle.boost_factor",
         "",
         "factor on the thrust while boost is held",
         +[](Scenario& s) -> double& { return s.vehicle.boost_factor; },
         KeyKind::plain,
         {1.0, 1000.0}},
        {"vehicle.tick_rate",
         "1 / clock unit",
         "fixed steps of the physics",
         +[](Scenario& s) -> double& { return s.vehicle.tick_rate; },
         KeyKind::plain,
         {1.0, 1e6}},
        {"exposure.automatic", "", "the eye adapts to the picture",
         +[](Scenario& s) -> bool& { return s.exposure.automatic; }},
        {"exposure.stops",
         "log2",
         "manual exposure, or compensation of the automatic one",
         +[](Scenario& s) -> double& { return s.exposure.stops; },
         KeyKind::plain,
         {-40.0, 40.0}},
        {"sun.direction", "", "towards the sun, world; a sun here replaces the model's",
         +[](Scenario& s) -> glm::vec3& { return sun(s).direction; }, KeyKind::direction, any},
        {"sun.irradiance", "radiance x sr", "light of the sun: pi gives a white surface facing it radiance 1",
         +[](Scenario& s) -> glm::vec3& { return sun(s).irradiance; }, KeyKind::plain, not_negative},
        {"sky.zenith", "radiance", "sky without a panorama: straight up",
         +[](Scenario& s) -> glm::vec3& { return s.gradient_sky.zenith; }, KeyKind::plain, not_negative},
        {"sky.horizon", "radiance", "sky without a panorama: at the horizon",
         +[](Scenario& s) -> glm::vec3& { return s.gradient_sky.horizon; }, KeyKind::plain, not_negative},
        {"sky.nadir", "radiance", "sky without a panorama: straight down",
         +[](Scenario& s) -> glm::vec3& { return s.gradient_sky.nadir; }, KeyKind::plain, not_negative},
    };
    return keys;
}

namespace {

bool has_range(const ScenarioKey& key) {
    const bool number = std::holds_alternative<double& (*)(Scenario&)>(key.field) ||
                        std::holds_alternative<float& (*)(Scenario&)>(key.field) ||
                        std::holds_alternative<glm::dvec3& (*)(Scenario&)>(key.field) ||
                        std::holds_alternative<glm::vec3& (*)(Scenario&)>(key.field);
    return number && key.kind != KeyKind::direction;
}

std::string text_of(bool value) {
    return value ? "true" : "false";
}
std::string text_of(double value) {
    return fmt::format("{}", value);
}
std::string text_of(float value) {
    return fmt::format("{}", value);
}
std::string text_of(const std::string& value) {
    return fmt::format("\"{}\"", value);
}
std::string text_of(ReflectanceModel value) {
    return text_of(std::string(reflectance_model_names.at(static_cast<std::size_t>(value))));
}
std::string text_of(const std::filesystem::path& value) {
    return text_of(value.string());
}
template <class Vector>
std::string text_of(const Vector& value) {
    return fmt::format("[{}, {}, {}]", value.x, value.y, value.z);
}

} // namespace

std::string range_text(const ScenarioKey& key) {
    if (key.kind == KeyKind::direction) {
        return "not zero";
    }
    if (!has_range(key)) {
        return "";
    }
    const KeyRange& range = key.range;
    std::string text = "x";
    if (std::isfinite(range.lowest)) {
        text = fmt::format("{} {} {}", range.lowest, range.lowest_allowed ? "<=" : "<", text);
    }
    if (std::isfinite(range.highest)) {
        text = fmt::format("{} {} {}", text, range.highest_allowed ? "<=" : "<", range.highest);
    }
    return text == "x" ? "finite" : text;
}

std::string value_text(const ScenarioKey& key, Scenario scenario) {
    return std::visit(
        [&](auto field) -> std::string {
            auto& value = field(scenario);
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
                if (key.kind == KeyKind::degrees) {
                    // Rounded, since a default such as pi/2 has no exact form in degrees.
                    return fmt::format("{:.12g}", value * degrees_per_radian);
                }
            }
            return text_of(value);
        },
        key.field);
}

} // namespace content
