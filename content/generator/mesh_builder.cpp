#include "content/generator/mesh_builder.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace content::generator {
namespace {

glm::vec3 flat_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return glm::normalize(glm::cross(b - a, c - a));
}

struct Ball {
    std::vector<glm::vec3> directions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

Ball icosahedron() {
    const float g = (1.0f + std::sqrt(5.0f)) / 2.0f;
    Ball ball;
    ball.directions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                       {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (glm::vec3& direction : ball.directions) {
        direction = glm::normalize(direction);
    }
    ball.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return ball;
}

Ball subdivided(const Ball& coarse) {
    Ball fine;
    fine.directions = coarse.directions;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [entry, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.directions.size()));
        if (is_new) {
            fine.directions.push_back(glm::normalize(coarse.directions[a] + coarse.directions[b]));
        }
        return entry->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        fine.triangles.push_back({a, ab, ca});
        fine.triangles.push_back({b, bc, ab});
        fine.triangles.push_back({c, ca, bc});
        fine.triangles.push_back({ab, bc, ca});
    }
    return fine;
}

} // namespace

std::uint32_t MeshBuilder::vertex(const glm::vec3& position, const glm::vec3& normal,
                                  const glm::vec2& texture_coordinates) {
    Vertex result;
    result.position = glm::vec3(transform * glm::vec4(position, 1.0f));
    result.normal = glm::normalize(glm::inverseTranspose(glm::mat3(transform)) * normal);
    result.texture_coordinates = texture_coordinates;
    const float brightness = shade ? shade(result.position, result.normal) : 1.0f;
    result.colour = glm::vec4(tint * brightness, 1.0f);
    vertices_.push_back(result);
    return static_cast<std::uint32_t>(vertices_.size() - 1);
}

glm::vec2 MeshBuilder::planar(const glm::vec3& position, const glm::vec3& normal) const {
    const glm::vec3 size = glm::abs(normal);
    glm::vec2 metres;
    if (size.y >= size.x && size.y >= size.z) {
        metres = {position.x, -position.z};
    } else if (size.x >= size.z) {
        metres = {normal.x > 0.0f ? -position.z : position.z, position.y};
    } else {
        metres = {normal.z > 0.0f ? position.x : -position.x, position.y};
    }
    return {metres.x / texture_size, -metres.y / texture_size};
}

void MeshBuilder::quad(const std::array<glm::vec3, 4>& corners) {
    const glm::vec3 normal = flat_normal(corners[0], corners[1], corners[2]);
    std::array<std::uint32_t, 4> v{};
    for (std::size_t i = 0; i < 4; ++i) {
        v[i] = vertex(corners[i], normal, planar(corners[i], normal));
    }
    indices_.insert(indices_.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
}

void MeshBuilder::quad(const std::array<glm::vec3, 4>& corners, const TextureArea& area) {
    const glm::vec3 normal = flat_normal(corners[0], corners[1], corners[2]);
    const std::array<glm::vec2, 4> painted = {area.lower_left,
                                              {area.upper_right.x, area.lower_left.y},
                                              area.upper_right,
                                              {area.lower_left.x, area.upper_right.y}};
    std::array<std::uint32_t, 4> v{};
    for (std::size_t i = 0; i < 4; ++i) {
        v[i] = vertex(corners[i], normal, {painted[i].x, 1.0f - painted[i].y});
    }
    indices_.insert(indices_.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
}

void MeshBuilder::triangle(const std::array<glm::vec3, 3>& corners) {
    const glm::vec3 normal = flat_normal(corners[0], corners[1], corners[2]);
    for (const glm::vec3& corner : corners) {
        indices_.push_back(vertex(corner, normal, planar(corner, normal)));
    }
}

void MeshBuilder::box(const glm::vec3& a, const glm::vec3& b, unsigned faces) {
    if ((faces & face_left) != 0) {
        quad({{{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}}});
    }
    if ((faces & face_right) != 0) {
        quad({{{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}}});
    }
    if ((faces & face_bottom) != 0) {
        quad({{{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}});
    }
    if ((faces & face_top) != 0) {
        quad({{{a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}}});
    }
    if ((faces & face_back) != 0) {
        quad({{{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}}});
    }
    if ((faces & face_front) != 0) {
        quad({{{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}});
    }
}

void MeshBuilder::extrude(std::span<const glm::vec2> outline, float back, float front) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        const glm::vec2& a = outline[i];
        const glm::vec2& b = outline[(i + 1) % n];
        quad({{{a, front}, {a, back}, {b, back}, {b, front}}});
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
        triangle({{{outline[0], front}, {outline[i], front}, {outline[i + 1], front}}});
        triangle({{{outline[0], back}, {outline[i + 1], back}, {outline[i], back}}});
    }
}

void MeshBuilder::turn(std::span<const ProfilePoint> profile, int segments) {
    const auto around = [&](int i) {
        const float angle = glm::two_pi<float>() * static_cast<float>(i % segments) / static_cast<float>(segments);
        return glm::vec3(std::cos(angle), 0.0f, -std::sin(angle));
    };
    float travelled = 0.0f; // along the profile
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
        const ProfilePoint low = profile[ring];
        const ProfilePoint high = profile[ring + 1];
        const glm::vec2 outward = glm::normalize(glm::vec2(high.height - low.height, low.radius - high.radius));
        const float next = travelled + std::hypot(high.radius - low.radius, high.height - low.height);
        const auto corner = [&](const ProfilePoint& point, float on_profile, int i) {
            const glm::vec3 radial = around(i);
            const glm::vec3 position = radial * point.radius + glm::vec3(0.0f, point.height, 0.0f);
            const glm::vec3 normal = radial * outward.x + glm::vec3(0.0f, outward.y, 0.0f);
            const float girth = glm::two_pi<float>() * std::max(low.radius, high.radius);
            const float along = girth * static_cast<float>(i) / static_cast<float>(segments);
            return vertex(position, normal, {along / texture_size, -on_profile / texture_size});
        };
        for (int i = 0; i < segments; ++i) {
            const std::uint32_t a = corner(low, travelled, i);
            const std::uint32_t b = corner(low, travelled, i + 1);
            const std::uint32_t c = corner(high, next, i + 1);
            const std::uint32_t d = corner(high, next, i);
            if (low.radius > 0.0f) {
                indices_.insert(indices_.end(), {a, b, c});
            }
            if (high.radius > 0.0f) {
                indices_.insert(indices_.end(), {a, c, d});
            }
        }
        travelled = next;
    }
}

void MeshBuilder::tube(std::span<const glm::vec3> path, float radius, int sides) {
    const auto direction_at = [&](std::size_t i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        return glm::normalize(path[std::min(i + 1, path.size() - 1)] - path[before]);
    };
    const glm::vec3 first = direction_at(0);
    glm::vec3 side = glm::cross(first, std::abs(first.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0, 0));
    std::vector<std::uint32_t> last;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const glm::vec3 along = direction_at(i);
        side = glm::normalize(side - along * glm::dot(side, along)); // carried along without turning about the path
        const glm::vec3 other = glm::cross(along, side);
        std::vector<std::uint32_t> ring;
        for (int k = 0; k <= sides; ++k) {
            const float angle = glm::two_pi<float>() * static_cast<float>(k) / static_cast<float>(sides);
            const glm::vec3 outward = std::cos(angle) * side + std::sin(angle) * other;
            ring.push_back(vertex(path[i] + radius * outward, outward, glm::vec2(0.0f)));
        }
        for (std::size_t k = 0; i > 0 && k + 1 < ring.size(); ++k) {
            indices_.insert(indices_.end(), {last[k], last[k + 1], ring[k + 1], last[k], ring[k + 1], ring[k]});
        }
        last = std::move(ring);
    }
}

void MeshBuilder::ball(const glm::vec3& centre, int subdivisions,
                       const std::function<float(const glm::vec3&)>& radius) {
    Ball ball = icosahedron();
    for (int i = 0; i < subdivisions; ++i) {
        ball = subdivided(ball);
    }
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals(ball.directions.size(), glm::vec3(0.0f));
    for (const glm::vec3& direction : ball.directions) {
        positions.push_back(centre + direction * radius(direction));
    }
    for (const auto& [a, b, c] : ball.triangles) {
        const glm::vec3 area = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        normals[a] += area;
        normals[b] += area;
        normals[c] += area;
    }
    // The picture is laid on triangle by triangle: one map around the whole ball would have a seam.
    for (const auto& triangle : ball.triangles) {
        const auto [a, b, c] = triangle;
        const glm::vec3 flat = flat_normal(positions[a], positions[b], positions[c]);
        for (const std::uint32_t corner : triangle) {
            indices_.push_back(
                vertex(positions[corner], glm::normalize(normals[corner]), planar(positions[corner], flat)));
        }
    }
}

Mesh MeshBuilder::mesh(std::string name, std::size_t material) const {
    return {std::move(name), material, vertices_, indices_};
}

} // namespace content::generator
