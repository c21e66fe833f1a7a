#pragma once

#include "content/traced/traced_scenario.h"
#include "render/offline/traced/tile_painter.h"
#include "sim/spacetime/components.h"

#include <glm/mat3x3.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace render {

/// A camera at one event of a curved spacetime. Directions are vectors of the chart (x, y, z).
struct CameraPose {
    double time = 0.0; ///< coordinate time
    glm::dvec3 position{0.0};
    glm::dvec3 velocity{0.0};       ///< relative to the scenario's observer, c = 1
    glm::dvec3 look{0.0, 1.0, 0.0}; ///< unit; of that observer, carried over by the boost
    glm::dvec3 up{0.0, 0.0, 1.0};   ///< unit, square to `look`
};

/// The scenario's camera at a moment of its path. Throws sim::BadInput when it looks straight along its up.
CameraPose camera_pose(const content::TracedScenario& scenario, double moment);

/// How exactly rays are traced.
struct TraceAccuracy {
    double error = 1e-4; ///< radians, wanted of a ray's direction where it ends
    bool tables = true;  ///< one-dimensional tables where the symmetry allows; false: every ray on its own
};

/// A curved spacetime with all that is seen in it, loaded.
class TracedScene {
  public:
    /// Throws sim::BadInput: spacetime, parameters, files.
    TracedScene(content::TracedScenario scenario, const TraceAccuracy& accuracy);
    ~TracedScene();
    TracedScene(const TracedScene&) = delete;
    TracedScene& operator=(const TracedScene&) = delete;

    /// The rays of a camera, with the step that the wanted error asks for in this picture. They keep a reference to
    /// this. Throws sim::BadInput for a camera where no observer of its kind can be: inside a singularity, outside the
    /// chart, within an object, no circular orbit.
    std::unique_ptr<RaySource> rays(const CameraPose& pose, const CameraLens& lens) const;
    /// Bundles of the same camera: the geodesic equation linearised along every step. They keep a reference to this.
    BundleMagnification magnification(const CameraPose& pose) const;
    /// How `rays` traces them, for the picture's description: "table", "Mino time on lanes", ...
    std::string method(const CameraPose& pose) const;

    const TracedSkies& skies() const { return skies_; }
    const TracedColour& colour() const { return colour_; }
    /// What was replaced or left out while loading, one line each.
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    struct Parts;
    /// How rays of a camera are followed.
    enum class Way : std::uint8_t { table, mino, mino_past_objects, generic, generic_past_matter };
    Way way(const sim::Components<double>& event) const;

    void refuse_within_objects(const sim::Components<double>& event) const;

    content::TracedScenario scenario_;
    TraceAccuracy accuracy_;
    TracedColour colour_;
    std::vector<std::string> notes_;
    std::unique_ptr<Parts> parts_;
    TracedSkies skies_;
};

} // namespace render
