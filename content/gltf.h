#pragma once

#include "content/scene_desc.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace content {

/// Loads a glTF 2.0 scene, .gltf or .glb, as plain data: the default scene's nodes with their triangles, materials,
/// lights (KHR_lights_punctual) and cameras. What the picture cannot show is left out and named in SceneDesc::notes.
///
/// Light: a directional light becomes the sun, a point light a lamp; the file's lux and candela are taken as the
/// scene's own units, so that a directional light of intensity pi gives a white surface radiance 1.
/// Material extras: `"rapidity": {"temperature_K": 3000}` makes the emission a black body's.
/// Throws sim::BadInput with file, field (such as meshes[3].primitives[0].attributes.POSITION) and value.
SceneDesc load_gltf(const std::filesystem::path& file);

/// The same from memory. `source` names it in messages; buffers and images with relative URIs are looked for in
/// `folder`.
SceneDesc load_gltf(std::span<const std::uint8_t> bytes, const std::string& source,
                    const std::filesystem::path& folder);

} // namespace content
