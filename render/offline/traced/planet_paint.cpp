#include "render/offline/traced/planet_paint.h"

#include "render/offline/traced/noise.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace render {
namespace {

double smoothstep(double low, double high, double x) {
    const double t = glm::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

glm::dvec3 land(double height, double latitude, double dryness) {
    const glm::dvec3 forest(0.035, 0.075, 0.02);
    const glm::dvec3 desert(0.42, 0.30, 0.16);
    const glm::dvec3 rock(0.20, 0.17, 0.14);
    const double dry = smoothstep(-0.15, 0.25, dryness + 0.25 * std::cos(5.0 * latitude));
    return glm::mix(glm::mix(forest, desert, dry), rock, smoothstep(0.12, 0.3, height));
}

} // namespace

glm::dvec3 planet_reflectance(const glm::dvec3& direction) {
    const double latitude = std::asin(glm::clamp(direction.z, -1.0, 1.0));
    const glm::dvec3 swirl(fractal_noise(1.5 * direction, 3, 11), fractal_noise(1.5 * direction, 3, 23),
                           fractal_noise(1.5 * direction, 3, 37));
    const double height = fractal_noise(1.7 * direction + 0.6 * swirl, 8, 101) - 0.02;
    const double shore = smoothstep(-0.01, 0.01, height);
    const glm::dvec3 sea =
        glm::mix(glm::dvec3(0.008, 0.03, 0.09), glm::dvec3(0.02, 0.11, 0.16), smoothstep(-0.12, 0.0, height));
    glm::dvec3 ground = glm::mix(sea, land(height, latitude, fractal_noise(3.0 * direction, 4, 211)), shore);
    const double cold =
        std::abs(latitude) + 0.25 * fractal_noise(4.0 * direction, 5, 307) + 0.4 * std::max(0.0, height);
    ground = glm::mix(ground, glm::dvec3(0.75, 0.8, 0.85), smoothstep(1.12, 1.22, cold));
    const glm::dvec3 stretched(direction.x, direction.y, 2.2 * direction.z);
    const double cloud = fractal_noise(2.6 * stretched + 1.3 * swirl, 7, 401);
    return glm::mix(ground, glm::dvec3(0.82), 0.9 * smoothstep(0.03, 0.32, cloud));
}

} // namespace render
