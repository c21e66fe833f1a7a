#pragma once

#include "content/scene_desc.h"
#include "render/raycast/lanes.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace render {

/// Where a ray first meets the scenery. World frame, scene metres.
struct SurfaceHit {
    std::size_t instance = 0;    ///< index into SceneDesc::instances
    std::uint32_t triangle = 0;  ///< of the instance's mesh
    double distance = 0.0;       ///< along the unit ray
    glm::dvec3 position{0.0};    ///< on the triangle's plane
    glm::dvec3 facing{0.0};      ///< unit normal of the triangle, turned towards where the ray came from
    glm::dvec3 barycentric{0.0}; ///< weights of the triangle's three vertices
};

/// Where each ray of a packet first meets the scenery, in single precision.
struct PacketHits {
    static constexpr std::uint32_t nothing = ~0u;

    Lanes distance;       ///< infinite where there is nothing
    LaneIndices instance; ///< into SceneDesc::instances, or nothing
    LaneIndices triangle; ///< of the instance's mesh
    Lanes u;              ///< barycentric weights of the triangle's second and third vertex
    Lanes v;
    Lanes3 normal; ///< of the triangle, any length, turned as its vertices are
};

/// How rays meet edges that triangles share: none slips through, or, an eighth cheaper, one in many millions may.
enum class Edges : std::uint8_t { watertight, fast };

/// The scenery's triangles, ready for rays. Embree finds the triangle in single precision; distance and barycentric
/// coordinates are then computed in double. Rays pass where a masked material is cut out,
/// and through the back of a surface that is not double-sided; its shadow falls whichever side the sun meets.
class SceneryHits {
  public:
    /// Keeps a reference: `scene` must outlive this. Throws sim::BadInput for a scene that Embree cannot hold.
    explicit SceneryHits(const content::SceneDesc& scene, Edges edges = Edges::watertight);
    ~SceneryHits();
    SceneryHits(SceneryHits&&) noexcept;
    SceneryHits& operator=(SceneryHits&&) noexcept;
    SceneryHits(const SceneryHits&) = delete;
    SceneryHits& operator=(const SceneryHits&) = delete;

    /// First surface from `origin` along the unit `direction`, at any distance.
    std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const;
    /// Whether anything stands between `origin` and a point at `distance` from it.
    bool blocked(const glm::dvec3& origin, const glm::dvec3& direction,
                 double distance = std::numeric_limits<double>::infinity()) const;

    /// The same for sixteen rays at once from one point, an order of magnitude cheaper a ray when they keep together.
    void first(const glm::vec3& origin, const Lanes3& directions, PacketHits& hits) const;
    /// Which of the `wanted` points have something between them and infinity along the unit `direction`.
    LaneMask blocked(const Lanes3& origins, const glm::vec3& direction, LaneMask wanted) const;
    /// Which of the `wanted` points have something between them and `clearance` before `point`.
    LaneMask blocked_towards(const Lanes3& origins, const glm::vec3& point, float clearance, LaneMask wanted) const;

  private:
    class Embree;
    std::unique_ptr<Embree> embree_;
};

} // namespace render
