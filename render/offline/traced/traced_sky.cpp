#include "render/offline/traced/traced_sky.h"

#include "content/panorama.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <system_error>

namespace render {
namespace {

// Integral from 0 of the square wave that is +1 on [0, 1), -1 on [1, 2) and so on: a triangle wave.
double square_wave_integral(double x) {
    const double phase = x - 2.0 * std::floor(0.5 * x);
    return phase < 1.0 ? phase : 2.0 - phase;
}

double square_wave_mean(double x, double width) {
    if (width < 1e-9) {
        return x - 2.0 * std::floor(0.5 * x) < 1.0 ? 1.0 : -1.0;
    }
    return (square_wave_integral(x + 0.5 * width) - square_wave_integral(x - 0.5 * width)) / width;
}

// A tint for each quarter of longitude, so that an image of the sky can be told from its mirror image.
constexpr std::array<glm::dvec3, 4> quarter_tints{
    {{1.0, 0.25, 0.2}, {1.0, 0.8, 0.2}, {0.25, 0.8, 0.35}, {0.25, 0.45, 1.0}}};

glm::dvec3 checkerboard_radiance(const glm::dvec3& direction, double square, const glm::dvec3& side_u,
                                 const glm::dvec3& side_v) {
    const double horizontal = std::hypot(direction.x, direction.y);
    const double longitude = std::atan2(direction.y, direction.x);
    const double latitude = std::atan2(direction.z, horizontal);
    const double inverse = 1.0 / std::max(horizontal, 1e-9);
    const glm::dvec3 east(-direction.y * inverse, direction.x * inverse, 0.0);
    const glm::dvec3 north = glm::cross(direction, east);
    const double east_width =
        (std::abs(glm::dot(side_u, east)) + std::abs(glm::dot(side_v, east))) * std::max(inverse, 1.0);
    const double north_width = std::abs(glm::dot(side_u, north)) + std::abs(glm::dot(side_v, north));
    const double share = checkerboard_share(longitude, latitude, square, east_width, north_width);
    const auto quarter = static_cast<std::size_t>(
        std::clamp(std::floor((longitude + std::numbers::pi) / (0.5 * std::numbers::pi)), 0.0, 3.0));
    return quarter_tints[quarter] * (0.15 + 0.85 * share);
}

} // namespace

double checkerboard_share(double longitude, double latitude, double square, double longitude_width,
                          double latitude_width) {
    return 0.5 + 0.5 * square_wave_mean(longitude / square, longitude_width / square) *
                     square_wave_mean(latitude / square, latitude_width / square);
}

SkyLight::SkyLight(const content::TracedSky& sky, std::vector<std::string>& notes)
    : checkerboard_(sky.checkerboard), colour_(sky.colour) {
    if (sky.panorama.empty()) {
        return;
    }
    std::error_code error;
    if (!std::filesystem::is_regular_file(sky.panorama, error)) {
        notes.push_back(fmt::format("the panorama {} is missing; ./fly fetches it (Debian's blender-data package); a "
                                    "checkerboard stands in for it",
                                    sky.panorama.filename().string()));
        checkerboard_ = std::numbers::pi / 18.0;
        return;
    }
    content::LoadedPanorama loaded = content::load_panorama(sky.panorama);
    content::turn_and_scale(loaded.panorama, sky.panorama_turn, static_cast<float>(sky.panorama_scale));
    notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
    panorama_.emplace(std::move(loaded.panorama));
}

glm::dvec3 SkyLight::radiance(const glm::dvec3& direction, const glm::dvec3& side_u, const glm::dvec3& side_v) const {
    if (panorama_) {
        return panorama_->radiance(world_from_chart(direction), world_from_chart(side_u), world_from_chart(side_v));
    }
    if (checkerboard_ > 0.0) {
        return checkerboard_radiance(direction, checkerboard_, side_u, side_v);
    }
    return colour_;
}

} // namespace render
