#pragma once

#include "sim/vehicle.h"

#include <cstddef>
#include <cstdint>
#include <span>

/// One number that two flights share exactly when they are in the same state.
namespace sim {

/// 64-bit FNV-1a over the bits of every state field in the table's order, least significant byte first, so the value is
/// the same on every machine. Minus zero counts as zero: databases do not keep its sign, and no step depends on it.
std::uint64_t state_hash(const VehicleState& state);

/// The same over some of the fields, numbered as in sim::state_fields: of a state that was hashed when there were
/// fewer.
std::uint64_t state_hash(const VehicleState& state, std::span<const std::size_t> fields);

} // namespace sim
