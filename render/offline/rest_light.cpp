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

/// Irradiance / pi of a white surface by a lamp of unit intensity.
double lamp_share(const content::Lamp& lamp, const glm::dvec3& position, const glm::dvec3& normal) {
    const glm::dvec3 offset = glm::dvec3(lamp.position) - position;
    const double true_distance = glm::length(offset);
    const double distance = std::max(true_distance, nearest_lamp);
    const double share = lamp.range > 0.0f ? distance / lamp.range : 0.0;
    const double window = std::clamp(1.0 - share * share * share * share, 0.0, 1.0);
    const double cosine = true_distance > 0.0 ? std::max(0.0, glm::dot(normal, offset) / true_distance) : 0.0;
    return std::numbers::inv_pi * cosine * window / (distance * distance);
}

/// Off the surface, on the light's side, by more than single precision can misplace it.
glm::dvec3 shadow_origin(const SurfaceHit& hit, const glm::dvec3& towards_light) {
    const glm::dvec3 size = glm::abs(hit.position);
    const double gap = 1e-4 + 1e-6 * std::max({size.x, size.y, size.z});
    return hit.position + (glm::dot(hit.facing, towards_light) < 0.0 ? -gap : gap) * hit.facing;
}

bool lamp_visible(const content::Lamp& lamp, const SceneryHits& scenery, const SurfaceHit& hit) {
    const glm::dvec3 origin = shadow_origin(hit, glm::dvec3(lamp.position) - hit.position);
    const glm::dvec3 offset = glm::dvec3(lamp.position) - origin;
    const double distance = glm::length(offset);
    // What stands within the lamp's own few centimetres, as its lantern's glass, throws no shadow.
    return distance <= content::lamp_clearance ||
           !scenery.blocked(origin, offset / distance, distance - content::lamp_clearance);
}

glm::dvec3 normal_towards_eye(const TriangleView& triangle, const SurfaceHit& hit) {
    const glm::dvec3 normal = shading_normal(triangle, hit.barycentric);
    return glm::dot(normal, hit.facing) < 0.0 ? -normal : normal;
}

/// Light on a white surface, as radiance, by light; linear RGB.
std::vector<glm::dvec3> light_on_white(const content::SceneDesc& scene, const SceneSpectra& spectra,
                                       const SceneryHits& scenery, const SurfaceHit& hit, const glm::dvec3& normal) {
    std::vector<glm::dvec3> light(spectra.falling_lights(), glm::dvec3(0.0));
    light[0] = glm::dvec3(scene.ambient) * (0.65 + 0.35 * normal.y);
    if (scene.sun) {
        const glm::dvec3 towards_sun = glm::normalize(glm::dvec3(scene.sun->direction));
        const double cosine = glm::dot(normal, towards_sun);
        if (cosine > 0.0 && !scenery.blocked(shadow_origin(hit, towards_sun), towards_sun)) {
            light[0] += glm::dvec3(scene.sun->irradiance) * (std::numbers::inv_pi * cosine);
        }
    }
    for (std::size_t i = 0; i < scene.lamps.size(); ++i) {
        const content::Lamp& lamp = scene.lamps[i];
        const double share = lamp_share(lamp, hit.position, normal);
        if (share > 0.0 && lamp_visible(lamp, scenery, hit)) {
            light[spectra.lamps()[i]] += share * glm::dvec3(lamp.intensity);
        }
    }
    return light;
}

/// The panorama, bilinear, or the gradient.
glm::dvec3 sky_radiance(const content::SceneDesc& scene, const glm::dvec3& direction) {
    if (scene.panorama) {
        return panorama_radiance(*scene.panorama, direction);
    }
    const content::GradientSky& sky = scene.gradient_sky;
    return shared::gradient_sky_radiance(static_cast<float>(direction.y), sky.zenith, sky.horizon, sky.nadir);
}

} // namespace

RestLight surface_light(const content::SceneDesc& scene, const SceneSpectra& spectra, const SceneryHits& scenery,
                        const SurfaceHit& hit) {
    const TriangleView triangle(scene, hit.instance, hit.triangle);
    const MaterialTerms& material = spectra.materials()[triangle.mesh.material];
    const glm::dvec3 reflectance(base_colour(scene, triangle, hit.barycentric));
    RestLight light;
    if (triangle.material.unlit) {
        light.parts.push_back({0, {reflectance.r, reflectance.g, reflectance.b}});
        return light;
    }
    const glm::dvec3 normal = normal_towards_eye(triangle, hit);
    const std::vector<glm::dvec3> received = light_on_white(scene, spectra, scenery, hit, normal);
    for (std::size_t i = 0; i < received.size(); ++i) {
        if (received[i] != glm::dvec3(0.0)) {
            light.parts.push_back({material.reflected + i, spectra.reflected(material, reflectance, received[i])});
        }
    }
    if (content::emits(triangle.material)) {
        light.parts.push_back(
            {material.emitted, spectra.emitted(material, emission(scene, triangle, hit.barycentric))});
    }
    return light;
}

RestLight sky_light(const content::SceneDesc& scene, const SceneSpectra& spectra, const glm::dvec3& direction) {
    const glm::dvec3 radiance = sky_radiance(scene, direction);
    RestLight light;
    light.parts.push_back({0, {radiance.r, radiance.g, radiance.b}});
    if (spectra.microwave_background()) {
        light.parts.push_back({*spectra.microwave_background(), {1.0}});
    }
    return light;
}

} // namespace render
