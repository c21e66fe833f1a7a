#pragma once

#include "content/generator/mesh_builder.h"
#include "content/scene_desc.h"

#include <string>
#include <utility>

namespace content::generator {

/// Adds an opaque material that shows `image`; vertex colours tint it.
std::size_t add_painted_material(SceneDesc& scene, Image image);

/// The same with the parts of the image that are transparent left out, seen from both sides.
std::size_t add_masked_material(SceneDesc& scene, Image image);

/// Adds an opaque material of one linear colour; vertex colours tint it.
std::size_t add_plain_material(SceneDesc& scene, std::string name, const glm::vec3& base_colour = glm::vec3(1.0f));

/// Adds a material that only glows, with linear radiance `emission`.
std::size_t add_glowing_material(SceneDesc& scene, std::string name, const glm::vec3& emission);

/// Adds a mesh and returns its index.
std::size_t add_mesh(SceneDesc& scene, Mesh mesh);

/// Places a mesh.
void place(SceneDesc& scene, std::string name, std::size_t mesh, const glm::mat4& world_from_mesh = glm::mat4(1.0f));

/// Adds what was built as a mesh and places it where it was built; nothing when it is empty.
void place(SceneDesc& scene, std::string name, const MeshBuilder& builder, std::size_t material);

} // namespace content::generator
