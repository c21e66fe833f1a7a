#pragma once

#include "content/generator/mesh_builder.h"
#include "content/generator/outdoor_parts.h"
#include "content/scene_desc.h"

namespace content::generator {

struct SquareMaterials {
    std::size_t cobbles; ///< 2 m a picture; tinted
    std::size_t stone;   ///< tinted
    std::size_t wood;
    std::size_t hedge;
    std::size_t water;
    std::size_t bronze; ///< plain; tinted
    TreeMaterials tree;
    std::size_t metal;
    std::size_t lantern;
};

/// A fountain of 6 m radius about the origin: a stepped basin, a column with two bowls, and an armillary sphere, whose
/// rings show that round things stay round.
void add_fountain(SceneDesc& scene, const SquareMaterials& materials);

} // namespace content::generator
