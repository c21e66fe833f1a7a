#pragma once

#include "content/traced/traced_scenario.h"
#include "render/colour/scene_colour.h"
#include "render/offline/rest_light.h"
#include "render/offline/traced/inertial_piece.h"
#include "sim/spacetime/sky_rays.h"

#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace render {

/// Where a ray meets an object, and the light that leaves it there towards the ray, as the object's own observers have
/// it.
struct ObjectHit {
    double s = 1.0;                      ///< on the RayCurve
    std::size_t object = 0;              ///< index: spheres first, then models
    glm::dvec3 coordinate_velocity{0.0}; ///< of the object, chart, c = 1
    RestLight light;                     ///< reflected and emitted, by the spectral terms of the object's SceneColour
    double temperature = 0.0;            ///< kelvin, of a black body besides; 0: none
};

/// Spheres and glTF models in a curved spacetime, met by pieces of bent rays.
class TracedObjects {
  public:
    /// Loads models and textures. Throws sim::BadInput.
    TracedObjects(const content::TracedScenario& scenario, std::vector<std::string>& notes);
    ~TracedObjects();
    TracedObjects(TracedObjects&&) noexcept;
    TracedObjects& operator=(TracedObjects&&) noexcept;
    TracedObjects(const TracedObjects&) = delete;
    TracedObjects& operator=(const TracedObjects&) = delete;

    bool empty() const;
    /// Balls that hold all of them, wherever and whenever they are.
    std::vector<sim::WatchedBall> bounds() const;
    /// Balls that hold those that move, or are here or there by the time.
    const std::vector<sim::WatchedBall>& moving_bounds() const { return moving_bounds_; }
    /// Whether a piece of ray without time may meet one of those: comes into its ball, wherever on its line that is.
    bool may_meet_moving(const RayCurve& curve) const;
    /// The first object along the piece of ray; of a piece without time the first of those at rest.
    std::optional<ObjectHit> first(const RayCurve& curve) const;
    /// What the eye sees of a hit's light at D, a black body's left out: linear sRGB, with every effect.
    glm::dvec3 seen(const ObjectHit& hit, double wavelength_ratio) const;
    /// Whether the chart's point lies within an object at that event.
    bool covers(const glm::dvec4& event) const;

  private:
    class Sphere;
    class Model;
    std::optional<SceneColour> sphere_colour_; ///< set where there are spheres
    std::vector<Sphere> spheres_;
    std::vector<Model> models_;
    std::vector<sim::WatchedBall> moving_bounds_;
};

} // namespace render
