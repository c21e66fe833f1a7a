#pragma once

#include "content/destination.h"
#include "engine/flight.h"
#include "engine/hud/navigation_reading.h"
#include "sim/trip.h"

#include <optional>
#include <string>
#include <vector>

namespace engine {

/// Where a flight can go: the scenario's destinations, which of them is its target, and what is seen of them.
class Navigation {
  public:
    /// Throws sim::BadInput when the stars' names cannot be read.
    explicit Navigation(const content::Scenario& scenario);

    const std::vector<content::Destination>& destinations() const { return destinations_; }
    /// The flight's target among them; none when it has none, or one from elsewhere.
    std::optional<std::size_t> target(const Flight& flight) const;

    void choose(Flight& flight, std::size_t destination) const;
    /// The one after the present target; false when there is nowhere to go.
    bool choose_next(Flight& flight) const;
    /// The one that is seen nearest to a direction of the head's axes.
    bool choose_in_view(Flight& flight, const sim::VehicleState& moment, const glm::dquat& vehicle_from_head,
                        const glm::dvec3& look) const;
    /// Places of the new scale, after Flight::set_speed_of_light: a star stays as many light-years away.
    void rescale(Flight& flight);

    /// What the instruments show of the ship at a moment, with a head in it.
    NavigationReading read(const Flight& flight, const sim::VehicleState& moment,
                           const glm::dquat& vehicle_from_head) const;

  private:
    content::Scenario scenario_;
    std::vector<content::Destination> destinations_;
};

/// "12.3 yr of ship time, 45.6 yr of world time, gamma 7.8 at most", or why there is no trip.
std::string forecast_text(const sim::TripForecast& plan, const std::string& clock_unit);

/// Why there is no trip, with value and range; "" when there is one.
std::string problem_text(const sim::TripForecast& plan, const sim::VehicleSettings& vehicle,
                         const std::string& clock_unit);

} // namespace engine
