#pragma once

#include "content/traced/traced_scenario.h"
#include "render/offline/traced/panorama_pyramid.h"

#include <optional>

namespace render {

/// The world's axes (y up, as panoramas and stars have them) of a direction in the axes of a chart (z up).
inline glm::dvec3 world_from_chart(const glm::dvec3& chart) {
    return {chart.x, chart.z, -chart.y};
}

/// Light from infinity besides the stars, at rest there.
class SkyLight {
  public:
    /// Throws sim::BadInput for a panorama that cannot be read; one of the studio lights that is not there is left out
    /// and named in `notes`.
    SkyLight(const content::TracedSky& sky, std::vector<std::string>& notes);

    /// Radiance from the unit direction (chart axes), averaged over the parallelogram of two tangent vectors, radians.
    glm::dvec3 radiance(const glm::dvec3& direction, const glm::dvec3& side_u, const glm::dvec3& side_v) const;

  private:
    std::optional<PanoramaPyramid> panorama_;
    double checkerboard_;
    glm::dvec3 colour_;
};

/// Reflectance or radiance of a checkerboard of longitude and latitude with sides of `square` radians, averaged over
/// boxes of the given widths: in [0, 1], 1/2 far beyond the squares' size.
double checkerboard_share(double longitude, double latitude, double square, double longitude_width,
                          double latitude_width);

} // namespace render
