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

void TilePainter::paint_pixels(TracedTile& tile, const std::vector<std::size_t>& pixels, int samples,
                               std::vector<std::size_t>& unsettled) const {
    const auto per_pixel = static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples);
    std::vector<glm::dvec3> directions;
    std::vector<TracedRay> traced;
    std::vector<glm::dvec3> light(per_pixel);
    for (std::size_t begin = 0; begin < pixels.size(); begin += batch_pixels) {
        const std::size_t end = std::min(pixels.size(), begin + batch_pixels);
        directions.clear();
        std::vector<std::size_t> shown; // pixels with all their rays in the picture's circle
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t before = directions.size();
            const auto width = static_cast<std::size_t>(tile.width);
            const glm::dvec2 corner(tile.left + static_cast<double>(pixels[i] % width),
                                    tile.top + static_cast<double>(pixels[i] / width));
            for (int row = 0; row < samples; ++row) {
                for (int column = 0; column < samples; ++column) {
                    const auto direction =
                        head_direction(lens_, corner + glm::dvec2(column + 0.5, row + 0.5) / double(samples));
                    if (direction) {
                        directions.push_back(*direction);
                    }
                }
            }
            if (directions.size() == before + per_pixel) {
                shown.push_back(pixels[i]);
            } else {
                directions.resize(before);
            }
        }
        traced.assign(directions.size(), TracedRay{});
        rays_.trace(directions, traced, per_pixel);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const std::span<const TracedRay> own = std::span(traced).subspan(i * per_pixel, per_pixel);
            const PixelSamples square(own, samples);
            glm::dvec3 sum(0.0);
            double steps = 0.0;
            float error = 0.0f;
            std::size_t undecided = 0;
            for (std::size_t k = 0; k < per_pixel; ++k) {
                light[k] =
                    light_of(skies_, colour_, square, static_cast<int>(k) % samples, static_cast<int>(k) / samples);
                bool known = !is_undecided(own[k].fate);
                if (!is_finite(light[k])) {
                    light[k] = glm::dvec3(0.0);
                    known = false;
                }
                undecided += known ? 0 : 1;
                sum += light[k];
                steps += own[k].steps;
                error = std::max(error, own[k].error);
            }
            if (undecided > 0) {
                // Never silently black: magenta of the brightness of a white surface.
                sum += static_cast<double>(undecided) * glm::dvec3(1.0, 0.0, 1.0);
            }
            const auto width = static_cast<std::size_t>(tile.width);
            const int column = static_cast<int>(shown[i] % width);
            const int row = static_cast<int>(shown[i] / width);
            const double weight = 1.0 / static_cast<double>(per_pixel);
            const TracedRay& middle = own[static_cast<std::size_t>(samples / 2) * static_cast<std::size_t>(samples) +
                                          static_cast<std::size_t>(samples / 2)];
            const auto put = [&](TracedChannel channel, double value) {
                tile.value(column, row, channel) = static_cast<float>(value);
            };
            put(TracedChannel::red, weight * sum.x);
            put(TracedChannel::green, weight * sum.y);
            put(TracedChannel::blue, weight * sum.z);
            put(TracedChannel::error, error);
            put(TracedChannel::steps, weight * steps);
            put(TracedChannel::wavelength_ratio, middle.wavelength_ratio);
            put(TracedChannel::outcome, static_cast<double>(middle.fate));
            put(TracedChannel::undecided, weight * static_cast<double>(undecided));
            tile.value(column, row, TracedChannel::rays) += static_cast<float>(per_pixel);
            if (!square.settled(light)) {
                unsettled.push_back(shown[i]);
            }
        }
    }
}

void TilePainter::paint(TracedTile& tile) const {
    const auto count = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
    tile.values.assign(count * traced_channel_count, 0.0f);
    std::vector<std::size_t> pixels(count);
    std::iota(pixels.begin(), pixels.end(), std::size_t{0});
    int samples = samples_;
    for (int level = 0; level <= refinements && !pixels.empty(); ++level) {
        std::vector<std::size_t> unsettled;
        paint_pixels(tile, pixels, samples, unsettled);
        pixels = std::move(unsettled);
        samples *= 2;
    }
    for (std::size_t side = 0; side < skies_.stars.size(); ++side) {
        if (skies_.stars[side] != nullptr) {
            const RayFate sky = side == 0 ? RayFate::sky : RayFate::other_sky;
            skies_.stars[side]->add(skies_.stars[side]->images(lens_, rays_, sky, tile), lens_, tile);
        }
    }
}

} // namespace render
