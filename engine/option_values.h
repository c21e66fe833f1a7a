#pragma once

#include "content/reflectance.h"

#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The values of command-line options, from text. Each throws sim::BadInput naming the option and the text.
namespace engine {

/// A finite number.
double number_option(const std::string& option, const std::string& text);

/// A finite number in [lowest, highest].
double number_option(const std::string& option, const std::string& text, double lowest, double highest);

/// A whole number in [lowest, highest].
int whole_number_option(const std::string& option, const std::string& text, int lowest, int highest);

/// `count` finite numbers between commas.
std::vector<double> numbers_option(const std::string& option, const std::string& text, std::size_t count);

/// A table of names and what they stand for, for options that choose.
template <class Value, std::size_t count>
using NamedValues = std::array<std::pair<std::string_view, Value>, count>;

/// Refuses a name that is not among `known`, and lists them.
[[noreturn]] void refuse_name(const std::string& option, const std::string& text,
                              const std::vector<std::string_view>& known);

/// The value that a name stands for.
template <class Value, std::size_t count>
Value named_option(const std::string& option, const std::string& text, const NamedValues<Value, count>& table) {
    std::vector<std::string_view> known;
    for (const auto& [name, value] : table) {
        if (name == text) {
            return value;
        }
        known.push_back(name);
    }
    refuse_name(option, text, known);
}

/// The name of a value that is in the table.
template <class Value, std::size_t count>
std::string name_of(Value wanted, const NamedValues<Value, count>& table) {
    for (const auto& [name, value] : table) {
        if (value == wanted) {
            return std::string(name);
        }
    }
    return {};
}

/// A direction "x,y,z", made unit; zero is refused.
glm::dvec3 direction_option(const std::string& option, const std::string& text);

struct PictureSize {
    int width = 1280;
    int height = 720;
};

/// "1280x720"; each side from 1 to 16384 pixels.
PictureSize size_option(const std::string& option, const std::string& text);

/// Models of RGB reflectances, as content names them.
inline constexpr NamedValues<content::ReflectanceModel, 3> reflectance_names{
    {{content::reflectance_model_names[0], content::ReflectanceModel::five_terms},
     {content::reflectance_model_names[1], content::ReflectanceModel::three_primaries},
     {content::reflectance_model_names[2], content::ReflectanceModel::dominant_wavelength}}};

} // namespace engine
