#pragma once

#include <glm/vec3.hpp>

#include <string>
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

/// A direction "x,y,z", made unit; zero is refused.
glm::dvec3 direction_option(const std::string& option, const std::string& text);

struct PictureSize {
    int width = 1280;
    int height = 720;
};

/// "1280x720"; each side from 1 to 16384 pixels.
PictureSize size_option(const std::string& option, const std::string& text);

} // namespace engine
