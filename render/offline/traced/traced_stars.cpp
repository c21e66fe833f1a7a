#include "render/offline/traced/traced_stars.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace traced_footprint {
using glm::abs;
using glm::dot;
using glm::max;
using glm::normalize;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "render/shaders/shared/star.glsl"
} // namespace traced_footprint
namespace {

constexpr int latitude_bins = 180;
constexpr double widest_cell = 0.2;         // radians of sky between neighbouring corners
constexpr double faintest_magnitude = 11.0; // as magnified; 60 times fainter than what a naked eye sees
constexpr double probe = 0.25;              // pixels between the rays of a finite difference
constexpr int newton_steps = 3;
constexpr double farthest_from_cell = 1.0; // pixels that Newton's method may lead away from the cell

std::size_t longitude_bins(std::size_t latitude_bin) {
    const double latitude = (static_cast<double>(latitude_bin) + 0.5) / latitude_bins * std::numbers::pi;
    return std::max<std::size_t>(1, static_cast<std::size_t>(2.0 * latitude_bins * std::sin(latitude)));
}

std::array<std::size_t, latitude_bins + 1> first_bins() {
    std::array<std::size_t, latitude_bins + 1> first{};
    for (std::size_t i = 0; i < latitude_bins; ++i) {
        first[i + 1] = first[i] + longitude_bins(i);
    }
    return first;
}

const std::array<std::size_t, latitude_bins + 1>& first_bin() {
    static const auto first = first_bins();
    return first;
}

double colatitude(const glm::dvec3& direction) {
    return std::atan2(std::hypot(direction.x, direction.y), direction.z);
}
double longitude(const glm::dvec3& direction) {
    return std::atan2(direction.y, direction.x) + std::numbers::pi;
}

std::size_t latitude_bin(double angle) {
    return static_cast<std::size_t>(
        std::clamp(angle / std::numbers::pi * latitude_bins, 0.0, static_cast<double>(latitude_bins - 1)));
}

double triple(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a, glm::cross(b, c));
}

// Weights of the corners of a spherical triangle at a direction in it; nothing outside.
std::optional<glm::dvec3> weights_in(const std::array<glm::dvec3, 3>& corner, const glm::dvec3& direction) {
    const glm::dvec3 w(triple(direction, corner[1], corner[2]), triple(corner[0], direction, corner[2]),
                       triple(corner[0], corner[1], direction));
    const bool inside = (w.x >= 0.0 && w.y >= 0.0 && w.z >= 0.0) || (w.x <= 0.0 && w.y <= 0.0 && w.z <= 0.0);
    const double sum = w.x + w.y + w.z;
    if (!inside || sum == 0.0) {
        return std::nullopt;
    }
    return w / sum;
}

/// A grid of rays through the corners of a tile's pixels and of those around it.
class CornerGrid {
  public:
    CornerGrid(const CameraLens& lens, const RaySource& rays, const TracedTile& tile, int margin)
        : left_(tile.left - margin), top_(tile.top - margin), columns_(tile.width + 2 * margin + 1),
          rows_(tile.height + 2 * margin + 1) {
        std::vector<glm::dvec3> directions;
        std::vector<std::size_t> index;
        const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
        rays_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            rays_[i].fate = RayFate::captured;
            if (const auto direction = head_direction(lens, corner(i))) {
                directions.push_back(*direction);
                index.push_back(i);
            }
        }
        std::vector<TracedRay> traced(directions.size());
        rays.trace(directions, traced);
        for (std::size_t i = 0; i < index.size(); ++i) {
            rays_[index[i]] = traced[i];
        }
    }

    glm::dvec2 corner(std::size_t i) const {
        const auto columns = static_cast<std::size_t>(columns_);
        const std::size_t row = i / columns;
        return {left_ + static_cast<double>(i % columns), top_ + static_cast<double>(row)};
    }
    const TracedRay& ray(std::size_t i) const { return rays_[i]; }

    /// Calls work({three corners' indices}) for both triangles of each cell.
    template <class Work>
    void for_each_triangle(const Work& work) const {
        const auto columns = static_cast<std::size_t>(columns_);
        for (std::size_t row = 0; row + 1 < static_cast<std::size_t>(rows_); ++row) {
            for (std::size_t column = 0; column + 1 < columns; ++column) {
                const std::size_t a = row * columns + column;
                work(std::array<std::size_t, 3>{a, a + 1, a + columns + 1});
                work(std::array<std::size_t, 3>{a, a + columns + 1, a + columns});
            }
        }
    }

  private:
    int left_;
    int top_;
    int columns_;
    int rows_;
    std::vector<TracedRay> rays_;
};

/// The rays around a place in the picture: where they come from, and how that changes by the pixel.
struct SkyAround {
    bool escaped = false;
    glm::dvec3 direction{0.0};
    glm::dvec3 by_x{0.0}; ///< radians a pixel
    glm::dvec3 by_y{0.0};
    double wavelength_ratio = 1.0;
};

constexpr std::array<glm::dvec2, 5> probes{{{0.0, 0.0}, {probe, 0.0}, {-probe, 0.0}, {0.0, probe}, {0.0, -probe}}};

/// Around many places at once, so that the rays fill their lanes.
template <class Places>
std::vector<SkyAround> sky_around(const CameraLens& lens, const RaySource& rays, RayFate sky, const Places& places) {
    std::vector<glm::dvec3> directions;
    std::vector<bool> shown;
    for (const auto& image : places) {
        bool all = true;
        for (const glm::dvec2& offset : probes) {
            const auto direction = head_direction(lens, image.place + offset);
            all = all && direction;
            directions.push_back(direction.value_or(glm::dvec3(0.0, 0.0, -1.0)));
        }
        shown.push_back(all);
    }
    std::vector<TracedRay> traced(directions.size());
    rays.trace(directions, traced);
    std::vector<SkyAround> around(shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const TracedRay* const ray = &traced[probes.size() * i];
        if (shown[i] && std::all_of(ray, ray + probes.size(), [&](const TracedRay& r) { return r.fate == sky; })) {
            around[i] = {true, ray[0].direction, (ray[1].direction - ray[2].direction) / (2.0 * probe),
                         (ray[3].direction - ray[4].direction) / (2.0 * probe), ray[0].wavelength_ratio};
        }
    }
    return around;
}

/// Newton's step in pixels towards where the sky's direction is `wanted`; nothing where the map is degenerate.
std::optional<glm::dvec2> newton_step(const SkyAround& around, const glm::dvec3& wanted) {
    const double uu = glm::dot(around.by_x, around.by_x);
    const double uv = glm::dot(around.by_x, around.by_y);
    const double vv = glm::dot(around.by_y, around.by_y);
    const double determinant = uu * vv - uv * uv;
    const glm::dvec3 miss = wanted - around.direction;
    const glm::dvec2 along(glm::dot(around.by_x, miss), glm::dot(around.by_y, miss));
    const glm::dvec2 step = glm::dvec2(vv * along.x - uv * along.y, uu * along.y - uv * along.x) / determinant;
    return glm::length(step) < farthest_from_cell ? std::optional(step) : std::nullopt;
}

} // namespace

StarField::StarField(const std::vector<content::Star>& stars, const TracedColour& colour, double scale)
    : colour_(colour), scale_(scale), bins_(first_bin().back()) {
    stars_.reserve(stars.size());
    for (const content::Star& star : stars) {
        const double distance = glm::length(star.position);
        if (!(distance > 1e-3)) {
            continue; // the Sun itself: there is no direction to it
        }
        const glm::dvec3 world = star.position / distance;
        const glm::dvec3 direction(world.x, -world.z, world.y);
        const std::size_t row = latitude_bin(colatitude(direction));
        const std::size_t columns = longitude_bins(row);
        const auto column =
            std::min(columns - 1, static_cast<std::size_t>(longitude(direction) / (2.0 * std::numbers::pi) *
                                                           static_cast<double>(columns)));
        bins_[first_bin()[row] + column].push_back(stars_.size());
        stars_.push_back({direction, distance, star.visual_magnitude, star_source(colour.table(), star)});
    }
}

std::vector<std::size_t> StarField::near(const glm::dvec3& direction, double angle) const {
    std::vector<std::size_t> found;
    const double middle = colatitude(direction);
    const std::size_t first_row = latitude_bin(middle - angle);
    const std::size_t last_row = latitude_bin(middle + angle);
    const double azimuth = longitude(direction);
    for (std::size_t row = first_row; row <= last_row; ++row) {
        const std::size_t columns = longitude_bins(row);
        const double bin_width = 2.0 * std::numbers::pi / static_cast<double>(columns);
        // The widest longitude that a cap reaches; all of the row when it holds a pole.
        const double sine = std::sin(angle) / std::max(std::sin(middle), 1e-12);
        const bool whole = angle >= 0.5 * std::numbers::pi || sine >= 1.0 || middle - angle <= 0.0 ||
                           middle + angle >= std::numbers::pi;
        const double half_width = whole ? std::numbers::pi : std::asin(sine);
        const auto first = static_cast<std::int64_t>(std::floor((azimuth - half_width) / bin_width));
        const auto last = static_cast<std::int64_t>(std::floor((azimuth + half_width) / bin_width));
        const auto n = static_cast<std::int64_t>(columns);
        const std::int64_t count = std::min(last - first + 1, n);
        for (std::int64_t i = 0; i < count; ++i) {
            const auto column = static_cast<std::size_t>((((first + i) % n) + n) % n);
            const std::vector<std::size_t>& bin = bins_[first_bin()[row] + column];
            found.insert(found.end(), bin.begin(), bin.end());
        }
    }
    return found;
}

std::vector<StarField::Image> StarField::candidates(const CameraLens& lens, const RaySource& rays, RayFate sky,
                                                    const TracedTile& tile) const {
    const int margin = static_cast<int>(0.5f * traced_footprint::star_footprint) + 1;
    const CornerGrid grid(lens, rays, tile, margin);
    std::vector<Image> found;
    grid.for_each_triangle([&](const std::array<std::size_t, 3>& index) {
        std::array<glm::dvec3, 3> corner{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (grid.ray(index[i]).fate != sky) {
                return;
            }
            corner[i] = grid.ray(index[i]).direction;
        }
        const double angle = std::max(glm::length(corner[1] - corner[0]), glm::length(corner[2] - corner[0]));
        if (angle > widest_cell) {
            return;
        }
        // Half a pixel is seen of this much sky.
        const double sky_area = glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
        const double magnification = pixel_solid_angle(lens, grid.corner(index[0])) / sky_area;
        const double faintest = faintest_magnitude + 2.5 * std::log10(scale_ * magnification);
        for (const std::size_t star : near(corner[0], angle)) {
            if (stars_[star].magnitude > faintest || glm::dot(corner[0], stars_[star].direction) <= 0.0) {
                continue;
            }
            if (const auto w = weights_in(corner, stars_[star].direction)) {
                found.push_back(
                    {star, w->x * grid.corner(index[0]) + w->y * grid.corner(index[1]) + w->z * grid.corner(index[2])});
            }
        }
    });
    return found;
}

std::vector<StarField::Image> StarField::images(const CameraLens& lens, const RaySource& rays,
                                                const BundleMagnification& magnification, RayFate sky,
                                                const TracedTile& tile) const {
    std::vector<Image> found = candidates(lens, rays, sky, tile);
    const std::vector<Image> start = found;
    std::vector<SkyAround> around = sky_around(lens, rays, sky, found);
    for (int i = 0; i < newton_steps; ++i) {
        for (std::size_t k = 0; k < found.size(); ++k) {
            const auto step =
                around[k].escaped ? newton_step(around[k], stars_[found[k].star].direction) : std::nullopt;
            found[k].place += step.value_or(glm::dvec2(2.0 * farthest_from_cell));
        }
        around = sky_around(lens, rays, sky, found);
    }
    std::vector<Image> images;
    for (std::size_t k = 0; k < found.size(); ++k) {
        Image& image = found[k];
        const double sky_by_pixel = glm::length(glm::cross(around[k].by_x, around[k].by_y));
        const double left_over = glm::length(stars_[image.star].direction - around[k].direction);
        // A hundredth of a pixel on the sky, or not the image that the triangle promised.
        if (!around[k].escaped || !(left_over * left_over < 1e-4 * sky_by_pixel + 1e-24) ||
            !(glm::length(image.place - start[k].place) < farthest_from_cell)) {
            continue;
        }
        const bool known = std::any_of(images.begin(), images.end(), [&](const Image& other) {
            return other.star == image.star && glm::length(other.place - image.place) < 0.1;
        });
        if (!known) {
            image.magnification = magnification(*head_direction(lens, image.place));
            image.wavelength_ratio = around[k].wavelength_ratio;
            images.push_back(image);
        }
    }
    return images;
}

void StarField::add(const std::vector<Image>& images, const CameraLens& lens, TracedTile& tile) const {
    const double reach = 0.5 * traced_footprint::star_footprint;
    for (const Image& image : images) {
        const Star& star = stars_[image.star];
        // star_light holds the solid angle of a flat sky, D^2; here the bundle of rays says it.
        const double d = image.wavelength_ratio;
        const glm::dvec3 irradiance = star_light(colour_.table(), star.source, Mode::full, star.distance, d) *
                                      (scale_ * image.magnification / (d * d));
        const glm::dvec3 radiance = irradiance / pixel_solid_angle(lens, image.place);
        const int first_row = std::max(0, static_cast<int>(std::ceil(image.place.y - reach - 0.5)) - tile.top);
        const int last_row =
            std::min(tile.height - 1, static_cast<int>(std::floor(image.place.y + reach - 0.5)) - tile.top);
        const int first_column = std::max(0, static_cast<int>(std::ceil(image.place.x - reach - 0.5)) - tile.left);
        const int last_column =
            std::min(tile.width - 1, static_cast<int>(std::floor(image.place.x + reach - 0.5)) - tile.left);
        for (int row = first_row; row <= last_row; ++row) {
            for (int column = first_column; column <= last_column; ++column) {
                const glm::dvec2 pixel(tile.left + column + 0.5, tile.top + row + 0.5);
                const double share = traced_footprint::star_share(glm::vec2(pixel - image.place));
                tile.value(column, row, TracedChannel::red) += static_cast<float>(share * radiance.x);
                tile.value(column, row, TracedChannel::green) += static_cast<float>(share * radiance.y);
                tile.value(column, row, TracedChannel::blue) += static_cast<float>(share * radiance.z);
            }
        }
    }
}

} // namespace render
