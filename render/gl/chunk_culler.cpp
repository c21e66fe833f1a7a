#include "render/gl/chunk_culler.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace render {

ChunkCuller::ChunkCuller(const std::vector<ChunkNode>& nodes, const std::vector<Chunk>& chunks)
    : nodes_(nodes), chunks_(chunks), rank_(chunks.size()), by_distance_(chunks.size()) {}

void ChunkCuller::set_eye(const glm::dvec3& eye) {
    eye_ = eye;
    std::vector<float> distance(chunks_.size());
    for (std::uint32_t i = 0; i < chunks_.size(); ++i) {
        const Box& box = chunks_[i].box;
        const glm::vec3 point(eye);
        // The nearest point tells what can hide others; the centre keeps wide ground from coming before all that
        // stands on it.
        const glm::vec3 near = glm::max(glm::max(box.low - point, point - box.high), glm::vec3(0.0f));
        const glm::vec3 centre = 0.5f * (box.low + box.high) - point;
        distance[i] = glm::length(near) + glm::length(centre);
        by_distance_[i] = i;
    }
    std::sort(by_distance_.begin(), by_distance_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return distance[a] < distance[b]; });
    for (std::uint32_t i = 0; i < by_distance_.size(); ++i) {
        rank_[by_distance_[i]] = i;
    }
}

const std::vector<std::uint32_t>& ChunkCuller::visible(const glm::dmat3& texels_from_world, const glm::dvec2& size) {
    visible_.clear();
    if (nodes_.empty()) {
        return visible_;
    }
    const glm::dmat3 rows = glm::transpose(texels_from_world);
    const std::array<glm::dvec3, 5> exact{rows[0], size.x * rows[2] - rows[0], rows[1], size.y * rows[2] - rows[1],
                                          rows[2]};
    std::array<glm::vec3, 5> planes;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        planes.at(i) = glm::vec3(glm::normalize(exact.at(i)));
    }
    descend(0, planes, 31u);
    std::sort(visible_.begin(), visible_.end());
    for (std::uint32_t& entry : visible_) {
        entry = by_distance_[entry];
    }
    return visible_;
}

void ChunkCuller::descend(std::uint32_t index, std::span<const glm::vec3> planes, unsigned active) {
    const ChunkNode& node = nodes_[index];
    const glm::vec3 centre(0.5 * (glm::dvec3(node.box.low) + glm::dvec3(node.box.high)) - eye_);
    const glm::vec3 half = 0.5f * (node.box.high - node.box.low);
    unsigned crossed = 0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const unsigned bit = 1u << i;
        if ((active & bit) == 0) {
            continue;
        }
        const float distance = glm::dot(planes[i], centre);
        const float reach = glm::dot(glm::abs(planes[i]), half);
        // Single precision of the planes: a narrow picture's are known to 1e-7 of the distance only.
        const float slack = 1e-6f * (glm::abs(centre.x) + glm::abs(centre.y) + glm::abs(centre.z));
        if (distance < -reach - slack) {
            return;
        }
        if (distance < reach + slack) {
            crossed |= bit;
        }
    }
    if (node.chunk >= 0) {
        visible_.push_back(rank_[static_cast<std::size_t>(node.chunk)]);
        return;
    }
    descend(node.left, planes, crossed);
    descend(node.right, planes, crossed);
}

} // namespace render
