#include "engine/fly/flight_summary.h"

#include "engine/hud/readouts.h"

#include <fmt/core.h>

namespace engine {

void print_flight(const content::Scenario& scenario, const sim::VehicleState& end) {
    const sim::Readings now = sim::readings(end);
    fmt::print("flew {}: {} ticks, {} of ship time, {} of world time; beta {}, rapidity {:.4f} at the end\n",
               scenario.name, end.tick, clock_text(end.ship_clock.value, scenario.clock_unit_name),
               clock_text(end.event.t, scenario.clock_unit_name), beta_text(now), now.rapidity.value);
}

} // namespace engine
