#pragma once

#include "content/gltf_document.h"
#include "content/gltf_material.h"

#include <string>
#include <vector>

namespace content {

/// The triangles of mesh `index`, one content::Mesh for each primitive that has any. Missing normals become those of
/// the flat triangles. Points and lines are left out and named in `notes`. Throws sim::BadInput.
std::vector<Mesh> read_mesh(const GltfDocument& document, std::size_t index, const GltfMaterials& materials,
                            std::vector<std::string>& notes);

} // namespace content
