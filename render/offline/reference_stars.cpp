#include "render/offline/reference_stars.h"

#include "render/colour/star_photometry.h"
#include "render/eye_ray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace star_footprint {
using glm::abs;
using glm::dot;
using glm::max;
using glm::normalize;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "render/shaders/shared/star.glsl"
} // namespace star_footprint
namespace {

/// Light if all of it fell into one pixel, at a point of the picture (pixels from the left and the top).
void spread(const glm::dvec3& radiance, const glm::dvec2& centre, std::span<const float> sky_shares, Picture& light) {
    const double reach = 0.5 * star_footprint::star_footprint;
    const int left = std::max(0, static_cast<int>(std::ceil(centre.x - reach - 0.5)));
    const int right = std::min(light.width - 1, static_cast<int>(std::floor(centre.x + reach - 0.5)));
    const int top = std::max(0, static_cast<int>(std::ceil(centre.y - reach - 0.5)));
    const int bottom = std::min(light.height - 1, static_cast<int>(std::floor(centre.y + reach - 0.5)));
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(light.width) +
                                      static_cast<std::size_t>(column);
            const float share =
                sky_shares[pixel] * star_footprint::star_share(glm::vec2(glm::dvec2(column + 0.5, row + 0.5) - centre));
            for (int i = 0; i < 3; ++i) {
                light.values[3 * pixel + static_cast<std::size_t>(i)] += share * static_cast<float>(radiance[i]);
            }
        }
    }
}

} // namespace

void add_stars(const content::SceneDesc& scene, const RenderFrame& frame, std::span<const float> sky_shares,
               Picture& light) {
    if (scene.stars.empty()) {
        return;
    }
    const DopplerColour colour(scene.light_temperature);
    const sim::BoostAndRotation eye = sim::split(frame.eye.world_from_head);
    const glm::dvec3 eye_light_years = frame.eye.position / frame.metres_per_light_year;
    const double focal_pixels = focal_length_pixels(frame.eye);
    const glm::dvec2 axis = axis_pixel(frame.eye);
    const glm::dvec2 middle(0.5 * frame.eye.width, 0.5 * frame.eye.height);
    const double margin = star_footprint::star_footprint;
    for (const content::Star& star : scene.stars) {
        const glm::dvec3 offset = star.position - eye_light_years;
        const double distance = glm::length(offset);
        if (distance == 0.0) {
            continue; // the eye is where the star is: no direction to show it in
        }
        const sim::SeenFrom seen = sim::where_seen(eye, {offset / distance});
        const glm::dvec3& direction = seen.head_direction;
        if (direction.z >= 0.0) {
            continue;
        }
        const glm::dvec2 centre = axis + focal_pixels / -direction.z * glm::dvec2(direction.x, -direction.y);
        if (glm::any(glm::greaterThan(glm::abs(centre - middle), middle + margin))) {
            continue;
        }
        const double pixel =
            star_footprint::pixel_solid_angle(static_cast<float>(-direction.z), static_cast<float>(focal_pixels));
        const glm::dvec3 irradiance =
            star_light(colour, star_source(colour, star), frame.mode, distance, seen.wavelength_ratio);
        spread(irradiance / pixel, centre, sky_shares, light);
    }
}

} // namespace render
