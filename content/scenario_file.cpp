#include "content/scenario_file.h"

#include "content/data_folders.h"
#include "content/generator/generate.h"
#include "content/model_name.h"
#include "content/nearest_name.h"
#include "content/panorama.h"
#include "content/scenario_keys.h"
#include "content/toml_file.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <sstream>
#include <string_view>
#include <toml++/toml.h>
#include <type_traits>

namespace content {
namespace {

constexpr KeyRange unbounded{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), false,
                             false};
constexpr double radians_per_degree = 0.017453292519943295769;

/// Puts the values of one parsed file into a Scenario.
class ScenarioReader {
  public:
    explicit ScenarioReader(const std::filesystem::path& file) : source_(file.string()), folder_(file.parent_path()) {}

    ScenarioFile read(const toml::table& root) {
        read_table(root, "");
        return std::move(result_);
    }

  private:
    void read_table(const toml::table& table, const std::string& prefix) {
        for (const auto& [toml_key, node] : table) {
            const std::string name = prefix + std::string(toml_key.str());
            const auto& keys = scenario_keys();
            const auto known =
                std::find_if(keys.begin(), keys.end(), [&](const ScenarioKey& key) { return key.name == name; });
            if (name == "beacon") {
                read_beacons(node);
            } else if (known != keys.end()) {
                read_key(*known, node);
            } else if (node.is_table() && std::any_of(keys.begin(), keys.end(), [&](const ScenarioKey& key) {
                           return key.name.starts_with(name + ".");
                       })) {
                read_table(*node.as_table(), name + ".");
            } else {
                fail_unknown(name, node);
            }
        }
    }

    [[noreturn]] void fail_unknown(const std::string& name, const toml::node& node) const {
        // A key in the wrong table is more likely than one with letters wrong.
        const std::string last = fmt::format(".{}", name.substr(name.rfind('.') + 1));
        std::vector<std::string> names;
        for (const ScenarioKey& key : scenario_keys()) {
            if (key.name.ends_with(last)) {
                names = {std::string(key.name)};
                break;
            }
            names.emplace_back(key.name);
        }
        throw sim::BadInput(source_, name, text_of(node),
                            fmt::format("this key is not known; did you mean {}?", nearest_name(name, names)));
    }

    [[noreturn]] void fail(const ScenarioKey& key, const toml::node& node, const std::string& reason) const {
        throw sim::BadInput(source_, std::string(key.name), text_of(node), reason);
    }

    void read_beacons(const toml::node& node) {
        const toml::array* entries = node.as_array();
        if (entries == nullptr || !entries->is_homogeneous<toml::table>()) {
            throw sim::BadInput(source_, "beacon", text_of(node), "must be tables, each headed [[beacon]]");
        }
        for (const toml::node& entry : *entries) {
            read_beacon(*entry.as_table());
        }
    }

    void read_beacon(const toml::table& table) {
        const ScenarioKey place{"beacon.position", "m", "", {}, KeyKind::plain, unbounded};
        const ScenarioKey motion{"beacon.velocity", "c", "", {}, KeyKind::plain, unbounded};
        Beacon beacon;
        bool placed = false;
        for (const auto& [key, node] : table) {
            if (key == "name") {
                beacon.name = text({"beacon.name", "", "", {}}, node);
            } else if (key == "position") {
                beacon.position = vector(place, node);
                placed = true;
            } else if (key == "velocity") {
                beacon.velocity = vector(motion, node);
                if (!(glm::length(beacon.velocity) < 1.0)) {
                    fail(motion, node, "must be slower than light: shorter than 1");
                }
            } else if (key == "ship") {
                const std::optional<bool> ship = node.value_exact<bool>();
                if (!ship) {
                    throw sim::BadInput(source_, "beacon.ship", text_of(node), "must be true or false");
                }
                beacon.ship = *ship;
            } else {
                throw sim::BadInput(source_, "beacon." + std::string(key.str()), text_of(node),
                                    "this key is not known; a beacon has name, position, velocity and ship");
            }
        }
        if (beacon.name.empty() || !placed) {
            throw sim::BadInput(source_, "beacon", beacon.name, "needs a name and a position");
        }
        result_.scenario.beacons.push_back(std::move(beacon));
    }

    static std::string text_of(const toml::node& node) {
        std::ostringstream text;
        node.visit([&](const auto& value) { text << value; });
        return text.str();
    }

    void read_key(const ScenarioKey& key, const toml::node& node) {
        std::visit([&](auto field) { read_value(key, node, field(result_.scenario)); }, key.field);
        if (key.name == "start.position") {
            result_.has_start_position = true;
        }
    }

    void read_value(const ScenarioKey& key, const toml::node& node, bool& value) const {
        if (!node.is_boolean()) {
            fail(key, node, "must be true or false");
        }
        value = node.as_boolean()->get();
    }

    std::string text(const ScenarioKey& key, const toml::node& node) const {
        if (!node.is_string()) {
            fail(key, node, "must be a text in quotes");
        }
        if (node.as_string()->get().empty()) {
            fail(key, node, "must not be empty");
        }
        return node.as_string()->get();
    }

    void read_value(const ScenarioKey& key, const toml::node& node, std::string& value) const {
        value = text(key, node);
        if (key.kind == KeyKind::other_file) {
            value = existing_file(key, node, value).string();
        }
    }

    void read_value(const ScenarioKey& key, const toml::node& node, ReflectanceModel& value) const {
        const std::string name = text(key, node);
        const auto& names = reflectance_model_names;
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            fail(key, node, fmt::format("must be one of {}", fmt::join(names, ", ")));
        }
        value = static_cast<ReflectanceModel>(found - names.begin());
    }

    void read_value(const ScenarioKey& key, const toml::node& node, std::filesystem::path& value) const {
        const std::string name = text(key, node);
        if (key.kind == KeyKind::panorama_file && is_studiolight(name)) {
            value = studiolight_file(name);
        } else if (key.kind == KeyKind::model_file && is_generated_model(name)) {
            check_generated_model(key, node, name);
            value = name;
        } else {
            value = existing_file(key, node, name);
        }
    }

    void check_generated_model(const ScenarioKey& key, const toml::node& node, const std::string& name) const {
        const std::vector<std::string> names = generator::model_names();
        const std::string model = name.substr(generated_prefix.size());
        if (std::find(names.begin(), names.end(), model) == names.end()) {
            fail(key, node,
                 fmt::format("no model of that name is generated; did you mean {}{}?", generated_prefix,
                             nearest_name(model, names)));
        }
    }

    std::filesystem::path existing_file(const ScenarioKey& key, const toml::node& node, const std::string& name) const {
        std::filesystem::path file = std::filesystem::absolute(folder_ / name).lexically_normal();
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error)) {
            fail(key, node, fmt::format("there is no file {}", file.string()));
        }
        return file;
    }

    double number(const ScenarioKey& key, const toml::node& node) const {
        const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
        if (!value) {
            fail(key, node, "must be a number");
        }
        const KeyRange& range = key.range;
        const bool above = range.lowest_allowed ? *value >= range.lowest : *value > range.lowest;
        const bool below = range.highest_allowed ? *value <= range.highest : *value < range.highest;
        if (!std::isfinite(*value) || !above || !below) {
            fail(key, node, fmt::format("must be a finite number with {}", range_text(key)));
        }
        return key.kind == KeyKind::degrees ? *value * radians_per_degree : *value;
    }

    void read_value(const ScenarioKey& key, const toml::node& node, double& value) const { value = number(key, node); }

    void read_value(const ScenarioKey& key, const toml::node& node, float& value) const {
        value = single(key, node, number(key, node));
    }

    float single(const ScenarioKey& key, const toml::node& node, double value) const {
        const auto rounded = static_cast<float>(value);
        if (!std::isfinite(rounded)) {
            fail(key, node, "beyond the range of single precision");
        }
        return rounded;
    }

    void read_value(const ScenarioKey& key, const toml::node& node, glm::dvec3& value) const {
        value = vector(key, node);
    }

    void read_value(const ScenarioKey& key, const toml::node& node, glm::vec3& value) const {
        const glm::dvec3 wide = vector(key, node);
        value = {single(key, node, wide.x), single(key, node, wide.y), single(key, node, wide.z)};
    }

    glm::dvec3 vector(const ScenarioKey& key, const toml::node& node) const {
        if (key.kind == KeyKind::per_axis && node.is_number()) {
            return glm::dvec3(number(key, node));
        }
        const toml::array* array = node.as_array();
        if (array == nullptr || array->size() != 3) {
            fail(key, node, "must be three numbers in brackets");
        }
        const glm::dvec3 components(number(key, *array->get(0)), number(key, *array->get(1)),
                                    number(key, *array->get(2)));
        if (key.kind != KeyKind::direction) {
            return components;
        }
        const double length = glm::length(components);
        if (!(length > 0.0) || !std::isfinite(length)) {
            fail(key, node, "must not be zero");
        }
        return components / length;
    }

    std::string source_;
    std::filesystem::path folder_;
    ScenarioFile result_;
};

} // namespace

ScenarioFile read_scenario_file(const std::filesystem::path& file) {
    ScenarioFile result = ScenarioReader(file).read(read_toml(file));
    result.scenario.name = file.stem().string();
    result.scenario.file = std::filesystem::absolute(file).lexically_normal();
    return result;
}

} // namespace content
