#pragma once

#include "content/generator/mesh_builder.h"

/// Upright walls with holes, in a local plane z = const. that faces +z.
namespace content::generator {

struct Rectangle {
    glm::vec2 low;
    glm::vec2 high;
};

/// An upright rectangle; nothing when it is empty.
void upright(MeshBuilder& builder, const Rectangle& area, float z);

/// The rectangle `outer` less `inner`, as four upright rectangles.
void frame(MeshBuilder& builder, const Rectangle& outer, const Rectangle& inner, float z);

/// The four inner faces of a hole that reaches `depth` behind the plane z = 0.
void reveals(MeshBuilder& builder, const Rectangle& hole, float depth);

/// A picture that fills an upright rectangle.
void picture(MeshBuilder& builder, const Rectangle& area, float z, const TextureArea& texture);

} // namespace content::generator
