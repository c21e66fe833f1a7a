#pragma once

#include "content/scene_desc.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace render {

/// Image colour at texture coordinates (v downwards, as glTF), repeated beyond [0, 1], bilinear between texel centres;
/// colour decoded from sRGB before filtering, alpha linear.
glm::dvec4 texture_colour(const content::Image& image, const glm::dvec2& coordinates);

/// A triangle of an instance: its three vertices and how they sit in the world.
struct TriangleView {
    const content::Instance& instance;
    const content::Mesh& mesh;
    const content::Material& material;
    std::array<const content::Vertex*, 3> vertices;

    TriangleView(const content::SceneDesc& scene, std::size_t instance_index, std::uint32_t triangle);
    /// Position of vertex `corner` in the world, scene metres.
    glm::dvec3 world_position(int corner) const;
};

/// The alpha of base_colour by itself: rays ask it of every leaf that they pass.
double opacity(const content::SceneDesc& scene, const TriangleView& triangle, const glm::dvec3& barycentric);

/// Base colour factor times vertex colour times texture at a point of a triangle; alpha included.
glm::dvec4 base_colour(const content::SceneDesc& scene, const TriangleView& triangle, const glm::dvec3& barycentric);

/// Emitted radiance at a point of a triangle.
glm::dvec3 emission(const content::SceneDesc& scene, const TriangleView& triangle, const glm::dvec3& barycentric);

/// The vertices' normal, interpolated, in the world, unit; not turned towards anybody.
glm::dvec3 shading_normal(const TriangleView& triangle, const glm::dvec3& barycentric);

} // namespace render
