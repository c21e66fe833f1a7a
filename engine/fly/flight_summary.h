#pragma once

#include "content/scenario.h"
#include "sim/vehicle.h"

namespace engine {

/// Prints how a flight ended: ticks, both clocks, speed.
void print_flight(const content::Scenario& scenario, const sim::VehicleState& end);

} // namespace engine
