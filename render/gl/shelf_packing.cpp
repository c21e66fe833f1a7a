#include "render/gl/shelf_packing.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace render {

std::optional<ShelfPacking> pack_into_shelves(std::span<const glm::ivec2> sizes, int largest) {
    double area = 0.0;
    int widest = 0;
    for (const glm::ivec2& size : sizes) {
        area += double(size.x) * double(size.y);
        widest = std::max(widest, size.x);
    }
    const int width = std::min(largest, std::max(widest, static_cast<int>(std::ceil(1.1 * std::sqrt(area)))));
    if (widest > width) {
        return std::nullopt;
    }
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a].y > sizes[b].y; });
    ShelfPacking packing;
    packing.corners.resize(sizes.size());
    glm::ivec2 pen(0);
    int shelf = 0;
    for (const std::size_t i : order) {
        if (pen.x + sizes[i].x > width) {
            pen = {0, pen.y + shelf};
            shelf = 0;
        }
        packing.corners[i] = pen;
        pen.x += sizes[i].x;
        shelf = std::max(shelf, sizes[i].y);
        packing.size = glm::max(packing.size, packing.corners[i] + sizes[i]);
    }
    if (packing.size.y > largest) {
        return std::nullopt;
    }
    return packing;
}

} // namespace render
