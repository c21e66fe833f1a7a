#pragma once

#include "sim/state_fields.h"

#include <array>
#include <span>

/// A state as plain numbers, to keep and to go on from.
namespace sim {

/// Values of all state_fields, in the table's order; names and units are there.
using Snapshot = std::array<double, state_fields.size()>;

Snapshot snapshot(const VehicleState& state);

/// The state a snapshot was taken of; the tick must be a whole number >= 0. Going on from it equals going straight on,
/// bit for bit.
VehicleState restore(std::span<const double, state_fields.size()> values);

} // namespace sim
