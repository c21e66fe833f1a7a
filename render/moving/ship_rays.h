#pragma once

#include "content/scene_desc.h"
#include "render/colour/doppler_colour.h"
#include "render/moving/hull_light.h"
#include "render/offline/scenery_hits.h"
#include "render/render_frame.h"
#include "sim/ship_world_line.h"

#include <memory>
#include <optional>
#include <vector>

namespace render {

/// Where a ray meets a ship.
struct ShipHit {
    double distance = 0.0;         ///< scene metres from the eye, in the world frame at the eye's event
    std::size_t object = 0;        ///< for Layer::object
    double wavelength_ratio = 1.0; ///< D, ship to eye
    glm::dvec3 radiance{0.0};      ///< as the eye sees it
};

/// The truth for SeenShip, by another route: each ray goes back through spacetime into the ship's own rest frame and
/// meets the rigid body there. The event at the distance s along the ray belongs to the moment tau of the ship at which
/// it lies in the ship's present, (P(s) - x(tau)).u(tau) = 0; its place in the ship is what is left in vehicle axes.
/// For a coasting ship that is a straight line, under thrust a chord of 1/32 of the way through the ship.
class ShipRays {
  public:
    /// Keeps references: all must outlive this. `colour`: of the scene.
    ShipRays(const RenderFrame& frame, const Surroundings& surroundings, const DopplerColour& colour);

    /// The first ship along the unit `direction` of the world from the frame's eye.
    std::optional<ShipHit> first(const glm::dvec3& direction) const;

  private:
    struct Body;
    struct Crossing;
    std::optional<Crossing> crossing(const Body& ship, const glm::dvec3& direction) const;
    ShipHit hit_of(const Body& ship, const Crossing& crossing, const glm::dvec3& direction) const;

    const RenderFrame& frame_;
    HullLight hull_;
    sim::Event eye_;
    sim::FourVector<sim::World> eye_velocity_;
    std::vector<std::shared_ptr<const Body>> ships_;
};

} // namespace render
