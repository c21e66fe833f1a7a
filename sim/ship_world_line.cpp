#include "sim/ship_world_line.h"

#include "sim/exact_step.h"
#include "sim/frequency_ratio.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

/// How far the flown states may be from a piece's closed form, relative: RK4's own error at 240 ticks is about that.
constexpr double piece_tolerance = 1e-12;

/// A piece's longest change of rapidity: longer brakings would cancel (exact_step.h).
constexpr double longest_rapidity_change = 0.5;

WorldLinePoint point_of(const VehicleState& state) {
    return {state.ship_clock, state.event + state.event_offset, state.world_from_vehicle, {}, glm::dvec3(0.0)};
}

bool is_coasting(const Drive& drive) {
    return drive.proper_acceleration == glm::dvec3(0.0) && drive.angular_velocity == glm::dvec3(0.0);
}

/// The ship a time after the point, or before it where it coasts.
WorldLinePoint moved(const WorldLinePoint& from, ProperTime by) {
    WorldLinePoint to = from;
    to.ship_clock = from.ship_clock + by;
    to.thrust_spent = from.thrust_spent + by.value * from.drive.proper_acceleration;
    if (is_coasting(from.drive)) {
        to.event = from.event + by.value * four_velocity(from.world_from_vehicle);
    } else if (by.value != 0.0) {
        const Motion motion = exact_motion(from.world_from_vehicle.spin, by, from.drive);
        to.event = from.event + motion.displacement;
        to.world_from_vehicle.spin = from.world_from_vehicle.spin + motion.spin_change;
    }
    return to;
}

bool agree(const WorldLinePoint& a, const WorldLinePoint& b) {
    const Event apart = a.event - b.event;
    const double scale = 1.0 + std::abs(b.event.t) + glm::length(b.event.space);
    const SpinMatrix turned = a.world_from_vehicle.spin - b.world_from_vehicle.spin;
    return std::abs(apart.t) + glm::length(apart.space) <= piece_tolerance * scale &&
           frobenius2(turned) <= piece_tolerance * piece_tolerance * frobenius2(b.world_from_vehicle.spin);
}

/// dx/dtau of a point of the ship, tau the ship's clock.
FourVector<World> rate_of(const WorldLinePoint& ship, const glm::dvec3& in_vehicle) {
    const double ageing = 1.0 + glm::dot(ship.drive.proper_acceleration, in_vehicle);
    return ship.world_from_vehicle * FourVector<Vehicle>{ageing, glm::cross(ship.drive.angular_velocity, in_vehicle)};
}

Event event_of(const WorldLinePoint& ship, const glm::dvec3& in_vehicle) {
    return ship.event + ship.world_from_vehicle * FourVector<Vehicle>{0.0, in_vehicle};
}

/// A function of the ship's clock that rises, with its slope.
struct ValueAndSlope {
    double value;
    double slope;
};

} // namespace

FourVector<World> velocity_of(const WorldLinePoint& ship, const glm::dvec3& in_vehicle) {
    // Normalised in the vehicle, where nothing has grown with the speed.
    const double ageing = 1.0 + glm::dot(ship.drive.proper_acceleration, in_vehicle);
    const glm::dvec3 turning = glm::cross(ship.drive.angular_velocity, in_vehicle);
    const double scale = 1.0 / std::sqrt(ageing * ageing - glm::dot(turning, turning));
    return ship.world_from_vehicle * FourVector<Vehicle>{scale * ageing, scale * turning};
}

ShipWorldLine::ShipWorldLine(const VehicleState& start) : pieces_{point_of(start)}, last_(pieces_.front()) {}

void ShipWorldLine::extend(const VehicleState& after) {
    const WorldLinePoint next = point_of(after);
    const ProperTime since = next.ship_clock - last_.ship_clock;
    if (!(since.value > 0.0)) {
        return;
    }
    const Drive drive{after.felt_acceleration, after.angular_velocity};
    const glm::dvec3 thrust_spent = last_.thrust_spent + since.value * drive.proper_acceleration;
    WorldLinePoint& piece = pieces_.back();
    if (piece.ship_clock == last_.ship_clock) {
        piece.drive = drive;
    } else {
        const ProperTime length = next.ship_clock - piece.ship_clock;
        const bool short_enough =
            length.value * glm::length(piece.drive.proper_acceleration) <= longest_rapidity_change;
        if (!short_enough || !agree(moved(piece, length), next)) {
            last_.drive = drive;
            pieces_.push_back(last_);
        }
    }
    last_ = next;
    last_.thrust_spent = thrust_spent;
}

const WorldLinePoint& ShipWorldLine::base_of(ProperTime ship_clock) const {
    if (ship_clock >= last_.ship_clock) {
        return last_;
    }
    const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), ship_clock,
                                        [](ProperTime t, const WorldLinePoint& piece) { return t < piece.ship_clock; });
    return after == pieces_.begin() ? pieces_.front() : *(after - 1);
}

WorldLinePoint ShipWorldLine::at(ProperTime ship_clock) const {
    WorldLinePoint base = base_of(ship_clock);
    if (ship_clock < first()) {
        base.drive = {};
    }
    return moved(base, ship_clock - base.ship_clock);
}

/// The root of a function that rises along the world line. First the piece, by its ends; then Newton's method, kept
/// between the piece's ends. Where the ship coasts for ever, the functions asked for are convex or straight, and
/// Newton's method needs no ends.
template <class Rising>
ProperTime ShipWorldLine::root_of(const Rising& rising) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = -infinity;
    double high = infinity;
    const auto after = std::partition_point(pieces_.begin(), pieces_.end(),
                                            [&](const WorldLinePoint& piece) { return rising(piece).value < 0.0; });
    WorldLinePoint base = after == pieces_.begin() ? pieces_.front() : *(after - 1);
    if (after == pieces_.begin()) {
        high = 0.0;
        base.drive = {};
    } else if (after == pieces_.end() && rising(last_).value < 0.0) {
        low = 0.0;
        base = last_;
    } else {
        low = 0.0;
        high = (after == pieces_.end() ? last_ : *after).ship_clock.value - base.ship_clock.value;
    }
    double since = std::isinf(low) ? high : low; // the piece's start
    constexpr int most_steps = 100;
    for (int i = 0; i < most_steps; ++i) {
        const ValueAndSlope at = rising(moved(base, ProperTime(since)));
        (at.value < 0.0 ? low : high) = since;
        double next = since - at.value / at.slope;
        if (!(next >= low && next <= high)) {
            next = std::isinf(low) || std::isinf(high) ? since : 0.5 * (low + high);
        }
        const double rounding = 2.0 * std::numeric_limits<double>::epsilon();
        const bool settled = std::abs(next - since) <= rounding * (std::abs(base.ship_clock.value) + std::abs(since));
        since = next;
        if (settled) {
            break;
        }
    }
    return base.ship_clock + ProperTime(since);
}

ProperTime ShipWorldLine::at_world_time(CoordinateTime world_clock) const {
    return root_of([&](const WorldLinePoint& ship) {
        return ValueAndSlope{ship.event.t - world_clock.value, four_velocity(ship.world_from_vehicle).t};
    });
}

SeenShipPoint ShipWorldLine::seen(const glm::dvec3& in_vehicle, const Event& eye) const {
    // Advanced time of the point for the eye: x.t + |x - eye|, which rises along every time-like line.
    const ProperTime clock = root_of([&](const WorldLinePoint& ship) {
        const Event apart = event_of(ship, in_vehicle) - eye;
        const FourVector<World> rate = rate_of(ship, in_vehicle);
        const double distance = glm::length(apart.space);
        const double receding = distance > 0.0 ? glm::dot(apart.space, rate.space) / distance : 0.0;
        return ValueAndSlope{apart.t + distance, rate.t + receding};
    });
    SeenShipPoint seen;
    seen.ship = at(clock);
    seen.event = event_of(seen.ship, in_vehicle);
    seen.velocity = velocity_of(seen.ship, in_vehicle);
    const glm::dvec3 apart = seen.event.space - eye.space;
    const double distance = glm::length(apart);
    if (distance > 0.0) {
        seen.from.unit = apart / distance;
    }
    seen.wavelength_ratio = frequency_ratio(seen.velocity, seen.from);
    return seen;
}

} // namespace sim
