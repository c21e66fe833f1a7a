#pragma once

#include "content/gltf_document.h"
#include "content/scene_desc.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace content {

/// Which texture coordinates a material's textures use, and the transform that leads to them (KHR_texture_transform).
struct TextureMapping {
    int coordinate_set = 0;
    glm::mat3 transform{1.0f}; ///< of (u, v, 1)
};

/// The materials of a file and a mapping for each; only the images that they use are decoded. The last material is the
/// one of primitives that name none. Throws sim::BadInput.
struct GltfMaterials {
    std::vector<Image> images;
    std::vector<Material> materials;
    std::vector<TextureMapping> mappings;
    std::vector<std::string> notes;
};

GltfMaterials read_materials(const GltfDocument& document);

} // namespace content
