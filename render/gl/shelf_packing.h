#pragma once

#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <vector>

namespace render {

struct ShelfPacking {
    std::vector<glm::ivec2> corners; ///< lower left of each rectangle, in the order given
    glm::ivec2 size{0};              ///< what they take together
};

/// Packs rectangles without overlap in rows of falling height into a square of `largest` a side, as narrow as fills it
/// well. Nothing when they do not fit.
std::optional<ShelfPacking> pack_into_shelves(std::span<const glm::ivec2> sizes, int largest);

} // namespace render
