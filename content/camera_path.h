#pragma once

#include "content/scenario.h"

#include <glm/vec3.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace content {

/// An eye at one moment of a film that nobody flew.
struct CameraKeyframe {
    double time = 0.0;        ///< of the world's clock, clock units
    glm::dvec3 position{0.0}; ///< scene metres, world
    /// Of the observer, c. None: that of the path itself.
    std::optional<glm::dvec3> velocity;
    /// Where the eye looks, in the world's axes carried over by the eye's boost; not zero.
    std::optional<glm::dvec3> look;
    /// A place of the scene that the eye looks at, where its light is seen to come from; scene metres, world.
    std::optional<glm::dvec3> look_at;
    double roll = 0.0;                                    ///< about the look, to the right, radians
    double horizontal_field_of_view = 1.5707963267948966; ///< radians, in (0, pi)
    std::string mode;                                     ///< from here on; "": as before
};

/// Where a film's eye is, how it moves and looks, at some moments by rising time.
struct CameraPath {
    std::filesystem::path file;
    std::string text;                      ///< the file's
    bool ends_rest = true;                 ///< it begins and ends at rest; else as if it came from afar and went on
    std::vector<CameraKeyframe> keyframes; ///< two or more; velocity, look and look_at in all of them or in none

    /// "keyframe 2" or, with a key, "keyframe 2.look": how messages name it; counted from 1.
    static std::string name_of(std::size_t keyframe, const std::string& key = "");
};

/// Reads a path's TOML; what it does not say of look and field of view is the scenario's. Throws sim::BadInput with
/// file, keyframe, key and value.
CameraPath read_camera_path(const std::filesystem::path& file, const Scenario& scenario);

/// The keys of the file with unit, range and default, a line or two for each.
std::vector<std::string> camera_path_keys();

} // namespace content
