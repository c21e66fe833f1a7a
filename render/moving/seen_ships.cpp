#include "render/moving/seen_ships.h"

#include "sim/frequency_ratio.h"
#include "sim/ship_world_line.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

namespace render {
namespace {

SeenShip see_ship(const MovingShip& ship, const RenderFrame& frame, const HullLight& hull, std::size_t object) {
    const double metres = frame.moving.metres_per_light_unit;
    const sim::Event eye{frame.moving.world_time, frame.eye.position / metres};
    const sim::ShipWorldLine& line = *ship.world_line;
    const ShipBody& body = *ship.body;
    const double thrust = -line.seen(glm::dvec3(0.0), eye).ship.drive.proper_acceleration.z / ship.full_thrust;
    const BodyShape shape = shape_under_thrust(body, thrust);
    const sim::FourVector<sim::World> eye_velocity = sim::four_velocity(frame.eye.world_from_head);

    std::vector<sim::SeenShipPoint> points(shape.points.size());
    tbb::parallel_for(std::size_t{0}, points.size(),
                      [&](std::size_t i) { points[i] = line.seen(shape.points[i] / metres, eye); });
    SeenShip seen;
    seen.vertices.resize(body.vertices.size());
    tbb::parallel_for(std::size_t{0}, seen.vertices.size(), [&](std::size_t i) {
        const BodyVertex& vertex = body.vertices[i];
        const sim::SeenShipPoint& point = points[vertex.point];
        const double ratio = point.wavelength_ratio / sim::frequency_ratio(eye_velocity, point.from);
        seen.vertices[i] = {glm::vec3(metres * (point.event.space - eye.space)),
                            glm::vec3(hull.seen({vertex.normal, vertex.reflectance, vertex.emission,
                                                 point.ship.world_from_vehicle, ratio})),
                            static_cast<float>(ratio), static_cast<float>(object)};
    });
    for (const std::array<std::uint32_t, 3>& triangle : shape.triangles) {
        seen.indices.insert(seen.indices.end(), triangle.begin(), triangle.end());
    }
    glm::vec3 low(seen.vertices.front().from_eye);
    glm::vec3 high = low;
    for (const SeenShip::Vertex& vertex : seen.vertices) {
        low = glm::min(low, vertex.from_eye);
        high = glm::max(high, vertex.from_eye);
    }
    seen.centre = 0.5f * (low + high);
    seen.radius = 0.5f * glm::length(high - low);
    return seen;
}

} // namespace

std::vector<SeenShip> see_ships(const RenderFrame& frame, const Surroundings& surroundings,
                                const DopplerColour& colour) {
    std::vector<SeenShip> seen;
    const HullLight hull(surroundings, colour, frame.mode);
    for (std::size_t i = 0; i < frame.moving.ships.size(); ++i) {
        const MovingShip& ship = frame.moving.ships[i];
        if (!ship.body->triangles.empty()) {
            seen.push_back(see_ship(ship, frame, hull, surroundings.instances + i));
        }
    }
    return seen;
}

} // namespace render
