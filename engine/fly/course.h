#pragma once

#include "content/destination.h"
#include "content/scenario.h"
#include "engine/flight.h"
#include "engine/fly/fly_options.h"
#include "input/pilot.h"

#include <memory>
#include <optional>
#include <string>

namespace engine {

/// Who flies, and for how many clock units of ship time.
struct Course {
    std::unique_ptr<input::Pilot> pilot;
    double duration = 0.0;
    std::optional<content::Destination> target; ///< of the autopilot
};

/// Checks how a course was asked for: `seconds` as it was typed, "" for all. Throws sim::BadInput naming the option.
void check_course(FlyOptions& options, const std::string& seconds);

/// The course that was asked for: to a destination by autopilot, by a script, or the scenario's demonstration, for at
/// most options.seconds. Throws sim::BadInput.
Course course_of(const content::Scenario& scenario, const FlyOptions& options);

/// Flies at most `ticks` ticks; false once the pilot has come to the end.
bool fly_ticks(Flight& flight, input::Pilot& pilot, sim::Tick ticks);

/// Flies the course from where the flight is to its last tick.
void fly_to_the_end(Flight& flight, const Course& course);

} // namespace engine
