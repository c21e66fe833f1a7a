#pragma once

#include "content/scenario.h"

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace content {

/// What a key's value must be.
struct KeyRange {
    double lowest = 0.0;
    double highest = 0.0;
    bool lowest_allowed = true;
    bool highest_allowed = true;
};

/// How a key's value becomes the field's.
enum class KeyKind : std::uint8_t {
    plain,         ///< as it stands; vectors component by component
    degrees,       ///< degrees in the file, radians in the field
    direction,     ///< a vector that is not zero, brought to length 1
    per_axis,      ///< three numbers, or one for all three axes
    model_file,    ///< a glTF file, relative to the scenario's folder, or generated:NAME
    other_file,    ///< a file, relative to the scenario's folder, that must be there
    panorama_file, ///< a picture, relative to the scenario's folder, or studiolight:NAME.exr
};

/// One key of a scenario's TOML, dotted for keys in tables. One table of these reads, checks and documents scenarios.
struct ScenarioKey {
    using Field = std::variant<bool& (*)(Scenario&), double& (*)(Scenario&), float& (*)(Scenario&),
                               std::string& (*)(Scenario&), std::filesystem::path& (*)(Scenario&),
                               glm::dvec3& (*)(Scenario&), glm::vec3& (*)(Scenario&), ReflectanceModel& (*)(Scenario&)>;

    std::string_view name;
    std::string_view unit; ///< "" for none
    std::string_view meaning;
    Field field;
    KeyKind kind = KeyKind::plain;
    KeyRange range{}; ///< for numbers
};

const std::vector<ScenarioKey>& scenario_keys();

/// A key of a [[beacon]], of which a scenario may have any number; all but velocity must be there.
struct BeaconKey {
    std::string_view name;
    std::string_view unit;
    std::string_view meaning;
};
inline constexpr std::array beacon_keys{
    BeaconKey{"beacon.name", "", "a clock that moves uniformly, and a place to fly to: what it is called"},
    BeaconKey{"beacon.position", "m", "where it is at world time 0"},
    BeaconKey{"beacon.velocity", "c", "its velocity in the world, shorter than 1; default [0, 0, 0]"},
    BeaconKey{"beacon.ship", "", "true: a ship is to be seen there, in which the camera \"twin\" flies; default false"},
};

/// The range in words, such as "0 <= x < 1"; "" for keys that have none.
std::string range_text(const ScenarioKey& key);

/// The value in a scenario as it would stand in the file: for the default, that of Scenario{}.
std::string value_text(const ScenarioKey& key, Scenario scenario);

} // namespace content
