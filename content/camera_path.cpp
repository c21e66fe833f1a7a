#include "content/camera_path.h"

#include "content/file_bytes.h"
#include "content/toml_file.h"
#include "content/traced/toml_fields.h"

#include <glm/geometric.hpp>

namespace content {
namespace {

constexpr FieldRange field_of_view_range{0.0, 180.0, false, false};
constexpr FieldRange roll_range{-360.0, 360.0, true, true};

/// A keyframe's keys that a file may leave out, as it has them.
struct Given {
    glm::dvec3 velocity{0.0};
    glm::dvec3 look{0.0, 0.0, -1.0};
    glm::dvec3 look_at{0.0};
};

template <class Fields>
void path_fields(Fields& f, CameraPath& path) {
    std::string_view at_rest = "rest";
    f("ends", OneOf<bool>{path.ends_rest, {{at_rest, true}, {"free", false}}}, "",
      "the path, and what else moves, begins and ends at rest, or as if it came from afar and went on uniformly");
}

template <class Fields>
void keyframe_fields(Fields& f, CameraKeyframe& keyframe, Given& given) {
    f("time", keyframe.time, "clock units", "when, by the world's clock; later than the keyframe before");
    f("position", keyframe.position, "m", "where the eye is in the world");
    f("velocity", given.velocity, "c",
      "of the observer there, shorter than 1; in all keyframes or in none: then it is the velocity of the path");
    f("look", NotZero{given.look}, "",
      "direction of the view in the world's axes carried over by the eye's boost; default the scenario's");
    f("look_at", given.look_at, "m", "instead of look: a place of the scene; the eye turns to where it is seen");
    f("roll", Degrees{keyframe.roll}, "degrees", "of the picture's top to the right", roll_range);
    f("field_of_view", Degrees{keyframe.horizontal_field_of_view}, "degrees",
      "from the left edge to the right; default the scenario's", field_of_view_range);
    f("mode", keyframe.mode, "", "geometry, doppler, searchlight or full from here on; default that of the film");
}

void require(const std::string& source, const toml::table& table, const std::string& prefix, const char* key) {
    if (!table.contains(key)) {
        throw sim::BadInput(source, prefix + key, "", "missing");
    }
}

CameraKeyframe read_keyframe(const std::string& source, std::size_t index, const toml::table& table,
                             const Scenario& scenario) {
    const std::string prefix = CameraPath::name_of(index) + ".";
    CameraKeyframe keyframe;
    keyframe.horizontal_field_of_view = scenario.horizontal_field_of_view;
    Given given;
    FieldReader reader(source, prefix, table);
    keyframe_fields(reader, keyframe, given);
    reader.finish();
    require(source, table, prefix, "time");
    require(source, table, prefix, "position");
    if (const toml::node* node = table.get("velocity")) {
        if (glm::length(given.velocity) >= 1.0) {
            reader.fail("velocity", *node, "must be slower than light, 1");
        }
        keyframe.velocity = given.velocity;
    }
    if (table.contains("look")) {
        keyframe.look = glm::normalize(given.look);
    }
    if (const toml::node* node = table.get("look_at")) {
        if (keyframe.look) {
            reader.fail("look_at", *node, "give either look or look_at, not both");
        }
        keyframe.look_at = given.look_at;
    }
    return keyframe;
}

/// What is interpolated must be there at both ends of every stretch.
template <class Field>
void all_or_none(const CameraPath& path, const char* key, Field field) {
    for (std::size_t i = 1; i < path.keyframes.size(); ++i) {
        if ((path.keyframes[i].*field).has_value() != (path.keyframes[0].*field).has_value()) {
            throw sim::BadInput(path.file.string(), CameraPath::name_of(i, key), "",
                                fmt::format("all keyframes have {}, or none has", key));
        }
    }
}

/// Directions are interpolated along straight lines between them, which must keep away from zero.
void check_turns(const CameraPath& path) {
    constexpr double least_cosine = -0.5;
    for (std::size_t i = 1; i < path.keyframes.size() && path.keyframes[0].look; ++i) {
        if (glm::dot(*path.keyframes[i - 1].look, *path.keyframes[i].look) < least_cosine) {
            throw sim::BadInput(path.file.string(), CameraPath::name_of(i, "look"), "",
                                "turns by more than 120 degrees from the keyframe before; put one between them");
        }
    }
}

} // namespace

std::string CameraPath::name_of(std::size_t keyframe, const std::string& key) {
    return fmt::format("keyframe {}{}{}", keyframe + 1, key.empty() ? "" : ".", key);
}

CameraPath read_camera_path(const std::filesystem::path& file, const Scenario& scenario) {
    CameraPath path;
    path.file = file;
    const std::string source = file.string();
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    path.text.assign(bytes.begin(), bytes.end());
    const toml::table root = read_toml(file);
    FieldReader reader(source, "", root);
    path_fields(reader, path);
    const toml::node* keyframes = reader.find("keyframe");
    reader.finish();
    const toml::array* array = keyframes != nullptr ? keyframes->as_array() : nullptr;
    if (array == nullptr || array->size() < 2 || !array->is_homogeneous(toml::node_type::table)) {
        throw sim::BadInput(source, "keyframe", "", "a path is two or more tables [[keyframe]]");
    }
    for (std::size_t i = 0; i < array->size(); ++i) {
        path.keyframes.push_back(read_keyframe(source, i, *array->get(i)->as_table(), scenario));
        if (i > 0 && !(path.keyframes[i].time > path.keyframes[i - 1].time)) {
            throw sim::BadInput(source, CameraPath::name_of(i, "time"), fmt::format("{}", path.keyframes[i].time),
                                "must be later than the keyframe before");
        }
    }
    all_or_none(path, "velocity", &CameraKeyframe::velocity);
    all_or_none(path, "look", &CameraKeyframe::look);
    all_or_none(path, "look_at", &CameraKeyframe::look_at);
    if (!path.keyframes[0].look && !path.keyframes[0].look_at) {
        for (CameraKeyframe& keyframe : path.keyframes) {
            keyframe.look = scenario.start_look;
        }
    }
    check_turns(path);
    return path;
}

std::vector<std::string> camera_path_keys() {
    std::vector<std::string> lines;
    CameraPath path;
    CameraKeyframe keyframe;
    Given given;
    FieldLister file(lines, "");
    path_fields(file, path);
    FieldLister each(lines, "keyframe.");
    keyframe_fields(each, keyframe, given);
    return lines;
}

} // namespace content
