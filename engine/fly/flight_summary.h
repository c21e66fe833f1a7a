#pragma once

#include "content/scenario.h"
#include "engine/flight.h"

namespace engine {

/// Prints how a flight ended (ticks, both clocks, speed) and what happened in it.
void print_flight(const content::Scenario& scenario, const Flight& flight);

} // namespace engine
