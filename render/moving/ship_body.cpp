#include "render/moving/ship_body.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace render {
namespace {

/// Longer than the model's flame by this at the most, when boosted.
constexpr double longest_flame = 1.6;

Flame flame_of(const content::Material& material) {
    return material.name.starts_with("exhaust aft")     ? Flame::aft
           : material.name.starts_with("exhaust ahead") ? Flame::ahead
                                                        : Flame::none;
}

/// Gives equal points of one kind one number.
class PointNumbers {
  public:
    explicit PointNumbers(ShipBody& body) : body_(body) {}

    std::uint32_t number(const glm::dvec3& point, Flame flame) {
        const auto [found, is_new] = numbers_.try_emplace(std::tuple(point.x, point.y, point.z, flame),
                                                          static_cast<std::uint32_t>(body_.points.size()));
        if (is_new) {
            body_.points.push_back(point);
            body_.flames.push_back(flame);
        }
        return found->second;
    }

  private:
    ShipBody& body_;
    std::map<std::tuple<double, double, double, Flame>, std::uint32_t> numbers_;
};

void add_instance(const content::SceneDesc& model, const content::Instance& instance, PointNumbers& numbers,
                  ShipBody& body) {
    const content::Mesh& mesh = model.meshes[instance.mesh];
    const content::Material& material = model.materials[mesh.material];
    const Flame flame = flame_of(material);
    const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(instance.world_from_mesh)));
    const bool mirrored = glm::determinant(glm::mat3(instance.world_from_mesh)) < 0.0f;
    const auto first = static_cast<std::uint32_t>(body.vertices.size());
    for (const content::Vertex& vertex : mesh.vertices) {
        const glm::dvec3 point(instance.world_from_mesh * glm::vec4(vertex.position, 1.0f));
        const glm::vec3 colour = glm::vec3(material.base_colour) * glm::vec3(vertex.colour);
        body.vertices.push_back({numbers.number(point, flame), glm::normalize(normals * vertex.normal),
                                 material.unlit ? glm::vec3(0.0f) : colour,
                                 material.unlit ? colour : material.emission});
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<std::uint32_t, 3> corners{first + mesh.indices[i], first + mesh.indices[i + 1],
                                             first + mesh.indices[i + 2]};
        if (mirrored) {
            std::swap(corners[1], corners[2]);
        }
        const auto point = [&](std::size_t corner) { return body.vertices[corners.at(corner)].point; };
        if (point(0) != point(1) && point(1) != point(2) && point(2) != point(0)) { // a pole's quads have none there
            body.triangles.push_back({corners, flame});
        }
    }
}

} // namespace

ShipBody make_ship_body(const content::SceneDesc& model) {
    ShipBody body;
    PointNumbers numbers(body);
    for (const content::Instance& instance : model.instances) {
        add_instance(model, instance, numbers, body);
    }
    const auto root = [&body](Flame flame, double side) {
        double z = 0.0;
        bool found = false;
        for (std::size_t i = 0; i < body.points.size(); ++i) {
            if (body.flames[i] == flame && (!found || side * body.points[i].z < side * z)) {
                z = body.points[i].z;
                found = true;
            }
        }
        return z;
    };
    body.aft_root = root(Flame::aft, 1.0);
    body.ahead_root = root(Flame::ahead, -1.0);
    return body;
}

BodyShape shape_under_thrust(const ShipBody& body, double thrust) {
    const double aft = std::clamp(thrust, 0.0, longest_flame);
    const double ahead = std::clamp(-thrust, 0.0, longest_flame);
    BodyShape shape{body.points, {}};
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        double& z = shape.points[i].z;
        if (body.flames[i] == Flame::aft) {
            z = body.aft_root + aft * (z - body.aft_root);
        } else if (body.flames[i] == Flame::ahead) {
            z = body.ahead_root + ahead * (z - body.ahead_root);
        }
    }
    constexpr double least = 0.01; // shorter ones are not seen
    for (const BodyTriangle& triangle : body.triangles) {
        if (triangle.flame == Flame::none || (triangle.flame == Flame::aft && aft > least) ||
            (triangle.flame == Flame::ahead && ahead > least)) {
            shape.triangles.push_back(triangle.vertices);
        }
    }
    return shape;
}

} // namespace render
