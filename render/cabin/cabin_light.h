#pragma once

#include "content/scene_desc.h"
#include "render/cabin/surroundings.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace render {

/// Light from all around in coarse directions: a cube around the cabin, each face in 8 x 8 parts, 11 degrees wide.
class LightFromAround {
  public:
    static constexpr int face_side = 8;
    static constexpr std::size_t directions = std::size_t{6} * face_side * face_side;

    /// No light.
    LightFromAround() = default;
    /// The same light from everywhere.
    explicit LightFromAround(const glm::vec3& radiance);

    /// Adds the samples times `weight`, turned by `cabin_from_boosted`; each is shared out among the four parts whose
    /// middles are around it, so that what moves smoothly lights smoothly.
    void add(const std::vector<SeenLightSample>& samples, const glm::dmat3& cabin_from_boosted, float weight = 1.0f);

    /// Radiance from a unit direction, cabin frame, smoothly between the parts.
    glm::vec3 radiance_from(const glm::vec3& direction) const;

    /// Radiance times solid angle, by part.
    const std::array<glm::vec3, directions>& power() const { return power_; }

  private:
    std::array<glm::vec3, directions> power_{};
};

/// Middle of a part, unit.
glm::dvec3 light_direction(std::size_t part);

/// How a cabin is lit from outside: how much of each direction every vertex sees past the rest of the cabin, computed
/// once, and what comes of any light. Surfaces are matte. What no light from outside reaches gets the cabin's own mean
/// light once more (one bounce, evenly).
class CabinLight {
  public:
    /// Vertex colours are reflectances. Rays are cast on all processors.
    explicit CabinLight(const content::Mesh& cabin);

    /// Irradiance of each vertex straight from outside, over its reflectance's channels' light.
    std::vector<glm::vec3> irradiance(const LightFromAround& light) const;
    /// Radiance that each vertex sends out.
    std::vector<glm::vec3> radiance(const LightFromAround& light) const;

    const std::vector<float>& openness() const { return openness_; }
    /// Share of the even light of a whole sky that reaches a vertex, in [0, 1].
    float openness(std::size_t vertex) const { return openness_[vertex]; }

  private:
    std::vector<glm::vec3> reflectance_;
    std::vector<float> area_;     ///< of the triangles around a vertex, a third of each
    std::vector<float> openness_; ///< by vertex
    std::vector<float> share_;    ///< cosine where nothing is in the way, else 0: by direction, then vertex
};

} // namespace render
