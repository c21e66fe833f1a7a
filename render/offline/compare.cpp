#include "render/offline/compare.h"

#include "render/colour/colour_difference.h"
#include "render/colour/colour_space.h"
#include "render/shown_picture.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace render {
namespace {

constexpr int sub_samples = 4; // along each side of a pixel

void require_equal_sizes(const content::Image& a, const content::Image& b) {
    if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) {
        throw std::invalid_argument("pictures of different sizes cannot be compared");
    }
}

double value(const Picture& picture, int column, int row) {
    return picture.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(column)];
}

/// Squared distance in sub-samples from the centre of a pixel to the nearest sub-sample with its id among those whose
/// column or row is `ring` away from the four in the middle.
double nearest_squared_in_ring(const Picture& truth, int column, int row, int ring, double id) {
    // The centre lies on the corner between sub-samples first - 1 and first.
    const int first_column = sub_samples * column + sub_samples / 2;
    const int first_row = sub_samples * row + sub_samples / 2;
    double nearest = std::numeric_limits<double>::infinity();
    for (int dy = -1 - ring; dy <= ring; ++dy) {
        const bool whole_row = dy == -1 - ring || dy == ring;
        const int y = first_row + dy;
        if (y < 0 || y >= truth.height) {
            continue;
        }
        for (int dx = -1 - ring; dx <= ring; dx += whole_row ? 1 : 2 * ring + 1) {
            const int x = first_column + dx;
            if (x >= 0 && x < truth.width && value(truth, x, y) == id) {
                nearest = std::min(nearest, (dx + 0.5) * (dx + 0.5) + (dy + 0.5) * (dy + 0.5));
            }
        }
    }
    return nearest;
}

double displacement(const Picture& truth, int column, int row, double id) {
    const int rings = static_cast<int>(largest_displacement * sub_samples);
    double nearest = std::numeric_limits<double>::infinity();
    // A farther ring can still hold a nearer sample than a nearer ring's corner.
    for (int ring = 0; ring < rings && (ring + 0.5) * (ring + 0.5) < nearest; ++ring) {
        nearest = std::min(nearest, nearest_squared_in_ring(truth, column, row, ring, id));
    }
    return std::min(std::sqrt(nearest) / sub_samples, largest_displacement);
}

} // namespace

double peak_signal_to_noise(const content::Image& a, const content::Image& b) {
    require_equal_sizes(a, b);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const double difference = i % 4 == 3 ? 0.0 : static_cast<double>(a.rgba[i]) - static_cast<double>(b.rgba[i]);
        sum += difference * difference;
    }
    const double mean = sum / (0.75 * static_cast<double>(a.rgba.size()));
    return 10.0 * std::log10(255.0 * 255.0 / mean);
}

std::vector<double> colour_differences(const Picture& picture, const Picture& truth) {
    const double exposure = std::exp2(exposure_stops(truth, {true, 0.0f, true}));
    const glm::dmat3 xyz_from_rgb = glm::inverse(srgb_from_xyz());
    std::vector<double> result;
    for (std::size_t at = 0; at < truth.values.size(); at += 3) {
        const auto xyz = [&](const Picture& p) {
            return exposure * (xyz_from_rgb * glm::dvec3(p.values[at], p.values[at + 1], p.values[at + 2]));
        };
        const double scale = 1.0 / std::max(1.0, xyz(truth).y);
        result.push_back(ciede2000(lab_from_xyz(scale * xyz(picture)), lab_from_xyz(scale * xyz(truth))));
    }
    return result;
}

content::Image difference_picture(const content::Image& a, const content::Image& b) {
    require_equal_sizes(a, b);
    content::Image difference = a;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const int enlarged = 4 * std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
        difference.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(std::min(enlarged, 255));
    }
    return difference;
}

double edge_displacement(const Picture& objects, const TrueObjects& truth, double share) {
    if (truth.sub_samples.width != sub_samples * objects.width ||
        truth.sub_samples.height != sub_samples * objects.height || truth.at_centres.width != objects.width ||
        truth.at_centres.height != objects.height) {
        throw std::invalid_argument("the truth must have each pixel's centre and four sub-samples along its sides");
    }
    std::vector<double> distances;
    distances.reserve(objects.values.size());
    for (int row = 0; row < objects.height; ++row) {
        for (int column = 0; column < objects.width; ++column) {
            const double id = value(objects, column, row);
            distances.push_back(
                id == value(truth.at_centres, column, row) ? 0.0 : displacement(truth.sub_samples, column, row, id));
        }
    }
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
    return distances[static_cast<std::size_t>(rank)];
}

} // namespace render
