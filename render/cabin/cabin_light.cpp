#include "render/cabin/cabin_light.h"

#include "render/cube_face.h"
#include "render/offline/scenery_hits.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tbb/parallel_for.h>

namespace render {
namespace {

constexpr int side = LightFromAround::face_side;
constexpr std::size_t directions = LightFromAround::directions;

/// Face coordinate of an edge between parts, 0 to `side`; halves are middles. The parts are even in angle, not in the
/// tangent, and so nearly as large.
double part_place(double index) {
    return std::tan(0.25 * std::numbers::pi * (2.0 * index / side - 1.0));
}

/// Solid angle of a part: that of a rectangle on a plane at distance 1, corner by corner.
double solid_angle(int column, int row) {
    const auto corner = [](double s, double t) { return std::atan(s * t / std::sqrt(1.0 + s * s + t * t)); };
    const double left = part_place(column);
    const double right = part_place(column + 1);
    const double low = part_place(row);
    const double high = part_place(row + 1);
    return corner(right, high) - corner(left, high) - corner(right, low) + corner(left, low);
}

/// The inverse: where a face coordinate lies among the parts, 0 to `side`.
float part_along(float coordinate) {
    const float angle = std::atan(coordinate) * static_cast<float>(4.0 * std::numbers::inv_pi);
    return 0.5f * side * (angle + 1.0f);
}

/// The part at a column and row of a face; one beyond the face's edge is its neighbour's.
std::size_t part_at(int face, int column, int row) {
    if (std::min(column, row) < 0 || std::max(column, row) >= side) {
        const CubePlace beyond =
            cube_place(glm::vec3(direction_from_face(face, part_place(column + 0.5), part_place(row + 0.5))));
        face = beyond.face;
        column = std::clamp(static_cast<int>(part_along(beyond.s)), 0, side - 1);
        row = std::clamp(static_cast<int>(part_along(beyond.t)), 0, side - 1);
    }
    const int part = (face * side + row) * side + column;
    return static_cast<std::size_t>(part);
}

/// The four parts whose middles are around a direction, and how near each is: shares that add up to one.
struct AroundParts {
    std::array<std::size_t, 4> parts{};
    std::array<float, 4> shares{};
};

AroundParts parts_around(const glm::vec3& direction) {
    const CubePlace place = cube_place(direction);
    const float across = part_along(place.s) - 0.5f;
    const float down = part_along(place.t) - 0.5f;
    const int column = static_cast<int>(std::floor(across));
    const int row = static_cast<int>(std::floor(down));
    const float right = across - static_cast<float>(column);
    const float lower = down - static_cast<float>(row);
    return {{part_at(place.face, column, row), part_at(place.face, column + 1, row),
             part_at(place.face, column, row + 1), part_at(place.face, column + 1, row + 1)},
            {(1.0f - right) * (1.0f - lower), right * (1.0f - lower), (1.0f - right) * lower, right * lower}};
}

/// The cabin as scenery, for rays.
content::SceneDesc scene_of(const content::Mesh& cabin) {
    content::SceneDesc scene;
    scene.materials.emplace_back();
    scene.materials.back().double_sided = true;
    scene.meshes.push_back(cabin);
    scene.meshes.back().material = 0;
    scene.instances.emplace_back();
    return scene;
}

/// The cosine that a part's light falls with, above the surface's own plane. Light is shared out linearly among parts,
/// which would lift it where the cosine has its corner, at the plane; what that adds on average over a step h is taken
/// off the part that stands just above: h s (1 - s) / 2 for one that stands (1 - s) h above it.
float even_cosine(float cosine) {
    constexpr auto step = static_cast<float>(0.5 * std::numbers::pi / side);
    return cosine < step ? cosine * (0.5f + 0.5f * cosine / step) : cosine;
}

/// How far from its surface a vertex looks out: past the facets of a round tube.
constexpr float clearance = 0.004f; // metres

} // namespace

glm::dvec3 light_direction(std::size_t part) {
    const int index = static_cast<int>(part);
    return direction_from_face(index / (side * side), part_place(index % side + 0.5),
                               part_place(index / side % side + 0.5));
}

void LightFromAround::add(const std::vector<SeenLightSample>& samples, const glm::dmat3& cabin_from_boosted,
                          float weight) {
    const glm::mat3 turn(cabin_from_boosted);
    for (const SeenLightSample& sample : samples) {
        const AroundParts around = parts_around(turn * sample.direction);
        for (std::size_t i = 0; i < 4; ++i) {
            power_.at(around.parts.at(i)) += weight * around.shares.at(i) * sample.power;
        }
    }
}

glm::vec3 LightFromAround::radiance_from(const glm::vec3& direction) const {
    const AroundParts around = parts_around(direction);
    glm::vec3 radiance(0.0f);
    for (std::size_t i = 0; i < 4; ++i) {
        const int index = static_cast<int>(around.parts.at(i));
        radiance += around.shares.at(i) * power_.at(around.parts.at(i)) /
                    static_cast<float>(solid_angle(index % side, index / side % side));
    }
    return radiance;
}

LightFromAround::LightFromAround(const glm::vec3& radiance) {
    for (std::size_t part = 0; part < directions; ++part) {
        const int index = static_cast<int>(part);
        power_[part] = radiance * static_cast<float>(solid_angle(index % side, index / side % side));
    }
}

CabinLight::CabinLight(const content::Mesh& cabin)
    : area_(cabin.vertices.size(), 0.0f), openness_(cabin.vertices.size(), 0.0f),
      share_(directions * cabin.vertices.size(), 0.0f) {
    const std::size_t count = cabin.vertices.size();
    for (const content::Vertex& vertex : cabin.vertices) {
        reflectance_.emplace_back(vertex.colour);
    }
    for (std::size_t i = 0; i + 2 < cabin.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return cabin.vertices[cabin.indices[i + k]].position; };
        const float third = glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))) / 6.0f;
        for (std::size_t k = 0; k < 3; ++k) {
            area_[cabin.indices[i + k]] += third;
        }
    }
    const content::SceneDesc scene = scene_of(cabin);
    const SceneryHits hits(scene, Edges::fast);
    tbb::parallel_for(std::size_t{0}, directions, [&](std::size_t part) {
        const glm::vec3 direction(light_direction(part));
        float* const share = &share_[part * count];
        for (std::size_t first = 0; first < count; first += lane_count) {
            const int lanes = static_cast<int>(std::min<std::size_t>(lane_count, count - first));
            Lanes3 origins{};
            LaneMask wanted = 0;
            for (int lane = 0; lane < lanes; ++lane) {
                const content::Vertex& vertex = cabin.vertices[first + static_cast<std::size_t>(lane)];
                const glm::vec3 origin = vertex.position + clearance * vertex.normal;
                origins.x[lane] = origin.x;
                origins.y[lane] = origin.y;
                origins.z[lane] = origin.z;
                wanted |= glm::dot(vertex.normal, direction) > 0.0f ? LaneMask{1} << lane : LaneMask{0};
            }
            const LaneMask open = wanted & ~hits.blocked(origins, direction, wanted);
            for (int lane = 0; lane < lanes; ++lane) {
                const std::size_t at = first + static_cast<std::size_t>(lane);
                share[at] = has(open, lane) ? even_cosine(glm::dot(cabin.vertices[at].normal, direction)) : 0.0f;
            }
        }
    });
    const std::vector<glm::vec3> light = irradiance(LightFromAround(glm::vec3(1.0f)));
    for (std::size_t i = 0; i < count; ++i) {
        openness_[i] = std::min(light[i].x * static_cast<float>(std::numbers::inv_pi), 1.0f);
    }
}

std::vector<glm::vec3> CabinLight::irradiance(const LightFromAround& light) const {
    const std::size_t count = reflectance_.size();
    std::vector<glm::vec3> sum(count, glm::vec3(0.0f));
    for (std::size_t part = 0; part < directions; ++part) {
        const glm::vec3 power = light.power()[part];
        if (power == glm::vec3(0.0f)) {
            continue;
        }
        const float* const share = &share_[part * count];
        for (std::size_t i = 0; i < count; ++i) {
            sum[i] += share[i] * power;
        }
    }
    return sum;
}

std::vector<glm::vec3> CabinLight::radiance(const LightFromAround& light) const {
    std::vector<glm::vec3> result = irradiance(light);
    glm::dvec3 sent_out(0.0);
    double area = 0.0;
    for (std::size_t i = 0; i < result.size(); ++i) {
        sent_out += static_cast<double>(area_[i]) * glm::dvec3(reflectance_[i] * result[i]);
        area += static_cast<double>(area_[i]);
    }
    const glm::vec3 bounced(sent_out / std::max(area, 1e-12));
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] =
            reflectance_[i] * (result[i] + (1.0f - openness_[i]) * bounced) * static_cast<float>(std::numbers::inv_pi);
    }
    return result;
}

} // namespace render
