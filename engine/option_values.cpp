#include "engine/option_values.h"

#include "content/number.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace engine {
namespace {

constexpr int largest_picture_side = 16384;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

} // namespace

double number_option(const std::string& option, const std::string& text) {
    if (const std::optional<double> value = content::finite_number(text)) {
        return *value;
    }
    throw sim::BadInput(option, "", text, "not a finite number");
}

double number_option(const std::string& option, const std::string& text, double lowest, double highest) {
    const double value = number_option(option, text);
    if (value < lowest || value > highest) {
        throw sim::BadInput(option, "", text, fmt::format("must lie in [{}, {}]", lowest, highest));
    }
    return value;
}

int whole_number_option(const std::string& option, const std::string& text, int lowest, int highest) {
    const double value = number_option(option, text);
    if (value != std::floor(value) || value < lowest || value > highest) {
        throw sim::BadInput(option, "", text, fmt::format("must be a whole number from {} to {}", lowest, highest));
    }
    return static_cast<int>(value);
}

std::vector<double> numbers_option(const std::string& option, const std::string& text, std::size_t count) {
    std::vector<double> numbers;
    for (const std::string& part : split(text, ',')) {
        const std::optional<double> value = content::finite_number(part);
        if (!value) {
            break;
        }
        numbers.push_back(*value);
    }
    if (numbers.size() != count ||
        std::count(text.begin(), text.end(), ',') + 1 != static_cast<std::ptrdiff_t>(count)) {
        throw sim::BadInput(option, "", text, fmt::format("must be {} finite numbers between commas", count));
    }
    return numbers;
}

void refuse_name(const std::string& option, const std::string& text, const std::vector<std::string_view>& known) {
    throw sim::BadInput(option, "", text, fmt::format("must be one of {}", fmt::join(known, ", ")));
}

glm::dvec3 direction_option(const std::string& option, const std::string& text) {
    const std::vector<double> numbers = numbers_option(option, text, 3);
    glm::dvec3 direction(numbers[0], numbers[1], numbers[2]);
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (largest == 0.0) {
        throw sim::BadInput(option, "", text, "a direction cannot be zero");
    }
    // Scaled first, so that the length of tiny and of huge numbers neither vanishes nor overflows.
    direction /= largest;
    return glm::normalize(direction);
}

PictureSize size_option(const std::string& option, const std::string& text) {
    std::vector<int> sides;
    for (const std::string& side : split(text, 'x')) {
        const std::optional<double> pixels = content::finite_number(side);
        if (!pixels || *pixels != std::floor(*pixels) || *pixels < 1.0 || *pixels > largest_picture_side) {
            break;
        }
        sides.push_back(static_cast<int>(*pixels));
    }
    if (sides.size() != 2 || std::count(text.begin(), text.end(), 'x') != 1) {
        throw sim::BadInput(option, "", text,
                            fmt::format("must be WIDTHxHEIGHT, each a whole number of pixels from 1 to {}, as 1280x720",
                                        largest_picture_side));
    }
    return {sides[0], sides[1]};
}

} // namespace engine
