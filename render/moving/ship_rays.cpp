#include "render/moving/ship_rays.h"

#include "sim/frequency_ratio.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr int chords_under_thrust = 32;

/// The triangles of a body as a scene of their own, in vehicle axes.
content::SceneDesc scene_of(const ShipBody& body, const BodyShape& shape) {
    content::SceneDesc scene;
    scene.materials.emplace_back();
    content::Mesh mesh;
    for (const BodyVertex& vertex : body.vertices) {
        content::Vertex made;
        made.position = glm::vec3(shape.points[vertex.point]);
        made.normal = vertex.normal;
        mesh.vertices.push_back(made);
    }
    for (const std::array<std::uint32_t, 3>& triangle : shape.triangles) {
        mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
    }
    scene.meshes.push_back(std::move(mesh));
    scene.instances.emplace_back();
    return scene;
}

} // namespace

struct ShipRays::Body {
    Body(const MovingShip& moving, const sim::Event& eye, std::size_t object_number)
        : ship(moving), object(object_number), centre(moving.world_line->seen(glm::dvec3(0.0), eye)),
          shape(shape_under_thrust(*moving.body, -centre.ship.drive.proper_acceleration.z / moving.full_thrust)),
          scene(scene_of(*moving.body, shape)), hits(scene) {
        for (const glm::dvec3& point : shape.points) {
            radius = std::max(radius, glm::length(point));
        }
    }

    MovingShip ship;
    std::size_t object;
    sim::SeenShipPoint centre;
    BodyShape shape;
    content::SceneDesc scene;
    SceneryHits hits;
    double radius = 0.0; ///< metres about the vehicle's origin
};

struct ShipRays::Crossing {
    double along = 0.0; ///< of the ray, light clock units from the eye
    sim::WorldLinePoint ship;
    glm::dvec3 in_vehicle{0.0}; ///< light clock units
    SurfaceHit hit;
};

namespace {

struct InShip {
    sim::WorldLinePoint ship;
    glm::dvec3 in_vehicle{0.0}; ///< light clock units
};

/// An event in the ship whose present it belongs to, found from a moment nearby.
InShip in_ship(const sim::ShipWorldLine& line, const sim::Event& event, sim::ProperTime near) {
    InShip found;
    constexpr int most_steps = 50;
    for (int i = 0; i < most_steps; ++i) {
        found.ship = line.at(near);
        const sim::FourVector<sim::Vehicle> apart =
            sim::inverse(found.ship.world_from_vehicle) * (event - found.ship.event);
        found.in_vehicle = apart.space;
        const double ageing = 1.0 + glm::dot(found.ship.drive.proper_acceleration, apart.space);
        const sim::ProperTime step(apart.t / std::max(ageing, 0.1));
        near = near + step;
        if (std::abs(step.value) <= 1e-14 * (1.0 + std::abs(near.value))) {
            break;
        }
    }
    return found;
}

} // namespace

ShipRays::ShipRays(const RenderFrame& frame, const Surroundings& surroundings, const DopplerColour& colour)
    : frame_(frame),
      hull_(surroundings, colour, frame.mode), eye_{frame.moving.world_time,
                                                    frame.eye.position / frame.moving.metres_per_light_unit},
      eye_velocity_(sim::four_velocity(frame.eye.world_from_head)) {
    for (std::size_t i = 0; i < frame.moving.ships.size(); ++i) {
        if (!frame.moving.ships[i].body->triangles.empty()) {
            ships_.push_back(std::make_shared<const Body>(frame.moving.ships[i], eye_, surroundings.instances + i));
        }
    }
}

std::optional<ShipRays::Crossing> ShipRays::crossing(const Body& body, const glm::dvec3& direction) const {
    const double metres = frame_.moving.metres_per_light_unit;
    const auto event_at = [&](double along) { return sim::Event{eye_.t - along, eye_.space + along * direction}; };
    // In the ship's rest frame of the moment at which its middle is seen the ray is straight: p + along q.
    const sim::WorldLinePoint& ship = body.centre.ship;
    const auto vehicle_from_world = sim::inverse(ship.world_from_vehicle);
    const glm::dvec3 p = (vehicle_from_world * (eye_ - ship.event)).space;
    const glm::dvec3 q = (vehicle_from_world * sim::FourVector<sim::World>{-1.0, direction}).space;
    // Through a sphere with room for what thrust and turn bend.
    const double radius = 1.3 * body.radius / metres;
    const double q2 = glm::dot(q, q);
    const double nearest = -glm::dot(p, q) / q2;
    const glm::dvec3 closest = p + nearest * q;
    const double miss2 = radius * radius - glm::dot(closest, closest);
    if (miss2 <= 0.0) {
        return std::nullopt;
    }
    const double half = std::sqrt(miss2 / q2);
    const double begin = std::max(nearest - half, 0.0);
    const double end = nearest + half;
    if (end <= 0.0) {
        return std::nullopt;
    }
    const sim::ShipWorldLine& line = *body.ship.world_line;
    InShip from = in_ship(line, event_at(begin), ship.ship_clock);
    const InShip last = in_ship(line, event_at(end), ship.ship_clock);
    const bool coasting = from.ship.world_from_vehicle.spin == last.ship.world_from_vehicle.spin;
    const int chords = coasting ? 1 : chords_under_thrust;
    for (int i = 0; i < chords; ++i) {
        const double start = begin + i * (end - begin) / chords;
        const double stop = begin + (i + 1) * (end - begin) / chords;
        const InShip to = in_ship(line, event_at(stop), from.ship.ship_clock);
        const glm::dvec3 chord = metres * (to.in_vehicle - from.in_vehicle);
        const double length = glm::length(chord);
        const std::optional<SurfaceHit> hit = body.hits.first(metres * from.in_vehicle, chord / length);
        if (hit && hit->distance <= length) {
            const double along = start + hit->distance / length * (stop - start);
            const InShip there = in_ship(line, event_at(along), to.ship.ship_clock);
            return Crossing{along, there.ship, there.in_vehicle, *hit};
        }
        from = to;
    }
    return std::nullopt;
}

ShipHit ShipRays::hit_of(const Body& body, const Crossing& crossing, const glm::dvec3& direction) const {
    const std::array<std::uint32_t, 3>& corners = body.shape.triangles[crossing.hit.triangle];
    const auto mixed = [&](auto member) {
        glm::dvec3 sum(0.0);
        for (int i = 0; i < 3; ++i) {
            const BodyVertex& vertex = body.ship.body->vertices[corners.at(static_cast<std::size_t>(i))];
            sum += crossing.hit.barycentric[i] * glm::dvec3(vertex.*member);
        }
        return sum;
    };
    const double ratio = sim::frequency_ratio(sim::velocity_of(crossing.ship, crossing.in_vehicle), {direction}) /
                         sim::frequency_ratio(eye_velocity_, {direction});
    ShipHit hit;
    hit.distance = crossing.along * frame_.moving.metres_per_light_unit;
    hit.object = body.object;
    hit.wavelength_ratio = ratio;
    hit.radiance =
        hull_.seen({glm::vec3(glm::normalize(mixed(&BodyVertex::normal))), glm::vec3(mixed(&BodyVertex::reflectance)),
                    glm::vec3(mixed(&BodyVertex::emission)), crossing.ship.world_from_vehicle, ratio});
    return hit;
}

std::optional<ShipHit> ShipRays::first(const glm::dvec3& direction) const {
    std::optional<Crossing> nearest;
    const Body* of = nullptr;
    for (const std::shared_ptr<const Body>& ship : ships_) {
        const std::optional<Crossing> found = crossing(*ship, direction);
        if (found && (!nearest || found->along < nearest->along)) {
            nearest = found;
            of = ship.get();
        }
    }
    if (!nearest) {
        return std::nullopt;
    }
    return hit_of(*of, *nearest, direction);
}

} // namespace render
