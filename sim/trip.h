#pragma once

#include "sim/quantities.h"
#include "sim/vehicle.h"

#include <glm/vec3.hpp>

#include <optional>

/// Trips of two burns, in closed form. A burn of constant thrust a in a direction that gyroscopes keep takes the
/// four-velocity along a geodesic of the hyperboloid of velocities: from u to v, a rapidity phi apart, it lasts phi / a
/// of ship time and displaces the ship by (u + v) tanh(phi/2) / a. So a trip to rest at a target is one velocity p
/// where the first burn ends: burn u -> p, coast if need be, burn p -> rest; three equations for the three components
/// of p, whatever way the ship moves at first. In the target's rest frame.
namespace sim {

struct TripTask {
    glm::dvec3 way{0.0};       ///< from ship to target, light clock units
    glm::dvec3 velocity{0.0};  ///< gamma beta of the ship
    double acceleration = 1.0; ///< the most of the first burn, c per clock unit; > 0
    double braking = 1.0;      ///< the most of the second; each takes a whole number of ticks
    double tick = 1.0 / 240.0; ///< clock units of ship time; > 0
    double wait = 0.0;         ///< ticks before the first burn
    double coast = 0.0;        ///< ticks between the burns
};

/// The two burns of a trip.
struct Trip {
    glm::dvec3 peak{0.0}; ///< gamma beta where the first burn ends
    Rapidity first;       ///< of the first burn
    Rapidity second;      ///< of the second
    TripSchedule schedule;
    double goal_time = 0; ///< how long all of it takes on the target's clock, clock units

    Rapidity spent() const { return first + second; }
};

/// The trip that takes the fewest whole ticks, by Newton's method. None when that does not converge: no two burns near
/// at hand lead there.
std::optional<Trip> solve_trip(const TripTask& task);

/// The trip with the given ticks, whatever thrust that takes, from `peak` of one that is near it.
std::optional<Trip> solve_trip(const TripTask& task, const TripSchedule& schedule, const glm::dvec3& peak);

/// The rapidity between two four-velocities given by their gamma beta, without cancellation where it is small.
Rapidity relative_rapidity(const glm::dvec3& u, const glm::dvec3& v);

/// Why there is no trip.
enum class TripProblem : std::uint8_t {
    none,
    no_target,
    too_little_propellant, ///< not even enough to come to rest
    too_slow,              ///< the thrust is so small that the trip outlasts longest_trip_ticks
    too_fast,              ///< it passes largest_rapidity
};

inline constexpr double longest_trip_ticks = 1e10;

/// A trip of the autopilot, foretold.
struct TripForecast {
    TripProblem problem = TripProblem::none;
    AutopilotPhase phase = AutopilotPhase::off; ///< that the autopilot begins with
    Trip trip;
    double stopping_ticks = 0.0; ///< of a burn to rest before it all
    ProperTime ship_time;        ///< of the whole
    CoordinateTime world_time;   ///< of the whole
    double peak_gamma = 1.0;     ///< largest in the world
    Rapidity rapidity_spent;     ///< of all burns
    double mass_ratio = 1.0;     ///< mass at departure over mass at arrival
};

/// Foretells the trip that the autopilot would fly from here to guidance.target, with boost held or not.
TripForecast plan_trip(const VehicleState& state, const VehicleSettings& settings, bool boosted = false);

/// The thrust that the autopilot counts on, c per clock unit: the least of the three axes where the ship can thrust as
/// hard to the sides as ahead (a nose may then point anywhere), otherwise that of the axis ahead. 1 where there is no
/// limit.
double trip_acceleration(const VehicleSettings& settings, bool boosted);
/// The ship must turn its nose before it can thrust that way.
bool must_turn_to_thrust(const VehicleSettings& settings);
/// Ship time of a turn by `angle` about the slower of the axes x and y, within rates and their accelerations.
double turn_duration(const VehicleSettings& settings, double angle);

/// Of the thrust, in the first burn: what is left is for the noise of planning it again every tick.
inline constexpr double first_burn_share = 1.0 - 1e-5;
/// Of the thrust, in the second burn: what is left pays for corrections.
double braking_share(const VehicleSettings& settings);

} // namespace sim
