#pragma once

#include "content/scene_desc.h"
#include "render/colour/star_photometry.h"
#include "render/offline/traced/projection.h"
#include "render/offline/traced/traced_colour.h"
#include "render/offline/traced/traced_ray.h"
#include "render/offline/traced/traced_tile.h"

#include <array>
#include <vector>

namespace render {

/// The star catalogue at infinity, by where on the sky, for images of stars as true points: gravity changes their
/// number, places and brightness, never their size.
class StarField {
  public:
    /// `scale`: factor on their light. As seen from the catalogue's origin, the Sun.
    StarField(const std::vector<content::Star>& stars, const TracedColour& colour, double scale);

    /// A star's image in a picture.
    struct Image {
        std::size_t star = 0;
        glm::dvec2 place{0.0};      ///< pixels from the left and top
        double magnification = 1.0; ///< solid angle seen by the eye / solid angle on the sky
        double wavelength_ratio = 1.0;
    };
    /// All images whose place lies in the tile or up to a footprint outside. Candidates come from the map of a grid of
    /// rays, one a pixel corner: stars in a triangle of their directions. Newton's method on rays of their own then
    /// puts each where its ray comes from, and `magnification` says how bright it is. Cells across which the sky turns
    /// by more than a fifth of a radian, at the photon ring, are left out: images there are dimmed below 1e-5.
    std::vector<Image> images(const CameraLens& lens, const RaySource& rays, const BundleMagnification& magnification,
                              RayFate sky, const TracedTile& tile) const;

    /// Adds the images' light to the tile, each spread over a few pixels as the flight's stars are (shared/star.glsl).
    void add(const std::vector<Image>& images, const CameraLens& lens, TracedTile& tile) const;

  private:
    struct Star {
        glm::dvec3 direction; ///< unit, chart axes
        double distance;      ///< light-years
        double magnitude;     ///< visual, from the Sun
        StarSource source;
    };
    std::vector<Image> candidates(const CameraLens& lens, const RaySource& rays, RayFate sky,
                                  const TracedTile& tile) const;
    std::vector<std::size_t> near(const glm::dvec3& direction, double angle) const;

    const TracedColour& colour_;
    double scale_;
    std::vector<Star> stars_;
    std::vector<std::vector<std::size_t>> bins_; ///< by latitude and longitude
};

} // namespace render
