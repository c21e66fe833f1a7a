#include "engine/fly/course.h"

#include "content/flight_script.h"
#include "engine/voyage.h"
#include "input/autopilot_pilot.h"
#include "input/script_pilot.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <cmath>

namespace engine {
namespace {

constexpr double longest_flight_seconds = 86400.0;

/// For a scene that brings no demonstration: look, speed up to 0.9 c, coast turning, and slow down again.
sim::FlightScript plain_demonstration() {
    const auto segment = [](double duration, double ahead, double turn) {
        return sim::FlightSegment{sim::ProperTime(duration), {0.0, 0.0, -ahead}, {0.0, turn, 0.0}};
    };
    return {segment(2.0, 0.0, 0.0), segment(6.0, 0.25, 0.0), segment(2.0, 0.0, 0.0),
            segment(2.0, 0.0, 0.5), segment(2.0, 0.0, -0.5), segment(6.0, -0.25, 0.0)};
}

sim::FlightScript script_to_fly(const content::Scenario& scenario, const FlyOptions& options) {
    if (!options.script.empty()) {
        return content::load_flight_script(options.script);
    }
    return scenario.demonstration.empty() ? plain_demonstration() : content::load_flight_script(scenario.demonstration);
}

} // namespace

void check_course(FlyOptions& options, const std::string& seconds) {
    if (!options.to.empty() && !options.script.empty()) {
        throw sim::BadInput("--to", "", options.to,
                            "and --script contradict each other: a script or the autopilot flies");
    }
    if (!seconds.empty()) {
        options.seconds = number_option("--seconds", seconds, 0.0, longest_flight_seconds);
    }
}

Course course_of(const content::Scenario& scenario, const FlyOptions& options) {
    Course course;
    if (!options.to.empty()) {
        const Voyage voyage = plan_voyage(scenario, {options.to, {}, {}, {}});
        course.target = voyage.destination;
        course.pilot = std::make_unique<input::AutopilotPilot>();
        course.duration = voyage.plan.ship_time.value;
    } else {
        const sim::FlightScript script = script_to_fly(scenario, options);
        for (const sim::FlightSegment& segment : script) {
            course.duration += segment.duration.value;
        }
        course.pilot = std::make_unique<input::ScriptPilot>(script, scenario.vehicle.tick_rate);
    }
    if (options.seconds) {
        course.duration = std::min(course.duration, *options.seconds * scenario.pace);
    }
    return course;
}

bool fly_ticks(Flight& flight, input::Pilot& pilot, sim::Tick ticks) {
    for (sim::Tick i = 0; i < ticks; ++i) {
        if (!flight.tick(pilot)) {
            return false;
        }
    }
    return true;
}

void fly_to_the_end(Flight& flight, const Course& course) {
    const auto last_tick = static_cast<sim::Tick>(std::llround(course.duration * flight.vehicle().tick_rate));
    fly_ticks(flight, *course.pilot, last_tick - std::min(last_tick, flight.state().tick));
}

} // namespace engine
