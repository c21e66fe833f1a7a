#pragma once

#include "sim/vehicle.h"

#include <array>
#include <string_view>

/// The one list of what makes up a VehicleState. Hash, snapshot, recording columns and inspectors all read it, so a
/// field added here is added everywhere.
namespace sim {

/// One scalar of the state, as a double. The tick, an integer, is exact as a double up to 2^53 (a million years at
/// 240 Hz).
struct StateField {
    std::string_view name; ///< identifier, fit for a column
    std::string_view unit;
    std::string_view doc;
    double (*get)(const VehicleState&);
    void (*set)(VehicleState&, double);
};

inline constexpr std::string_view unit_none = "1"; ///< a pure number
inline constexpr std::string_view unit_clock = "clock unit";
inline constexpr std::string_view unit_length = "light clock unit";
inline constexpr std::string_view unit_acceleration = "c/clock unit";
inline constexpr std::string_view unit_turn_rate = "rad/clock unit";

inline constexpr std::array state_fields{
    StateField{"tick", unit_none, "whole fixed steps since the start",
               [](const VehicleState& s) { return static_cast<double>(s.tick); },
               [](VehicleState& s, double v) { s.tick = static_cast<Tick>(v); }},
    StateField{"ship_clock", unit_clock, "proper time tau since the start",
               [](const VehicleState& s) { return s.ship_clock.value; },
               [](VehicleState& s, double v) { s.ship_clock.value = v; }},
    StateField{"event_t", unit_clock, "world time of the ship", [](const VehicleState& s) { return s.event.t; },
               [](VehicleState& s, double v) { s.event.t = v; }},
    StateField{"event_x", unit_length, "position in the world, x",
               [](const VehicleState& s) { return s.event.space.x; },
               [](VehicleState& s, double v) { s.event.space.x = v; }},
    StateField{"event_y", unit_length, "position in the world, y",
               [](const VehicleState& s) { return s.event.space.y; },
               [](VehicleState& s, double v) { s.event.space.y = v; }},
    StateField{"event_z", unit_length, "position in the world, z",
               [](const VehicleState& s) { return s.event.space.z; },
               [](VehicleState& s, double v) { s.event.space.z = v; }},
    StateField{"event_offset_t", unit_clock, "world time beyond event_t: the time is their sum",
               [](const VehicleState& s) { return s.event_offset.t; },
               [](VehicleState& s, double v) { s.event_offset.t = v; }},
    StateField{"event_offset_x", unit_length, "position beyond event_x: it is their sum",
               [](const VehicleState& s) { return s.event_offset.space.x; },
               [](VehicleState& s, double v) { s.event_offset.space.x = v; }},
    StateField{"event_offset_y", unit_length, "position beyond event_y: it is their sum",
               [](const VehicleState& s) { return s.event_offset.space.y; },
               [](VehicleState& s, double v) { s.event_offset.space.y = v; }},
    StateField{"event_offset_z", unit_length, "position beyond event_z: it is their sum",
               [](const VehicleState& s) { return s.event_offset.space.z; },
               [](VehicleState& s, double v) { s.event_offset.space.z = v; }},
    StateField{"spin_a_re", unit_none, "world_from_vehicle in SL(2,C), row 1 column 1, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.a.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.a.re = v; }},
    StateField{"spin_a_im", unit_none, "world_from_vehicle in SL(2,C), row 1 column 1, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.a.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.a.im = v; }},
    StateField{"spin_b_re", unit_none, "world_from_vehicle in SL(2,C), row 1 column 2, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.b.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.b.re = v; }},
    StateField{"spin_b_im", unit_none, "world_from_vehicle in SL(2,C), row 1 column 2, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.b.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.b.im = v; }},
    StateField{"spin_c_re", unit_none, "world_from_vehicle in SL(2,C), row 2 column 1, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.c.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.c.re = v; }},
    StateField{"spin_c_im", unit_none, "world_from_vehicle in SL(2,C), row 2 column 1, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.c.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.c.im = v; }},
    StateField{"spin_d_re", unit_none, "world_from_vehicle in SL(2,C), row 2 column 2, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.d.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.d.re = v; }},
    StateField{"spin_d_im", unit_none, "world_from_vehicle in SL(2,C), row 2 column 2, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.d.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.d.im = v; }},
    StateField{"spin_remainder_a_re", unit_none, "beyond spin_a_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.a.re; },
               [](VehicleState& s, double v) { s.spin_remainder.a.re = v; }},
    StateField{"spin_remainder_a_im", unit_none, "beyond spin_a_im: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.a.im; },
               [](VehicleState& s, double v) { s.spin_remainder.a.im = v; }},
    StateField{"spin_remainder_b_re", unit_none, "beyond spin_b_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.b.re; },
               [](VehicleState& s, double v) { s.spin_remainder.b.re = v; }},
    StateField{"spin_remainder_b_im", unit_none, "beyond spin_b_im: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.b.im; },
               [](VehicleState& s, double v) { s.spin_remainder.b.im = v; }},
    StateField{"spin_remainder_c_re", unit_none, "beyond spin_c_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.c.re; },
               [](VehicleState& s, double v) { s.spin_remainder.c.re = v; }},
    StateField{"spin_remainder_c_im", unit_none, "beyond spin_c_im: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.c.im; },
               [](VehicleState& s, double v) { s.spin_remainder.c.im = v; }},
    StateField{"spin_remainder_d_re", unit_none, "beyond spin_d_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.d.re; },
               [](VehicleState& s, double v) { s.spin_remainder.d.re = v; }},
    StateField{"spin_remainder_d_im", unit_none, "beyond spin_d_im: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.d.im; },
               [](VehicleState& s, double v) { s.spin_remainder.d.im = v; }},
    StateField{"felt_acceleration_x", unit_acceleration, "proper acceleration during the last tick, towards right",
               [](const VehicleState& s) { return s.felt_acceleration.x; },
               [](VehicleState& s, double v) { s.felt_acceleration.x = v; }},
    StateField{"felt_acceleration_y", unit_acceleration, "proper acceleration during the last tick, towards up",
               [](const VehicleState& s) { return s.felt_acceleration.y; },
               [](VehicleState& s, double v) { s.felt_acceleration.y = v; }},
    StateField{"felt_acceleration_z", unit_acceleration, "proper acceleration during the last tick, towards back",
               [](const VehicleState& s) { return s.felt_acceleration.z; },
               [](VehicleState& s, double v) { s.felt_acceleration.z = v; }},
    StateField{"angular_velocity_x", unit_turn_rate, "turn rate during the last tick about the axis towards right",
               [](const VehicleState& s) { return s.angular_velocity.x; },
               [](VehicleState& s, double v) { s.angular_velocity.x = v; }},
    StateField{"angular_velocity_y", unit_turn_rate, "turn rate during the last tick about the axis towards up",
               [](const VehicleState& s) { return s.angular_velocity.y; },
               [](VehicleState& s, double v) { s.angular_velocity.y = v; }},
    StateField{"angular_velocity_z", unit_turn_rate, "turn rate during the last tick about the axis towards back",
               [](const VehicleState& s) { return s.angular_velocity.z; },
               [](VehicleState& s, double v) { s.angular_velocity.z = v; }},
    StateField{"rapidity_spent", unit_none, "integral of the felt acceleration over the ship's clock",
               [](const VehicleState& s) { return s.rapidity_spent.value; },
               [](VehicleState& s, double v) { s.rapidity_spent.value = v; }},
    StateField{"target_x", unit_length, "where the target is at world time 0, x",
               [](const VehicleState& s) { return s.guidance.target.position_at_zero.x; },
               [](VehicleState& s, double v) { s.guidance.target.position_at_zero.x = v; }},
    StateField{"target_y", unit_length, "where the target is at world time 0, y",
               [](const VehicleState& s) { return s.guidance.target.position_at_zero.y; },
               [](VehicleState& s, double v) { s.guidance.target.position_at_zero.y = v; }},
    StateField{"target_z", unit_length, "where the target is at world time 0, z",
               [](const VehicleState& s) { return s.guidance.target.position_at_zero.z; },
               [](VehicleState& s, double v) { s.guidance.target.position_at_zero.z = v; }},
    StateField{"target_velocity_x", "c", "the target's velocity in the world, x",
               [](const VehicleState& s) { return s.guidance.target.velocity.x; },
               [](VehicleState& s, double v) { s.guidance.target.velocity.x = v; }},
    StateField{"target_velocity_y", "c", "the target's velocity in the world, y",
               [](const VehicleState& s) { return s.guidance.target.velocity.y; },
               [](VehicleState& s, double v) { s.guidance.target.velocity.y = v; }},
    StateField{"target_velocity_z", "c", "the target's velocity in the world, z",
               [](const VehicleState& s) { return s.guidance.target.velocity.z; },
               [](VehicleState& s, double v) { s.guidance.target.velocity.z = v; }},
    StateField{"has_target", unit_none, "1 when a target is chosen",
               [](const VehicleState& s) { return static_cast<double>(s.guidance.has_target); },
               [](VehicleState& s, double v) { s.guidance.has_target = static_cast<std::uint64_t>(v); }},
    StateField{"cruise_rapidity", unit_none, "what the cruise assist holds",
               [](const VehicleState& s) { return s.guidance.cruise.value; },
               [](VehicleState& s, double v) { s.guidance.cruise.value = v; }},
    StateField{"autopilot_phase", unit_none,
               "0 off, 1 stopping, 2 accelerating, 3 coasting, 4 braking, 5 arrived, "
               "6 no target, 7 no propellant",
               [](const VehicleState& s) { return static_cast<double>(s.guidance.phase); },
               [](VehicleState& s, double v) {
                   s.guidance.phase = static_cast<AutopilotPhase>(static_cast<std::uint64_t>(v));
               }},
    StateField{"autopilot_peak_x", unit_none, "gamma beta at the end of the autopilot's first burn, x",
               [](const VehicleState& s) { return s.guidance.peak.x; },
               [](VehicleState& s, double v) { s.guidance.peak.x = v; }},
    StateField{"autopilot_peak_y", unit_none, "gamma beta at the end of the autopilot's first burn, y",
               [](const VehicleState& s) { return s.guidance.peak.y; },
               [](VehicleState& s, double v) { s.guidance.peak.y = v; }},
    StateField{"autopilot_peak_z", unit_none, "gamma beta at the end of the autopilot's first burn, z",
               [](const VehicleState& s) { return s.guidance.peak.z; },
               [](VehicleState& s, double v) { s.guidance.peak.z = v; }},
    StateField{"autopilot_wait", unit_none, "ticks to come before the first burn",
               [](const VehicleState& s) { return s.guidance.schedule.wait; },
               [](VehicleState& s, double v) { s.guidance.schedule.wait = v; }},
    StateField{"autopilot_first", unit_none, "ticks to come of the first burn",
               [](const VehicleState& s) { return s.guidance.schedule.first; },
               [](VehicleState& s, double v) { s.guidance.schedule.first = v; }},
    StateField{"autopilot_coast", unit_none, "ticks to come between the burns",
               [](const VehicleState& s) { return s.guidance.schedule.coast; },
               [](VehicleState& s, double v) { s.guidance.schedule.coast = v; }},
    StateField{"autopilot_second", unit_none, "ticks to come of the second burn",
               [](const VehicleState& s) { return s.guidance.schedule.second; },
               [](VehicleState& s, double v) { s.guidance.schedule.second = v; }},
};

static_assert(sizeof(VehicleState) == 8 * state_fields.size(), "every scalar of VehicleState has its row in the table");

} // namespace sim
