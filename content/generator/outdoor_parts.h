#pragma once

#include "content/generator/mesh_builder.h"
#include "content/scene_desc.h"

#include <string>

/// Trees and lamp posts: each kind is made once and placed often. Metres, y up.
namespace content::generator {

struct TreeMaterials {
    std::size_t bark;
    std::size_t leaves;
    std::size_t boughs; ///< dark, within the crown
};

TreeMaterials add_tree_materials(SceneDesc& scene);

struct TreeMeshes {
    std::size_t trunk;
    std::size_t crown;
    std::size_t boughs;
};

/// Makes a tree about 7 m high; its looks depend on the seed alone.
TreeMeshes add_tree_meshes(SceneDesc& scene, const TreeMaterials& materials, std::uint32_t seed);

void place_tree(SceneDesc& scene, const std::string& name, const TreeMeshes& tree, const glm::vec3& foot, float scale,
                float turn);

struct LampPostMeshes {
    std::size_t post;
    std::size_t lantern;
};

/// Makes a lamp post 4.6 m high.
LampPostMeshes add_lamp_post_meshes(SceneDesc& scene, std::size_t metal, std::size_t glow);

/// Places a lamp post and its light, of linear `intensity`.
void place_lamp_post(SceneDesc& scene, const std::string& name, const LampPostMeshes& post, const glm::vec3& foot,
                     const glm::vec3& intensity);

} // namespace content::generator
