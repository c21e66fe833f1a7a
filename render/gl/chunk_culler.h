#pragma once

#include "render/gl/scene_chunks.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace render {

/// Finds the chunks that a picture of the world shows. No OpenGL.
class ChunkCuller {
  public:
    /// Keeps references to both: they must outlive it.
    ChunkCuller(const std::vector<ChunkNode>& nodes, const std::vector<Chunk>& chunks);

    /// From where the next pictures are taken: orders all chunks by distance.
    void set_eye(const glm::dvec3& eye);

    /// Chunks that may show in the texels [0, size] of a picture, nearest first. `texels_from_world` maps directions
    /// in the world to homogeneous texel coordinates.
    const std::vector<std::uint32_t>& visible(const glm::dmat3& texels_from_world, const glm::dvec2& size);

  private:
    void descend(std::uint32_t node, std::span<const glm::vec3> planes, unsigned active);

    const std::vector<ChunkNode>& nodes_;
    const std::vector<Chunk>& chunks_;
    glm::dvec3 eye_{0.0};
    std::vector<std::uint32_t> rank_;        ///< of each chunk by distance
    std::vector<std::uint32_t> by_distance_; ///< chunk of each rank
    std::vector<std::uint32_t> visible_;
};

} // namespace render
