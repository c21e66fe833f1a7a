#pragma once

#include "content/nearest_name.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <utility>
#include <vector>

/// Fields of a TOML table, named once for reading and for documenting: a struct says its fields in a function
/// `fields(f, value)` that calls f(name, member, unit, meaning, range) for each; `FieldReader` fills them from a file,
/// `FieldLister` prints them.
namespace content {

/// What a number must be; for vectors each component.
struct FieldRange {
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();
    bool lowest_allowed = true;
    bool highest_allowed = true;

    bool holds(double value) const {
        return std::isfinite(value) && (lowest_allowed ? value >= lowest : value > lowest) &&
               (highest_allowed ? value <= highest : value < highest);
    }
    std::string text() const {
        std::string words = "x";
        if (std::isfinite(lowest)) {
            words = fmt::format("{} {} {}", lowest, lowest_allowed ? "<=" : "<", words);
        }
        if (std::isfinite(highest)) {
            words = fmt::format("{} {} {}", words, highest_allowed ? "<=" : "<", highest);
        }
        return words == "x" ? "finite" : words;
    }
};

inline constexpr FieldRange any_number{};
inline constexpr FieldRange positive_number{0.0, std::numeric_limits<double>::infinity(), false, true};
inline constexpr FieldRange not_negative_number{0.0, std::numeric_limits<double>::infinity(), true, true};

/// A number that the file has in degrees and the program in radians.
struct Degrees {
    double& radians;
};
/// A vector that must not be zero; kept as it stands.
struct NotZero {
    glm::dvec3& vector;
};
/// One of a list of names.
template <class Value>
struct OneOf {
    Value& value;
    std::vector<std::pair<std::string_view, Value>> names;
};

inline constexpr double radians_in_a_degree = 0.017453292519943295769;

class FieldReader {
  public:
    FieldReader(std::string source, std::string prefix, const toml::table& table)
        : source_(std::move(source)), prefix_(std::move(prefix)), table_(table) {}

    void operator()(std::string_view name, double& value, std::string_view, std::string_view,
                    const FieldRange& range = any_number) {
        if (const toml::node* node = find(name)) {
            value = number(name, *node, range);
        }
    }
    void operator()(std::string_view name, Degrees value, std::string_view, std::string_view,
                    const FieldRange& range = any_number) {
        if (const toml::node* node = find(name)) {
            value.radians = radians_in_a_degree * number(name, *node, range);
        }
    }
    void operator()(std::string_view name, bool& value, std::string_view, std::string_view) {
        if (const toml::node* node = find(name)) {
            if (!node->is_boolean()) {
                fail(name, *node, "must be true or false");
            }
            value = node->as_boolean()->get();
        }
    }
    void operator()(std::string_view name, std::string& value, std::string_view, std::string_view) {
        if (const toml::node* node = find(name)) {
            value = text(name, *node);
        }
    }
    void operator()(std::string_view name, glm::dvec3& value, std::string_view, std::string_view,
                    const FieldRange& range = any_number) {
        if (const toml::node* node = find(name)) {
            const toml::array* array = node->as_array();
            if (array == nullptr || array->size() != 3) {
                fail(name, *node, "must be three numbers in brackets");
            }
            value = {number(name, *array->get(0), range), number(name, *array->get(1), range),
                     number(name, *array->get(2), range)};
        }
    }
    void operator()(std::string_view name, NotZero value, std::string_view unit, std::string_view meaning) {
        (*this)(name, value.vector, unit, meaning);
        if (const toml::node* node = find(name); node != nullptr && !(glm::length(value.vector) > 0.0)) {
            fail(name, *node, "must not be zero");
        }
    }
    template <class Value>
    void operator()(std::string_view name, OneOf<Value> choice, std::string_view, std::string_view) {
        const toml::node* node = find(name);
        if (node == nullptr) {
            return;
        }
        const std::string word = text(name, *node);
        std::vector<std::string> known;
        for (const auto& [known_name, value] : choice.names) {
            if (known_name == word) {
                choice.value = value;
                return;
            }
            known.emplace_back(known_name);
        }
        fail(name, *node, fmt::format("not known; did you mean \"{}\"?", nearest_name(word, known)));
    }

    /// The node of a key that is read by hand; nullptr when absent.
    const toml::node* find(std::string_view name) {
        known_.emplace_back(name);
        return table_.get(name);
    }
    [[noreturn]] void fail(std::string_view name, const toml::node& node, const std::string& reason) const {
        std::ostringstream value;
        node.visit([&](const auto& held) { value << held; });
        throw sim::BadInput(source_, prefix_ + std::string(name), value.str(), reason);
    }
    double number(std::string_view name, const toml::node& node, const FieldRange& range) const {
        const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
        if (!value) {
            fail(name, node, "must be a number");
        }
        if (!range.holds(*value)) {
            fail(name, node,
                 range.text() == "finite" ? std::string("must be a finite number")
                                          : fmt::format("must be a finite number with {}", range.text()));
        }
        return *value;
    }
    std::string text(std::string_view name, const toml::node& node) const {
        if (!node.is_string() || node.as_string()->get().empty()) {
            fail(name, node, "must be a text in quotes");
        }
        return node.as_string()->get();
    }
    /// Every key must have been asked for: throws sim::BadInput naming the nearest that was.
    void finish() const {
        for (const auto& [key, node] : table_) {
            if (std::find(known_.begin(), known_.end(), key.str()) == known_.end()) {
                fail(key.str(), node,
                     fmt::format("this key is not known; did you mean {}?", nearest_name(key.str(), known_)));
            }
        }
    }

  private:
    std::string source_;
    std::string prefix_;
    const toml::table& table_;
    std::vector<std::string> known_;
};

class FieldLister {
  public:
    FieldLister(std::vector<std::string>& lines, std::string prefix) : lines_(lines), prefix_(std::move(prefix)) {}

    void operator()(std::string_view name, const double& value, std::string_view unit, std::string_view meaning,
                    const FieldRange& range = any_number) {
        add(name, unit, meaning, range.text(), fmt::format("{:.12g}", value));
    }
    void operator()(std::string_view name, Degrees value, std::string_view unit, std::string_view meaning,
                    const FieldRange& range = any_number) {
        add(name, unit, meaning, range.text(), fmt::format("{:.12g}", value.radians / radians_in_a_degree));
    }
    void operator()(std::string_view name, const bool& value, std::string_view unit, std::string_view meaning) {
        add(name, unit, meaning, "true or false", fmt::format("{}", value));
    }
    void operator()(std::string_view name, const std::string& value, std::string_view unit, std::string_view meaning) {
        add(name, unit, meaning, "", fmt::format("\"{}\"", value));
    }
    void operator()(std::string_view name, const glm::dvec3& value, std::string_view unit, std::string_view meaning,
                    const FieldRange& range = any_number) {
        add(name, unit, meaning, range.text(), fmt::format("[{}, {}, {}]", value.x, value.y, value.z));
    }
    void operator()(std::string_view name, NotZero value, std::string_view unit, std::string_view meaning) {
        add(name, unit, meaning, "not zero",
            fmt::format("[{}, {}, {}]", value.vector.x, value.vector.y, value.vector.z));
    }
    template <class Value>
    void operator()(std::string_view name, OneOf<Value> choice, std::string_view unit, std::string_view meaning) {
        std::string names;
        std::string_view chosen;
        for (const auto& [known_name, value] : choice.names) {
            names += (names.empty() ? "" : ", ") + std::string(known_name);
            chosen = value == choice.value ? known_name : chosen;
        }
        add(name, unit, meaning, names, fmt::format("\"{}\"", chosen));
    }

  private:
    void add(std::string_view name, std::string_view unit, std::string_view meaning, const std::string& range,
             const std::string& default_value) {
        lines_.push_back(fmt::format("{}{}: {}\n    {}{}default {}", prefix_, name, meaning,
                                     unit.empty() ? "" : fmt::format("unit {}; ", unit),
                                     range.empty() ? "" : fmt::format("{}; ", range), default_value));
    }

    std::vector<std::string>& lines_;
    std::string prefix_;
};

} // namespace content
