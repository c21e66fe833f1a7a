#include "render/moving/hull_light.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace surface_shader {
using glm::clamp;
using glm::dot;
using glm::max;
using glm::vec3;
using std::sqrt;
#include "render/shaders/shared/surface_light.glsl"
} // namespace surface_shader
namespace {

constexpr double own_light = 0.15;

} // namespace

glm::dvec3 HullLight::shifted(const glm::dvec3& radiance, double wavelength_ratio) const {
    return colour_.matrix(mode_, std::log(std::clamp(wavelength_ratio, 1e-4, 1e4))) * radiance;
}

glm::dvec3 HullLight::seen(const HullPoint& point) const {
    const glm::dvec3 normal(point.normal);
    const glm::dvec3 reflectance(point.reflectance);
    glm::dvec3 light = shifted(glm::dvec3(point.emission) + reflectance * (own_light * (0.6 + 0.4 * normal.y)),
                               point.wavelength_ratio);
    if (reflectance == glm::dvec3(0.0)) {
        return light;
    }
    if (scene_.sun) {
        const glm::dvec3 towards(glm::normalize(scene_.sun->direction));
        const sim::FourVector<sim::Vehicle> photon =
            sim::inverse(point.world_from_vehicle) * sim::FourVector<sim::World>{1.0, -towards};
        const double cosine = -glm::dot(normal, photon.space) / photon.t;
        if (cosine > 0.0) {
            const double ratio = 1.0 / photon.t;
            const bool brightens = mode_ == Mode::full || mode_ == Mode::searchlight;
            const double share = cosine * std::numbers::inv_pi * (brightens ? ratio * ratio : 1.0);
            light += shifted(share * reflectance * glm::dvec3(scene_.sun->irradiance), ratio * point.wavelength_ratio);
        }
    }
    if (scene_.ambient != glm::vec3(0.0f)) {
        const sim::FourVector<sim::World> photon =
            point.world_from_vehicle * sim::FourVector<sim::Vehicle>{1.0, -normal};
        const double share = surface_shader::ambient_share(static_cast<float>(-photon.space.y / photon.t));
        light += shifted(share * reflectance * glm::dvec3(scene_.ambient), photon.t * point.wavelength_ratio);
    }
    return light;
}

} // namespace render
