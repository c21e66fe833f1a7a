#include "render/gl/tile_planner.h"

#include "render/gl/shelf_packing.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace render {
namespace {

/// Cost of having a tile at all, in texels: culling, state changes, triangles drawn once more.
constexpr double tile_overhead = 3000.0;
/// Beyond this ratio of D within a block the samples below could miss what happens between them.
constexpr double largest_ratio_of_d = 6.0;
/// Least third homogeneous coordinate, relative to the largest: keeps the picture plane less than 88 degrees oblique.
constexpr double least_depth = 0.03;
constexpr int samples = 5; ///< along each side of a block

/// The pixel centres of a block, as a rectangle on the screen.
struct Centres {
    glm::dvec2 low;
    glm::dvec2 high;
};

Centres centres_of(const glm::ivec2& low, const glm::ivec2& high) {
    return {glm::dvec2(low) + 0.5, glm::dvec2(high) - 0.5};
}

/// The projective map of a block as the header describes it: pixels from its centre, homogeneous, from a direction.
glm::dmat3 fit(const BoostedView& view, const Centres& block) {
    const glm::dvec2 centre = 0.5 * (block.low + block.high);
    // Derivatives as secants over most of the block fit it better than tangents; single pixels need some step too.
    const glm::dvec2 step = glm::max(0.35 * (block.high - block.low), glm::dvec2(0.01));
    const auto f = [&](double x, double y) {
        return view.direction_times_ratio(centre + glm::dvec2(x * step.x, y * step.y));
    };
    const glm::dvec3 here = f(0, 0);
    const glm::dvec3 right = f(1, 0);
    const glm::dvec3 left = f(-1, 0);
    const glm::dvec3 up = f(0, 1);
    const glm::dvec3 down = f(0, -1);
    const glm::dvec3 fx = (right - left) / (2.0 * step.x);
    const glm::dvec3 fy = (up - down) / (2.0 * step.y);
    const glm::dvec3 fxx = (right - 2.0 * here + left) / (step.x * step.x);
    const glm::dvec3 fyy = (up - 2.0 * here + down) / (step.y * step.y);
    const glm::dvec3 fxy = (f(1, 1) - f(1, -1) - f(-1, 1) + f(-1, -1)) / (4.0 * step.x * step.y);
    // Rows a, b, m with u = a.f/m.f, v = b.f/m.f: a and b are dual to fx and fy; m may lean on them. Its leaning
    // makes the gradient of the area scale vanish: d/dx (u_x v_y) = a.fxx + b.fxy - 3 m.fx, likewise for y.
    const glm::dmat3 dual = glm::inverse(glm::dmat3(fx, fy, here));
    const glm::dmat3 rows = glm::transpose(dual);
    const glm::dvec3& a = rows[0];
    const glm::dvec3& b = rows[1];
    const double lean_x = (glm::dot(a, fxx) + glm::dot(b, fxy)) / 3.0;
    const double lean_y = (glm::dot(a, fxy) + glm::dot(b, fyy)) / 3.0;
    return glm::transpose(glm::dmat3(a, b, rows[2] + lean_x * a + lean_y * b));
}

/// What samples of a block say about a map fitted to it.
struct Extent {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};
    double least_stretch = std::numeric_limits<double>::infinity();
    double largest_depth = 0.0; ///< third homogeneous coordinate of unit directions
};

double least_singular_value(const glm::dvec2& a, const glm::dvec2& b) {
    const double sum = glm::dot(a, a) + glm::dot(b, b);
    const double det = a.x * b.y - a.y * b.x;
    const double root = std::sqrt(std::max(sum * sum - 4.0 * det * det, 0.0));
    return std::sqrt(std::max(0.5 * (sum - root), 0.0));
}

/// Nothing when the map folds or its plane is too oblique somewhere in the block.
std::optional<Extent> measure(const BoostedView& view, const Centres& block, const glm::dmat3& map) {
    Extent extent;
    std::array<std::array<glm::dvec2, samples>, samples> at{};
    double least_depth_found = std::numeric_limits<double>::infinity();
    const glm::dvec2 step = (block.high - block.low) / double(samples - 1);
    for (std::size_t j = 0; j < samples; ++j) {
        for (std::size_t i = 0; i < samples; ++i) {
            const glm::dvec3 n = view.direction_times_ratio(block.low + step * glm::dvec2(double(i), double(j)));
            const glm::dvec3 h = map * n;
            const double depth = h.z / glm::length(n);
            least_depth_found = std::min(least_depth_found, depth);
            extent.largest_depth = std::max(extent.largest_depth, depth);
            at[j][i] = glm::dvec2(h.x, h.y) / h.z;
            extent.low = glm::min(extent.low, at[j][i]);
            extent.high = glm::max(extent.high, at[j][i]);
        }
    }
    if (!(least_depth_found > least_depth * extent.largest_depth)) {
        return std::nullopt;
    }
    if (step.x <= 0.0 || step.y <= 0.0) {
        // One row or column of pixels, in which the map follows the warp's derivatives.
        extent.least_stretch = 1.0;
    }
    // Between samples the outline bulges by an eighth of the second difference, at most.
    glm::dvec2 bulge(0.0);
    for (std::size_t j = 0; j < samples; ++j) {
        for (std::size_t i = 1; i + 1 < samples; ++i) {
            bulge = glm::max(bulge, glm::abs(at[j][i - 1] - 2.0 * at[j][i] + at[j][i + 1]) / 8.0);
            bulge = glm::max(bulge, glm::abs(at[i - 1][j] - 2.0 * at[i][j] + at[i + 1][j]) / 8.0);
        }
    }
    extent.low -= bulge;
    extent.high += bulge;
    for (std::size_t j = 0; j + 1 < samples && step.x > 0.0 && step.y > 0.0; ++j) {
        for (std::size_t i = 0; i + 1 < samples; ++i) {
            for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
                const glm::dvec2 along_x = (at[j + side][i + 1] - at[j + side][i]) / step.x;
                const glm::dvec2 along_y = (at[j + 1][i + side] - at[j][i + side]) / step.y;
                if (along_x.x * along_y.y - along_x.y * along_y.x <= 0.0) {
                    return std::nullopt;
                }
                extent.least_stretch = std::min(extent.least_stretch, least_singular_value(along_x, along_y));
            }
        }
    }
    return extent;
}

/// Builds the tile of one block; nothing when a block that large cannot have one.
std::optional<Tile> make_tile(const BoostedView& view, double sharpness, const glm::ivec2& low,
                              const glm::ivec2& high) {
    const Centres block = centres_of(low, high);
    const RatioRange d = ratio_range(view, block.low, block.high);
    if (d.most > largest_ratio_of_d * d.least) {
        return std::nullopt;
    }
    const glm::dmat3 map = fit(view, block);
    const std::optional<Extent> extent = measure(view, block, map);
    if (!extent || extent->least_stretch < 0.05) {
        return std::nullopt;
    }
    const double scale = sharpness / extent->least_stretch;
    Tile tile;
    tile.block_low = low;
    tile.block_high = high;
    // Half a texel more on each side: filtering at the outermost centre reaches that far.
    tile.size = glm::ivec2(glm::ceil((extent->high - extent->low) * scale)) + 1 + 2 * tile_gutter;
    const glm::dvec2 offset = glm::dvec2(tile.size) * 0.5 - scale * 0.5 * (extent->low + extent->high);
    glm::dmat3 rows = glm::transpose(map);
    rows[2] /= extent->largest_depth;
    rows[0] = rows[0] * (scale / extent->largest_depth) + offset.x * rows[2];
    rows[1] = rows[1] * (scale / extent->largest_depth) + offset.y * rows[2];
    tile.texels_from_axis = glm::transpose(rows);
    return tile;
}

double cost(const Tile& tile) {
    return double(tile.size.x) * double(tile.size.y) + tile_overhead;
}

/// Appends the cheapest cut of a block into tiles and returns its cost.
double cut(const BoostedView& view, double sharpness, const glm::ivec2& low, const glm::ivec2& high,
           std::vector<Tile>& tiles) {
    const std::optional<Tile> whole = make_tile(view, sharpness, low, high);
    const glm::ivec2 size = high - low;
    const double ideal = double(size.x) * double(size.y) * sharpness * sharpness;
    const bool smallest = size.x == 1 && size.y == 1;
    if (whole && (smallest || cost(*whole) < 1.1 * ideal + 2.0 * tile_overhead)) {
        tiles.push_back(*whole);
        return cost(*whole);
    }
    if (smallest) {
        return 0.0; // the direction itself is undefined: no such pixel exists for finite rapidity
    }
    const std::size_t first = tiles.size();
    glm::ivec2 middle_high = high;
    glm::ivec2 middle_low = low;
    const glm::length_t axis = size.x >= size.y ? 0 : 1;
    middle_high[axis] = middle_low[axis] = low[axis] + size[axis] / 2;
    const double parts = cut(view, sharpness, low, middle_high, tiles) + cut(view, sharpness, middle_low, high, tiles);
    if (whole && cost(*whole) <= parts) {
        tiles.resize(first);
        tiles.push_back(*whole);
        return cost(*whole);
    }
    return parts;
}

} // namespace

TilePlan plan_plain(const BoostedView& view) {
    // Texels from the lower left corner: x = ((r.x / -r.z - middle) / half_width + 1) width / 2, homogeneous in -r.z.
    const glm::dvec2 half_size(0.5 * view.width, 0.5 * view.height);
    const glm::dvec2 axis = half_size * (1.0 - view.middle / view.half_extent);
    const glm::dvec3 depth(0.0, 0.0, -1.0);
    const glm::dmat3 texels_from_head =
        glm::transpose(glm::dmat3(glm::dvec3(half_size.x / view.half_extent.x, 0.0, 0.0) + axis.x * depth,
                                  glm::dvec3(0.0, half_size.y / view.half_extent.y, 0.0) + axis.y * depth, depth));
    TilePlan plan;
    plan.atlas_size = {view.width, view.height};
    Tile tile;
    tile.block_high = plan.atlas_size;
    tile.size = plan.atlas_size;
    tile.texels_from_axis = texels_from_head * glm::transpose(view.axis_from_head);
    plan.tiles.push_back(tile);
    plan.texels_per_pixel = 1.0;
    return plan;
}

TilePlan plan_tiles(const BoostedView& view, double sharpness, int largest_atlas) {
    TilePlan plan;
    for (double tried = sharpness;; tried *= 0.9) {
        plan.tiles.clear();
        cut(view, tried, {0, 0}, {view.width, view.height}, plan.tiles);
        std::vector<glm::ivec2> sizes;
        double texels = 0.0;
        for (const Tile& tile : plan.tiles) {
            sizes.push_back(tile.size);
            texels += double(tile.size.x) * double(tile.size.y);
        }
        const std::optional<ShelfPacking> packing = pack_into_shelves(sizes, largest_atlas);
        if (!packing) {
            continue;
        }
        for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
            plan.tiles[i].atlas_corner = packing->corners[i];
        }
        plan.atlas_size = packing->size;
        plan.texels_per_pixel = texels / (double(view.width) * double(view.height));
        plan.sharpness = tried;
        return plan;
    }
}

} // namespace render
