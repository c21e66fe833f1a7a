#pragma once

#include "sim/vehicle.h"

#include <cstdint>

/// One number that two flights share exactly when they are in the same state.
namespace sim {

/// 64-bit FNV-1a over the bits of every state field in the table's order, least significant byte first, so the value is
/// the same on every machine. Minus zero counts as zero: databases do not keep its sign, and no step depends on it.
std::uint64_t state_hash(const VehicleState& state);

} // namespace sim
