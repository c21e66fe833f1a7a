#pragma once

#include "render/cabin/cabin_light.h"
#include "render/cabin/surroundings.h"
#include "render/gl/renderer.h"

#include <vector>

namespace engine {

/// What is seen all around the ship, gathered by a few small pictures a frame. It is kept in the boosted frame, which a
/// turn of the ship does not change: the light stays where it comes from while the cabin turns.
class SceneryLight {
  public:
    /// Small pictures taken in a frame.
    static constexpr int views_a_frame = 2;

    /// Takes further small pictures; the first time all of them, so that no flight begins in the dark.
    void look_around(render::Renderer& renderer, const render::RenderFrame& frame, const sim::BoostAndRotation& vehicle,
                     double exposure_stops);

    /// The light in a cabin as it is turned now: what moves as the ship, and its boosted_from_head is the cabin's.
    render::LightFromAround in_cabin(const sim::BoostAndRotation& cabin) const;

  private:
    std::vector<render::SurroundingsView> views_; ///< of the round that is being taken
    sim::BoostAndRotation motion_;                ///< when it began
    std::size_t taken_ = 0;
    std::vector<render::SeenLightSample> gathering_;
    std::vector<render::SeenLightSample> newer_; ///< the last whole round
    std::vector<render::SeenLightSample> older_; ///< the one before it, which fades as the next is taken
};

} // namespace engine
