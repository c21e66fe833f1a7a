#pragma once

#include "render/moving/seen_ships.h"
#include "render/offline/scenery_hits.h"

#include <memory>
#include <vector>

namespace render {

/// What a packet's rays see of ships.
struct PacketShips {
    LaneMask seen = 0; ///< lanes in which a ship is before the scenery
    Lanes distance;
    Lanes3 radiance;
    Lanes wavelength_ratio;
    Lanes object;
};

/// The seen shapes of a frame's ships, ready for packets of rays from the eye.
class ShipHits {
  public:
    /// Keeps the ships. Throws sim::BadInput for what Embree cannot hold.
    explicit ShipHits(std::vector<SeenShip> ships);
    ~ShipHits();
    ShipHits(ShipHits&&) noexcept;
    ShipHits& operator=(ShipHits&&) noexcept;
    ShipHits(const ShipHits&) = delete;
    ShipHits& operator=(const ShipHits&) = delete;

    /// Ships nearer than `limit` along unit directions of the world; nothing is written of lanes that see none.
    void first(const Lanes3& directions, const Lanes& limit, PacketShips& found) const;

  private:
    class Embree;
    std::unique_ptr<Embree> embree_;
};

} // namespace render
