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

inline constexpr std::string_view unit_clock = "clock unit";
inline constexpr std::string_view unit_length = "light clock unit";
inline constexpr std::string_view unit_acceleration = "c/clock unit";
inline constexpr std::string_view unit_turn_rate = "rad/clock unit";

inline constexpr std::array state_fields{
    StateField{"tick", "1", "whole fixed steps since the start",
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
    StateField{"spin_a_re", "1", "world_from_vehicle in SL(2,C), row 1 column 1, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.a.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.a.re = v; }},
    StateField{"spin_a_im", "1", "world_from_vehicle in SL(2,C), row 1 column 1, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.a.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.a.im = v; }},
    StateField{"spin_b_re", "1", "world_from_vehicle in SL(2,C), row 1 column 2, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.b.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.b.re = v; }},
    StateField{"spin_b_im", "1", "world_from_vehicle in SL(2,C), row 1 column 2, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.b.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.b.im = v; }},
    StateField{"spin_c_re", "1", "world_from_vehicle in SL(2,C), row 2 column 1, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.c.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.c.re = v; }},
    StateField{"spin_c_im", "1", "world_from_vehicle in SL(2,C), row 2 column 1, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.c.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.c.im = v; }},
    StateField{"spin_d_re", "1", "world_from_vehicle in SL(2,C), row 2 column 2, real part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.d.re; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.d.re = v; }},
    StateField{"spin_d_im", "1", "world_from_vehicle in SL(2,C), row 2 column 2, imaginary part",
               [](const VehicleState& s) { return s.world_from_vehicle.spin.d.im; },
               [](VehicleState& s, double v) { s.world_from_vehicle.spin.d.im = v; }},
    StateField{"spin_remainder_a_re", "1", "beyond spin_a_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.a.re; },
               [](VehicleState& s, double v) { s.spin_remainder.a.re = v; }},
    StateField{"spin_remainder_a_im", "1", "beyond spin_a_im: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.a.im; },
               [](VehicleState& s, double v) { s.spin_remainder.a.im = v; }},
    StateField{"spin_remainder_b_re", "1", "beyond spin_b_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.b.re; },
               [](VehicleState& s, double v) { s.spin_remainder.b.re = v; }},
    StateField{"spin_remainder_b_im", "1", "beyond spin_b_im: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.b.im; },
               [](VehicleState& s, double v) { s.spin_remainder.b.im = v; }},
    StateField{"spin_remainder_c_re", "1", "beyond spin_c_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.c.re; },
               [](VehicleState& s, double v) { s.spin_remainder.c.re = v; }},
    StateField{"spin_remainder_c_im", "1", "beyond spin_c_im: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.c.im; },
               [](VehicleState& s, double v) { s.spin_remainder.c.im = v; }},
    StateField{"spin_remainder_d_re", "1", "beyond spin_d_re: the entry is their sum",
               [](const VehicleState& s) { return s.spin_remainder.d.re; },
               [](VehicleState& s, double v) { s.spin_remainder.d.re = v; }},
    StateField{"spin_remainder_d_im", "1", "beyond spin_d_im: the entry is their sum",
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
};

static_assert(sizeof(VehicleState) == 8 * state_fields.size(), "every scalar of VehicleState has its row in the table");

} // namespace sim
