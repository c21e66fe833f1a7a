#include "engine/recording_diff.h"

#include "engine/recording_format.h"
#include "engine/replay_deck.h"
#include "sim/state_fields.h"
#include "sim/state_hash.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace engine {
namespace {

std::vector<std::string> different_fields(const sim::VehicleState& a, const sim::VehicleState& b) {
    std::vector<std::string> lines;
    for (const sim::StateField& field : sim::state_fields) {
        if (field.get(a) != field.get(b)) {
            const bool counted = field.unit == sim::unit_none; // a number alone
            lines.push_back(fmt::format("{}: {}, {} ({:.3g}{}{})", field.name, field.get(a), field.get(b),
                                        field.get(b) - field.get(a), counted ? "" : " ", counted ? "" : field.unit));
        }
    }
    return lines;
}

/// Rapidity of one ship in the other's frame. From the product of the frames, which does not cancel as the product of
/// four-velocities does.
sim::Rapidity relative_rapidity(const sim::VehicleState& a, const sim::VehicleState& b) {
    const auto a_from_b = sim::inverse(a.world_from_vehicle) * b.world_from_vehicle;
    return sim::split(sim::Lorentz<sim::World, sim::Head>{a_from_b.spin}).xi;
}

} // namespace

RecordingDifference difference(const Recording& a, const Recording& b) {
    ReplayDeck one(a);
    ReplayDeck other(b);
    RecordingDifference result;
    result.length_a = a.end() - a.first_tick();
    result.length_b = b.end() - b.first_tick();
    result.from = std::max(one.first(), other.first());
    result.until = std::max(std::min(one.end(), other.end()), result.from);
    for (sim::Tick tick = result.from; tick <= result.until; ++tick) {
        one.seek(static_cast<double>(tick));
        other.seek(static_cast<double>(tick));
        if (!result.states_part && sim::state_hash(one.state()) != sim::state_hash(other.state())) {
            result.states_part = tick;
            result.fields = different_fields(one.state(), other.state());
        }
        if (!result.demands_part && tick < result.until && !identical(demand_at(a, tick), demand_at(b, tick))) {
            result.demands_part = tick;
        }
        if (result.states_part && result.demands_part) {
            break;
        }
    }
    one.seek(static_cast<double>(result.until));
    other.seek(static_cast<double>(result.until));
    const sim::VehicleState at_a = one.state();
    const sim::VehicleState at_b = other.state();
    const sim::Event apart = sim::displacement(sim::far_event(at_a), sim::far_event(at_b));
    result.separation = glm::length(apart.space);
    result.world_time_difference = (at_b.event.t - at_a.event.t) + (at_b.event_offset.t - at_a.event_offset.t);
    result.relative_rapidity = relative_rapidity(at_a, at_b);
    return result;
}

} // namespace engine
