#pragma once

#include "content/scene_desc.h"
#include "render/eye_ray.h"
#include "render/render_frame.h"
#include "sim/look.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

/// Small scenes and frames with known answers.
namespace scene_kit {

/// A material that shows its colour as it stands, on both sides.
inline content::Material unlit(const glm::vec3& colour) {
    content::Material material;
    material.base_colour = glm::vec4(colour, 1.0f);
    material.unlit = true;
    material.double_sided = true;
    return material;
}

/// A material that reflects, without a texture.
inline content::Material matte(const glm::vec3& reflectance) {
    content::Material material;
    material.base_colour = glm::vec4(reflectance, 1.0f);
    return material;
}

/// Puts a mesh of `material` into the scene, where it stands; returns the object's id.
inline std::size_t add(content::SceneDesc& scene, content::Mesh mesh, const content::Material& material,
                       const glm::mat4& world_from_mesh = glm::mat4(1.0f)) {
    mesh.material = scene.materials.size();
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    content::Instance instance;
    instance.mesh = scene.meshes.size() - 1;
    instance.world_from_mesh = world_from_mesh;
    scene.instances.push_back(instance);
    return scene.instances.size() - 1;
}

/// A rectangle with texture coordinates (0, 0) at its upper left; `right` and `up` reach from the centre to the edges.
inline content::Mesh rectangle(const glm::vec3& centre, const glm::vec3& right, const glm::vec3& up) {
    content::Mesh mesh;
    const glm::vec3 normal = glm::normalize(glm::cross(right, up));
    for (const glm::vec2& corner : {glm::vec2(-1, 1), glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1)}) {
        content::Vertex vertex;
        vertex.position = centre + corner.x * right + corner.y * up;
        vertex.normal = normal;
        vertex.texture_coordinates = {0.5f + 0.5f * corner.x, 0.5f - 0.5f * corner.y};
        mesh.vertices.push_back(vertex);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// Nothing anywhere, and a black sky.
inline content::SceneDesc empty_scene() {
    content::SceneDesc scene;
    scene.gradient_sky = {glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
    return scene;
}

/// A wide floor two metres below the eye.
inline content::SceneDesc floor_scene(const content::Material& material) {
    content::SceneDesc scene = empty_scene();
    add(scene, rectangle({0, -2, 0}, {100, 0, 0}, {0, 0, -100}), material);
    return scene;
}

/// A sphere of `columns` x `columns`/2 faces with its vertices on the surface.
inline content::Mesh sphere(const glm::vec3& centre, float radius, std::uint32_t columns) {
    content::Mesh mesh;
    const std::uint32_t rows = columns / 2;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        const double theta = std::numbers::pi * row / rows;
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const double phi = 2.0 * std::numbers::pi * column / columns;
            content::Vertex vertex;
            vertex.normal = glm::vec3(
                glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)));
            vertex.position = centre + radius * vertex.normal;
            mesh.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t upper = row * (columns + 1) + column;
            const std::uint32_t lower = upper + columns + 1;
            mesh.indices.insert(mesh.indices.end(), {upper, lower, upper + 1, upper + 1, lower, lower + 1});
        }
    }
    return mesh;
}

/// An eye at the origin: 90 degrees wide, `width` x `height` pixels, moving along `heading`, looking along `look`.
inline render::RenderFrame frame(double rapidity, const glm::dvec3& heading, const glm::dvec3& look, int width,
                                 int height) {
    render::RenderFrame frame;
    frame.eye.world_from_head = sim::world_from_looking<sim::Head>(sim::Rapidity(rapidity), heading, look);
    frame.eye.width = width;
    frame.eye.height = height;
    frame.mode = render::Mode::geometry;
    return frame;
}

/// One pixel's values, from its column and row.
inline glm::dvec3 colour_at(const render::Picture& picture, int column, int row) {
    const std::size_t at = static_cast<std::size_t>((row * picture.width + column) * picture.channels);
    return {picture.values[at], picture.values[at + 1], picture.values[at + 2]};
}
inline double value_at(const render::Picture& picture, int column, int row) {
    return picture.values[static_cast<std::size_t>(row * picture.width + column)];
}

} // namespace scene_kit
