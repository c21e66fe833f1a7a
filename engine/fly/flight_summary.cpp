#include "engine/fly/flight_summary.h"

#include "engine/hud/readouts.h"
#include "sim/readings.h"

#include <fmt/core.h>

namespace engine {

void print_flight(const content::Scenario& scenario, const Flight& flight) {
    const sim::VehicleState& end = flight.state();
    const sim::Readings now = sim::readings(end);
    const std::string& unit = scenario.clock_unit_name;
    fmt::print("flew {}: {} ticks, {} of ship time, {} of world time; beta {}, rapidity {:.4f} at the end\n",
               scenario.name, end.tick, clock_text(end.ship_clock.value, unit), clock_text(end.event.t, unit),
               beta_text(now), now.rapidity.value);
    for (const sim::FlightEvent& event : flight.events()) {
        fmt::print("  {}: ship {}, world {}\n", sim::event_name(event.kind), clock_text(event.ship_clock.value, unit),
                   clock_text(event.world_clock.value, unit));
    }
}

} // namespace engine
