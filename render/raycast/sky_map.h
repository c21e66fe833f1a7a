#pragma once

#include "content/scene_desc.h"
#include "render/raycast/lanes.h"
#include "render/raycast/texture_pool.h"

#include <glm/vec3.hpp>

#include <vector>

namespace render {

/// A panorama as a cube with mipmaps for the CPU, at the panorama's own sharpness: faces of 2/pi of its height, 64
/// bytes a texel of them. Texels are 16-bit mantissas under a common exponent: steps of 1/65535 of the largest
/// component. Each face has a border of its neighbours' texels, so that filtering knows no seams.
class SkyMap {
  public:
    explicit SkyMap(const content::Panorama& panorama);

    /// As SkyCube's: for sky_lod in shared/sky_lod.glsl.
    float texels_per_pixel(double focal_pixels) const { return static_cast<float>(0.5 * size_ / focal_pixels); }

    /// Radiance in a world direction of any length but 0, trilinear.
    glm::vec3 radiance(const glm::vec3& direction, float level_of_detail) const;

  private:
    struct Level {
        int size = 0;          ///< of a face, without its border
        std::size_t first = 0; ///< texel of face 0
        std::size_t on_face(int face, int x, int y) const {
            const auto side = static_cast<std::size_t>(size) + 2;
            return first + (static_cast<std::size_t>(face) * side + static_cast<std::size_t>(y + 1)) * side +
                   static_cast<std::size_t>(x + 1);
        }
    };
    void fill(const content::Panorama& panorama);
    void fill_borders(const Level& level);
    void halve(const Level& fine, const Level& coarse);
    glm::vec3 texel(std::size_t at) const;
    glm::vec3 bilinear(const Level& level, int face, float s, float t) const;

    int size_;
    std::vector<Level> levels_;
    std::vector<PackedFour> texels_;
};

} // namespace render
