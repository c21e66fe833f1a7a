#include "render/offline/traced/tile_painter.h"

#include "render/colour/display.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

namespace render {
namespace {

constexpr int refinements = 2;
constexpr double widest_spread = 0.05;    // radians of sky within a pixel that asks for more rays
constexpr double largest_contrast = 0.35; // (brightest - darkest) / (brightest + darkest), disks and objects
constexpr std::size_t batch_pixels = 256;

double luminance_of(const glm::dvec3& rgb) {
    return luminance(glm::vec3(rgb));
}

/// The square of samples of one pixel.
class PixelSamples {
  public:
    PixelSamples(std::span<const TracedRay> rays, int side) : rays_(rays), side_(side) {}

    const TracedRay& ray(int column, int row) const {
        return rays_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                     static_cast<std::size_t>(column)];
    }

    /// How the sky's direction changes from this sample to the next along a row or column: what one sample stands for.
    glm::dvec3 side(int column, int row, int along_x, int along_y) const {
        const TracedRay& here = ray(column, row);
        const auto towards = [&](int sign) -> std::optional<glm::dvec3> {
            const int x = column + sign * along_x;
            const int y = row + sign * along_y;
            if (x < 0 || y < 0 || x >= side_ || y >= side_ || ray(x, y).fate != here.fate) {
                return std::nullopt;
            }
            return static_cast<double>(sign) * (ray(x, y).direction - here.direction);
        };
        if (const auto forwards = towards(1)) {
            return *forwards;
        }
        return towards(-1).value_or(glm::dvec3(0.0));
    }

    bool settled(std::span<const glm::dvec3> light) const {
        const TracedRay& first = rays_.front();
        double darkest = luminance_of(light.front());
        double brightest = darkest;
        for (std::size_t i = 1; i < rays_.size(); ++i) {
            const TracedRay& ray = rays_[i];
            if (ray.fate != first.fate || ray.object != first.object ||
                (is_sky(ray.fate) && glm::length(ray.direction - first.direction) > widest_spread)) {
                return false;
            }
            darkest = std::min(darkest, luminance_of(light[i]));
            brightest = std::max(brightest, luminance_of(light[i]));
        }
        return is_sky(first.fate) || brightest - darkest <= largest_contrast * (brightest + darkest);
    }

  private:
    std::span<const TracedRay> rays_;
    int side_;
};

glm::dvec3 light_of(const TracedSkies& skies, const TracedColour& colour, const PixelSamples& samples, int column,
                    int row) {
    const TracedRay& ray = samples.ray(column, row);
    if (!is_sky(ray.fate)) {
        return ray.light; // black for what is captured or not known
    }
    const SkyLight* sky = skies.light[ray.fate == RayFate::other_sky ? 1 : 0];
    if (sky == nullptr || !(ray.wavelength_ratio > 0.0)) {
        return glm::dvec3(0.0);
    }
    const glm::dvec3 at_rest =
        sky->radiance(ray.direction, samples.side(column, row, 1, 0), samples.side(column, row, 0, 1));
    return colour.seen(at_rest, ray.wavelength_ratio);
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

std::vector<std::size_t> TilePainter::directions_of(const TracedTile& tile, std::span<const std::size_t> pixels,
                                                    int samples, std::vector<glm::dvec3>& directions) const {
    const auto per_pixel = static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples);
    const auto width = static_cast<std::size_t>(tile.width);
    std::vector<std::size_t> shown;
    directions.clear();
    for (const std::size_t pixel : pixels) {
        const std::size_t before = directions.size();
        const std::size_t row_of_tile = pixel / width;
        const glm::dvec2 corner(tile.left + static_cast<double>(pixel % width),
                                tile.top + static_cast<double>(row_of_tile));
        for (int row = 0; row < samples; ++row) {
            for (int column = 0; column < samples; ++column) {
                const glm::dvec2 offset = glm::dvec2(column + 0.5, row + 0.5) / static_cast<double>(samples);
                if (const auto direction = head_direction(lens_, corner + offset)) {
                    directions.push_back(*direction);
                }
            }
        }
        if (directions.size() == before + per_pixel) {
            shown.push_back(pixel);
        } else {
            directions.resize(before); // astride the rim of a fisheye's circle
        }
    }
    return shown;
}

bool TilePainter::paint_pixel(TracedTile& tile, std::size_t pixel, std::span<const TracedRay> rays, int samples) const {
    const PixelSamples square(rays, samples);
    std::vector<glm::dvec3> light(rays.size());
    glm::dvec3 sum(0.0);
    double steps = 0.0;
    std::size_t undecided = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        light[k] = light_of(skies_, colour_, square, static_cast<int>(k) % samples, static_cast<int>(k) / samples);
        if (is_undecided(rays[k].fate) || !is_finite(light[k])) {
            // Never silently black: magenta as bright as a white surface.
            light[k] = glm::dvec3(1.0, 0.0, 1.0);
            ++undecided;
        }
        sum += light[k];
        steps += rays[k].steps;
    }
    const auto width = static_cast<std::size_t>(tile.width);
    const auto column = static_cast<int>(pixel % width);
    const auto row = static_cast<int>(pixel / width);
    const double weight = 1.0 / static_cast<double>(rays.size());
    const TracedRay& middle = square.ray(samples / 2, samples / 2);
    const auto put = [&](TracedChannel channel, double value) {
        tile.value(column, row, channel) = static_cast<float>(value);
    };
    put(TracedChannel::red, weight * sum.x);
    put(TracedChannel::green, weight * sum.y);
    put(TracedChannel::blue, weight * sum.z);
    put(TracedChannel::error, rays.front().error);
    put(TracedChannel::steps, weight * steps);
    put(TracedChannel::wavelength_ratio, middle.wavelength_ratio);
    put(TracedChannel::outcome, static_cast<double>(middle.fate));
    put(TracedChannel::undecided, weight * static_cast<double>(undecided));
    tile.value(column, row, TracedChannel::rays) += static_cast<float>(rays.size());
    return square.settled(light);
}

std::vector<std::size_t> TilePainter::paint_pixels(TracedTile& tile, const std::vector<std::size_t>& pixels,
                                                   int samples) const {
    const auto per_pixel = static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples);
    std::vector<glm::dvec3> directions;
    std::vector<TracedRay> rays;
    std::vector<std::size_t> unsettled;
    for (std::size_t begin = 0; begin < pixels.size(); begin += batch_pixels) {
        const std::size_t count = std::min(pixels.size() - begin, batch_pixels);
        const std::vector<std::size_t> shown =
            directions_of(tile, std::span(pixels).subspan(begin, count), samples, directions);
        rays.assign(directions.size(), TracedRay{});
        rays_.trace(directions, rays, per_pixel);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (!paint_pixel(tile, shown[i], std::span(rays).subspan(i * per_pixel, per_pixel), samples)) {
                unsettled.push_back(shown[i]);
            }
        }
    }
    return unsettled;
}

void TilePainter::paint(TracedTile& tile) const {
    const auto count = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
    tile.values.assign(count * traced_channel_count, 0.0f);
    std::vector<std::size_t> pixels(count);
    std::iota(pixels.begin(), pixels.end(), std::size_t{0});
    int samples = samples_;
    for (int level = 0; level <= refinements && !pixels.empty(); ++level) {
        pixels = paint_pixels(tile, pixels, samples);
        samples *= 2;
    }
    for (std::size_t side = 0; side < skies_.stars.size(); ++side) {
        if (skies_.stars[side] != nullptr) {
            const RayFate sky = side == 0 ? RayFate::sky : RayFate::other_sky;
            const StarField& stars = *skies_.stars[side];
            stars.add(stars.images(lens_, rays_, magnification_, sky, tile), lens_, tile);
        }
    }
}

} // namespace render
