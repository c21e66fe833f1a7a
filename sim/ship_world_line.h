#pragma once

#include "sim/vehicle.h"

#include <cstddef>
#include <vector>

/// A ship's world line as it was flown, and what is seen of the ship: where the world line of each of its points meets
/// an eye's past light cone (PHYSICS 6). The ship is rigid in its instantaneous rest frame: the point r (vehicle axes)
/// of the moment tau is at x(tau) + Lambda(tau) (0, r), with the four-velocity u (1 + a.r) + e_i (w x r)^i, normalised:
/// the points ahead of a thrusting ship age faster than those behind. This holds while 1 + a.r > 0.
namespace sim {

/// A ship at one moment.
struct WorldLinePoint {
    ProperTime ship_clock;
    Event event;
    Lorentz<World, Vehicle> world_from_vehicle;
    Drive drive;                  ///< from there on
    glm::dvec3 thrust_spent{0.0}; ///< integral of the proper acceleration over the ship's clock, vehicle axes
};

/// Four-velocity of the point `in_vehicle` (vehicle axes, light clock units) of a ship at a moment.
FourVector<World> velocity_of(const WorldLinePoint& ship, const glm::dvec3& in_vehicle);

/// A point of a ship as an eye sees it.
struct SeenShipPoint {
    WorldLinePoint ship;         ///< when the light left it, by the ship's clock
    Event event;                 ///< where and when that was, world
    FourVector<World> velocity;  ///< of the point
    Direction<World> from;       ///< where the light comes from; arbitrary when the point is at the eye
    double wavelength_ratio = 1; ///< lambda_world / lambda_point along the ray
};

/// A flight as pieces of constant thrust and turn, each in closed form (exact_step.h). A piece lasts as long as it
/// gives the flown states back to 1e-12 of themselves, so a coasting ship costs one piece, a tumbling one a piece for
/// each tick. Before its start and after its end the ship coasts: at rest if it was at rest there.
class ShipWorldLine {
  public:
    /// Begins with a ship that has coasted for ever.
    explicit ShipWorldLine(const VehicleState& start);

    /// Goes on to a later state; the drive since the last is the one that it says. A state of the last one's time or
    /// of an earlier one changes nothing.
    void extend(const VehicleState& after);

    ProperTime first() const { return pieces_.front().ship_clock; } ///< of what was flown
    ProperTime last() const { return last_.ship_clock; }
    std::size_t pieces() const { return pieces_.size(); }

    /// The ship at a moment of its own clock, of any time.
    WorldLinePoint at(ProperTime ship_clock) const;
    /// What the ship's clock shows at a moment of the world's, in the world frame.
    ProperTime at_world_time(CoordinateTime world_clock) const;
    /// The point `in_vehicle` (vehicle axes, light clock units) as seen at the event `eye`.
    SeenShipPoint seen(const glm::dvec3& in_vehicle, const Event& eye) const;

  private:
    const WorldLinePoint& base_of(ProperTime ship_clock) const;

    template <class Rising>
    ProperTime root_of(const Rising& rising) const;

    std::vector<WorldLinePoint> pieces_; ///< where each begins
    WorldLinePoint last_;                ///< its drive is none
};

} // namespace sim
