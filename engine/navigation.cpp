#include "engine/navigation.h"

#include "engine/hud/readouts.h"
#include "sim/approach.h"
#include "sim/autopilot.h"
#include "sim/flight_script.h"
#include "sim/propellant.h"
#include "sim/trip.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace engine {
namespace {

bool same_place(const sim::InertialObject& a, const sim::InertialObject& b) {
    constexpr double rounding = 1e-12; // a change of scale and back
    return glm::distance(a.position_at_zero, b.position_at_zero) <= rounding * glm::length(a.position_at_zero) &&
           a.velocity == b.velocity;
}

std::vector<std::string> assist_lines(const sim::Guidance& guidance, const sim::ControlFrame& control) {
    using sim::ControlFrame;
    const auto on = [&control](std::uint32_t bit) { return control.has(bit); };
    const std::string of_target = on(ControlFrame::about_target) ? " (of the target)" : "";
    std::vector<std::string> lines;
    if (on(ControlFrame::autopilot)) {
        lines.push_back(fmt::format("autopilot: {}", sim::phase_name(guidance.phase)));
    }
    if (on(ControlFrame::brake)) {
        lines.push_back("brake" + of_target);
    }
    if (on(ControlFrame::cruise)) {
        lines.push_back(fmt::format("hold rapidity {:.3f}{}", guidance.cruise.value, of_target));
    }
    if (on(ControlFrame::undamped)) {
        lines.emplace_back("dampers off");
    }
    switch (control.pointing()) {
    case sim::Pointing::hold_heading:
        lines.emplace_back("hold heading");
        break;
    case sim::Pointing::prograde:
        lines.push_back("nose prograde" + of_target);
        break;
    case sim::Pointing::retrograde:
        lines.push_back("nose retrograde" + of_target);
        break;
    case sim::Pointing::target_seen:
        lines.emplace_back("nose to target as seen");
        break;
    case sim::Pointing::target_now:
        lines.emplace_back("nose to target now");
        break;
    default:
        break;
    }
    return lines;
}

} // namespace

std::string problem_text(const sim::TripForecast& plan, const sim::VehicleSettings& vehicle,
                         const std::string& clock_unit) {
    switch (plan.problem) {
    case sim::TripProblem::none:
        return "";
    case sim::TripProblem::no_target:
        return "no target is chosen";
    case sim::TripProblem::too_little_propellant:
        return fmt::format("the propellant is good for a rapidity of {:.4g} in all, which does not even stop the ship "
                           "there: more propellant or a faster exhaust is needed",
                           sim::rapidity_budget(vehicle).value);
    case sim::TripProblem::too_slow:
        return fmt::format("the thrust of {:.3g} c/{} is too small: the trip would take {:.3g} {} of ship time, the "
                           "most is {:.0e} ticks, {:.3g} {}",
                           sim::trip_acceleration(vehicle, false), clock_unit, plan.ship_time.value, clock_unit,
                           sim::longest_trip_ticks, sim::longest_trip_ticks / vehicle.tick_rate, clock_unit);
    case sim::TripProblem::too_fast:
        return fmt::format("the trip would reach rapidity {:.4g}, the most is {:g}", plan.trip.second.value,
                           sim::largest_rapidity.value);
    }
    return "";
}

std::string forecast_text(const sim::TripForecast& plan, const std::string& clock_unit) {
    return fmt::format("ship {}, world {}, gamma up to {:.4g}", clock_text(plan.ship_time.value, clock_unit),
                       clock_text(plan.world_time.value, clock_unit), plan.peak_gamma);
}

Navigation::Navigation(const content::Scenario& scenario)
    : scenario_(scenario), destinations_(content::destinations(scenario, scenario.metres_per_light_unit())) {}

std::optional<std::size_t> Navigation::target(const Flight& flight) const {
    const sim::Guidance& guidance = flight.state().guidance;
    const auto found = std::ranges::find_if(destinations_, [&](const content::Destination& destination) {
        return guidance.has_target != 0 && same_place(destination.object, guidance.target);
    });
    return found == destinations_.end() ? std::nullopt : std::optional(found - destinations_.begin());
}

void Navigation::choose(Flight& flight, std::size_t destination) const {
    flight.set_target(destinations_.at(destination).object, destinations_.at(destination).name);
}

bool Navigation::choose_next(Flight& flight) const {
    if (destinations_.empty()) {
        return false;
    }
    const std::optional<std::size_t> present = target(flight);
    choose(flight, present ? (*present + 1) % destinations_.size() : 0);
    return true;
}

bool Navigation::choose_in_view(Flight& flight, const sim::VehicleState& moment, const glm::dquat& vehicle_from_head,
                                const glm::dvec3& look) const {
    const auto eye = sim::world_from_head(moment.world_from_vehicle, vehicle_from_head);
    std::optional<std::size_t> nearest;
    double closest = -2.0;
    for (std::size_t i = 0; i < destinations_.size(); ++i) {
        const double along = glm::dot(sim::sighting(sim::far_event(moment), eye, destinations_[i].object).seen, look);
        if (along > closest) {
            closest = along;
            nearest = i;
        }
    }
    if (nearest) {
        choose(flight, *nearest);
    }
    return nearest.has_value();
}

void Navigation::rescale(Flight& flight) {
    // Asked before the places change: the flight's target has been scaled as the scenery is.
    const double factor = scenario_.metres_per_light_unit() / flight.metres_per_light_unit();
    std::optional<std::size_t> star;
    for (std::size_t i = 0; i < destinations_.size(); ++i) {
        sim::InertialObject scaled = destinations_[i].object;
        scaled.position_at_zero *= factor;
        if (destinations_[i].is_beacon) {
            destinations_[i].object = scaled;
        } else if (flight.state().guidance.has_target != 0 && same_place(scaled, flight.state().guidance.target)) {
            star = i;
        }
    }
    scenario_.speed_of_light = flight.speed_of_light();
    if (star) {
        choose(flight, *star);
    }
}

NavigationReading Navigation::read(const Flight& flight, const sim::VehicleState& moment,
                                   const glm::dquat& vehicle_from_head) const {
    const auto eye = sim::world_from_head(moment.world_from_vehicle, vehicle_from_head, flight.control().head_velocity);
    const sim::FarEvent here = sim::far_event(moment);
    NavigationReading reading;
    for (const content::Destination& destination : destinations_) {
        if (destination.is_beacon) {
            const sim::Sighting seen = sim::sighting(here, eye, destination.object);
            reading.clocks.push_back(
                {destination.name, seen.clock_seen, seen.clock_now, seen.wavelength_ratio, seen.seen});
        }
    }
    const sim::Guidance& guidance = moment.guidance;
    reading.assists = assist_lines(guidance, flight.control());
    if (guidance.has_target != 0) {
        const std::optional<std::size_t> chosen = target(flight);
        const sim::Sighting seen = sim::sighting(here, eye, guidance.target);
        reading.target = {chosen ? destinations_[*chosen].name : "target", seen.seen, seen.now, seen.distance,
                          seen.wavelength_ratio};
        if (!sim::is_flying(guidance.phase)) {
            const sim::TripForecast plan = sim::plan_trip(moment, flight.vehicle());
            const std::string problem = problem_text(plan, flight.vehicle(), scenario_.clock_unit_name);
            reading.forecast = problem.empty() ? forecast_text(plan, scenario_.clock_unit_name) : problem;
        } else {
            reading.forecast = fmt::format(
                "arrives in {} of ship time",
                clock_text(guidance.schedule.total() / flight.vehicle().tick_rate, scenario_.clock_unit_name));
        }
    }
    reading.has_propellant = std::isfinite(flight.vehicle().propellant);
    if (reading.has_propellant) {
        reading.propellant = sim::propellant_left(flight.vehicle(), moment);
    }
    return reading;
}

} // namespace engine
