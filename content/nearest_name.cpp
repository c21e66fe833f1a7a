#include "content/nearest_name.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace content {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // distances[j]: from the letters of a read so far to the first j letters of b.
    std::vector<std::size_t> distances(b.size() + 1);
    std::iota(distances.begin(), distances.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = distances[0];
        distances[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = distances[j + 1];
            distances[j + 1] = std::min({replaced, distances[j] + 1, distances[j + 1] + 1});
        }
    }
    return distances.back();
}

} // namespace

std::string nearest_name(std::string_view text, const std::vector<std::string>& names) {
    std::string nearest;
    std::size_t smallest = std::numeric_limits<std::size_t>::max();
    for (const std::string& name : names) {
        const std::size_t distance = edit_distance(text, name);
        if (distance < smallest) {
            smallest = distance;
            nearest = name;
        }
    }
    return nearest;
}

} // namespace content
