#include "engine/cameras/cameras.h"

#include "content/generator/generate.h"
#include "render/moving/ship_body.h"
#include "sim/bad_input.h"
#include "sim/look.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace engine {
namespace {

constexpr glm::dvec3 chase_place{0.0, 4.0, 16.0};
/// Beside the way that lies ahead: right, up and back of the pilot, scene metres.
constexpr glm::dvec3 roadside{5.0, 0.5, -30.0};
/// Nearer to a ship's pilot than this an eye is within that ship, and sees none around it.
constexpr double cabin_metres = 1.5;

sim::WorldLinePoint point_of(const sim::VehicleState& state) {
    return {state.ship_clock, state.event, state.world_from_vehicle, {}, glm::dvec3(0.0)};
}

glm::dvec3 roadside_of(const sim::WorldLinePoint& ship, double metres_per_light_unit) {
    // By directions, not lengths, of the ship's axes: those are longer or shorter in the world.
    glm::dvec3 place = ship.event.space * metres_per_light_unit;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 unit(0.0);
        unit[axis] = 1.0;
        place +=
            roadside[axis] * glm::normalize((ship.world_from_vehicle * sim::FourVector<sim::Vehicle>{0.0, unit}).space);
    }
    return place;
}

} // namespace

Cameras::Cameras(const content::Scenario& scenario, CameraSettings settings, std::vector<OtherShip> others)
    : metres_per_light_unit_(scenario.metres_per_light_unit()), settings_(std::move(settings)),
      others_(std::move(others)), body_(std::make_shared<const render::ShipBody>(
                                      render::make_ship_body(content::generator::generate_model("ship")))) {
    if (settings_.kind == CameraKind::twin && !has_twin()) {
        throw sim::BadInput("--camera", "", "twin", "there is no other ship: name a recording, --ghost FILE");
    }
}

void Cameras::choose(CameraKind kind, const sim::VehicleState& moment) {
    settings_ = {};
    settings_.kind = kind;
    if (kind == CameraKind::world) {
        settings_.place = roadside_of(point_of(moment), metres_per_light_unit_);
    }
}

void Cameras::choose_next(const sim::VehicleState& moment) {
    auto next = static_cast<CameraKind>((static_cast<std::size_t>(settings_.kind) + 1) % camera_names.size());
    if (next == CameraKind::twin && !has_twin()) {
        next = CameraKind::pilot;
    }
    choose(next, moment);
}

void Cameras::move(const glm::dvec3& by) {
    if (settings_.kind == CameraKind::free && by != glm::dvec3(0.0)) {
        settings_.place = place_in_ship() + by;
    }
}

glm::dvec3 Cameras::place_in_ship() const {
    return settings_.place.value_or(settings_.kind == CameraKind::chase ? chase_place : glm::dvec3(0.0));
}

bool Cameras::same_light(const Flight& flight) const {
    return flight.metres_per_light_unit() == metres_per_light_unit_;
}

std::vector<Cameras::Shown> Cameras::shown(const Flight& flight) const {
    std::vector<Shown> ships;
    const bool inside =
        is_pilots() || (settings_.kind == CameraKind::free && glm::length(place_in_ship()) < cabin_metres);
    if (!inside && flight.world_line()) {
        ships.push_back({"ship", flight.world_line(), full_thrust(flight.vehicle()), false});
    }
    // Other ships' world lines are in light clock units of the speed of light that they were flown with.
    if (same_light(flight)) {
        const std::size_t first = settings_.kind == CameraKind::twin ? 1 : 0;
        for (std::size_t i = first; i < others_.size(); ++i) {
            ships.push_back({others_[i].name, others_[i].world_line, others_[i].full_thrust, others_[i].is_beacon});
        }
    }
    return ships;
}

Observer Cameras::aboard(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look) const {
    const glm::dvec3 place = place_in_ship() / flight.metres_per_light_unit();
    Observer observer{sim::head_event(moment, place), sim::world_from_head(moment.world_from_vehicle, look),
                      moment.ship_clock.value};
    if (flight.world_line()) {
        observer.clock += glm::dot(place, flight.world_line()->at(moment.ship_clock).thrust_spent);
    }
    return observer;
}

glm::dvec3 Cameras::world_place(const Flight& flight) const {
    if (settings_.place) {
        return *settings_.place;
    }
    return roadside_of(flight.world_line()->at(flight.world_line()->first()), flight.metres_per_light_unit());
}

Observer Cameras::in_the_world(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look) const {
    const glm::dvec3& v = settings_.velocity;
    const double t = moment.event.t;
    Observer observer;
    observer.event = {t, world_place(flight) / flight.metres_per_light_unit() + t * v};
    observer.clock = t * std::sqrt(1.0 - glm::dot(v, v));
    const sim::BoostAndRotation motion = sim::boosted_eye(v);
    glm::dvec3 towards(0.0, 0.0, -1.0);
    if (settings_.look) {
        towards = *settings_.look;
    } else {
        towards =
            sim::where_seen(motion, flight.world_line()->seen(glm::dvec3(0.0), observer.event).from).head_direction;
    }
    const auto frame = sim::world_from_looking<sim::Vehicle>(motion.xi, motion.along, towards);
    observer.world_from_head = sim::world_from_head(frame, look);
    return observer;
}

Observer Cameras::in_twin(const sim::VehicleState& moment, const glm::dquat& look) const {
    const sim::ShipWorldLine& line = *others_.front().world_line;
    const sim::WorldLinePoint twin = line.at(line.at_world_time(sim::CoordinateTime(moment.event.t)));
    return {twin.event, sim::world_from_head(twin.world_from_vehicle, look), twin.ship_clock.value};
}

Observer Cameras::observer(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look) const {
    switch (settings_.kind) {
    case CameraKind::world:
        return in_the_world(flight, moment, look);
    case CameraKind::twin:
        return in_twin(moment, look);
    default:
        return aboard(flight, moment, look);
    }
}

void Cameras::apply(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look,
                    render::RenderFrame& frame) const {
    if (idle()) {
        return;
    }
    frame.moving.metres_per_light_unit = flight.metres_per_light_unit();
    if (is_pilots()) {
        frame.moving.world_time = sim::head_event(moment, flight.control().head_position).t;
    } else {
        const Observer seen_by = observer(flight, moment, look);
        frame.eye.position = seen_by.event.space * flight.metres_per_light_unit();
        frame.eye.world_from_head = seen_by.world_from_head;
        frame.moving.world_time = seen_by.event.t;
    }
    const sim::Event eye{frame.moving.world_time, frame.eye.position / flight.metres_per_light_unit()};
    for (const Shown& ship : shown(flight)) {
        const sim::Event pilot = ship.world_line->seen(glm::dvec3(0.0), eye).event;
        if (glm::length(pilot.space - eye.space) * flight.metres_per_light_unit() >= cabin_metres) {
            frame.moving.ships.push_back({body_, ship.world_line, ship.full_thrust});
        }
    }
}

CameraReading Cameras::reading(const Flight& flight, const sim::VehicleState& moment) const {
    if (is_pilots()) {
        return {name_of(settings_.kind, camera_names), moment.ship_clock.value};
    }
    return {name_of(settings_.kind, camera_names), observer(flight, moment, glm::dquat(1.0, 0.0, 0.0, 0.0)).clock};
}

std::vector<ClockReading> Cameras::clocks(const Flight& flight, const render::RenderFrame& frame) const {
    std::vector<ClockReading> readings;
    if (idle()) {
        return readings;
    }
    const sim::Event eye{frame.moving.world_time, frame.eye.position / frame.moving.metres_per_light_unit};
    const sim::BoostAndRotation motion = sim::split(frame.eye.world_from_head);
    for (const Shown& ship : shown(flight)) {
        if (ship.is_beacon && is_pilots()) {
            continue;
        }
        const sim::SeenShipPoint seen = ship.world_line->seen(glm::dvec3(0.0), eye);
        const sim::SeenFrom from = sim::where_seen(motion, seen.from);
        readings.push_back({ship.name, seen.ship.ship_clock.value,
                            ship.world_line->at_world_time(sim::CoordinateTime(eye.t)).value,
                            seen.wavelength_ratio * from.wavelength_ratio, from.head_direction});
    }
    return readings;
}

} // namespace engine
