#include "render/offline/rest_light.h"

#include "render/offline/surface.h"
#include "render/panorama.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace shared {
using glm::clamp;
using glm::mix;
using glm::vec3;
namespace {
#include "render/shaders/shared/sky_gradient.glsl"
}
} // namespace shared
namespace {

constexpr double nearest_lamp = 0.05; // metres

glm::dvec3 lamp_light(const content::Lamp& lamp, const glm::dvec3& position, const glm::dvec3& normal) {
    const glm::dvec3 offset = glm::dvec3(lamp.position) - position;
    const double true_distance = glm::length(offset);
    const double distance = std::max(true_distance, nearest_lamp);
    const double share = lamp.range > 0.0f ? distance / lamp.range : 0.0;
    const double window = std::clamp(1.0 - share * share * share * share, 0.0, 1.0);
    const double cosine = true_distance > 0.0 ? std::max(0.0, glm::dot(normal, offset) / true_distance) : 0.0;
    return glm::dvec3(lamp.intensity) * (std::numbers::inv_pi * cosine * window / (distance * distance));
}

// Light on a white surface, as radiance.
glm::dvec3 light_on_white(const content::SceneDesc& scene, const SceneryHits& scenery, const SurfaceHit& hit,
                          const glm::dvec3& normal) {
    glm::dvec3 light = glm::dvec3(scene.ambient) * (0.65 + 0.35 * normal.y);
    if (scene.sun) {
        const glm::dvec3 towards_sun = glm::normalize(glm::dvec3(scene.sun->direction));
        const double cosine = glm::dot(normal, towards_sun);
        // Off the surface, on the sun's side, by more than single precision can misplace it.
        const glm::dvec3 size = glm::abs(hit.position);
        const double gap = 1e-4 + 1e-6 * std::max({size.x, size.y, size.z});
        const double side = glm::dot(hit.facing, towards_sun) < 0.0 ? -gap : gap;
        if (cosine > 0.0 && !scenery.blocked(hit.position + side * hit.facing, towards_sun)) {
            light += glm::dvec3(scene.sun->irradiance) * (std::numbers::inv_pi * cosine);
        }
    }
    for (const content::Lamp& lamp : scene.lamps) {
        light += lamp_light(lamp, hit.position, normal);
    }
    return light;
}

} // namespace

glm::dvec3 surface_radiance(const content::SceneDesc& scene, const SceneryHits& scenery, const SurfaceHit& hit) {
    const TriangleView triangle(scene, hit.instance, hit.triangle);
    const glm::dvec3 reflectance(base_colour(scene, triangle, hit.barycentric));
    if (triangle.material.unlit) {
        return reflectance;
    }
    glm::dvec3 normal = shading_normal(triangle, hit.barycentric);
    if (glm::dot(normal, hit.facing) < 0.0) {
        normal = -normal;
    }
    return reflectance * light_on_white(scene, scenery, hit, normal) + emission(scene, triangle, hit.barycentric);
}

glm::dvec3 sky_radiance(const content::SceneDesc& scene, const glm::dvec3& direction) {
    if (scene.panorama) {
        return panorama_radiance(*scene.panorama, direction);
    }
    const content::GradientSky& sky = scene.gradient_sky;
    return shared::gradient_sky_radiance(static_cast<float>(direction.y), sky.zenith, sky.horizon, sky.nadir);
}

} // namespace render
