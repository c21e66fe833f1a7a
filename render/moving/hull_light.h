#pragma once

#include "content/scene_desc.h"
#include "render/colour/doppler_colour.h"
#include "render/moving/ship_body.h"
#include "sim/lorentz.h"

#include <optional>

namespace render {

/// What of a scene lights the hulls of ships in it.
struct Surroundings {
    explicit Surroundings(const content::SceneDesc& scene)
        : sun(scene.sun), ambient(scene.ambient), instances(scene.instances.size()) {}
    std::optional<content::Sun> sun;
    glm::vec3 ambient;
    std::size_t instances; ///< objects of the scene itself, before the ships
};

/// Where on a hull light leaves, and how fast its eye flees.
struct HullPoint {
    glm::vec3 normal{0.0f, 1.0f, 0.0f}; ///< unit, vehicle axes
    glm::vec3 reflectance{0.0f};
    glm::vec3 emission{0.0f};
    sim::Lorentz<sim::World, sim::Vehicle> world_from_vehicle; ///< when the light left
    double wavelength_ratio = 1.0;                             ///< D = lambda_eye / lambda_point
};

/// Light of a ship as its eye sees it. With M(D) the colour matrix of DopplerColour, D the ratio from the point to the
/// eye, n' the normal in the ship's frame:
///   L = M(D) (emission + reflectance 0.15 (0.6 + 0.4 n'.up'))                        its own lights
///     + D_s^2 M(D_s D) reflectance E_sun/pi max(0, n'.s')                            the sun, aberrated and shifted
///     + M(D_n D) reflectance ambient (0.65 + 0.35 n.y)                               the sky
/// D_s is the ratio of sunlight from the world to the ship; a distant source's irradiance goes by D^-2 (PHYSICS 5). The
/// sky's light is taken as that of the direction n that the surface faces, as the ship sees it. A reflectance keeps its
/// colour under the shift of what falls on it: exact for greys. A hull takes no shadow and throws none.
class HullLight {
  public:
    /// Keeps references: both must outlive this.
    HullLight(const Surroundings& surroundings, const DopplerColour& colour, Mode mode)
        : scene_(surroundings), colour_(colour), mode_(mode) {}

    /// Linear RGB radiance.
    glm::dvec3 seen(const HullPoint& point) const;

  private:
    glm::dvec3 shifted(const glm::dvec3& radiance, double wavelength_ratio) const;

    const Surroundings& scene_;
    const DopplerColour& colour_;
    Mode mode_;
};

} // namespace render
