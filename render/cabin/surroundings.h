#pragma once

#include "render/render_frame.h"
#include "sim/lorentz.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <vector>

/// What is seen all around a moving eye, coarsely: the light that falls on whatever is at rest with it.
///
/// Small pictures are taken by the renderer itself, so that aberration, Doppler shift and searchlight are what is seen:
/// six faces of a cube turned towards where the eye is going, and within the one ahead further views, each half as
/// wide. At rapidity xi half the world's sky is gathered within an angle of 2 e^-xi; each of the nested views adds one
/// ln 2 to the rapidity that is sampled as finely as at rest.
namespace render {

/// One of those pictures: square, seen through a pinhole.
struct SurroundingsView {
    /// Rotation: columns are the view's right, up and back in the boosted frame (the world's axes carried by the
    /// boost).
    glm::dmat3 boosted_from_view{1.0};
    double half_width = 1.0;    ///< tangent from its middle to an edge
    double left_out_to = 0.0;   ///< tangent: what lies within is another view's; 0: nothing
    double brightness_to = 1.0; ///< estimate of the brightest seen in it, in units of the same at rest
};

/// Pixels along each side of such a picture.
inline constexpr int surroundings_side = 16;

/// The views that cover all directions of an eye that moves like this. In modes without the searchlight the brightness
/// is as at rest.
std::vector<SurroundingsView> surroundings_views(const sim::BoostAndRotation& eye, Mode mode);

/// Stops on radiance that would show the scene at rest as bright as `stops` show what this eye looks at.
double stops_at_rest(double stops, const sim::BoostAndRotation& eye, Mode mode);

/// The frame to render for a view; everything that is not the view's own is `frame`'s. Its exposure keeps the picture
/// within half floats, given stops_at_rest().
RenderFrame surroundings_frame(const RenderFrame& frame, const sim::BoostAndRotation& eye, const SurroundingsView& view,
                               double stops_at_rest);

/// Light from one direction.
struct SeenLightSample {
    glm::vec3 direction{0.0f}; ///< unit, where it is seen coming from, boosted frame
    glm::vec3 power{0.0f};     ///< radiance times solid angle, linear sRGB
};

/// Adds what a view shows. `picture`: of surroundings_frame; `exposure_stops`: that frame's.
void add_samples(const SurroundingsView& view, const Picture& picture, double exposure_stops,
                 std::vector<SeenLightSample>& samples);

/// Irradiance of a surface square to the unit `normal` (same frame as the samples') under all that is before it.
glm::dvec3 irradiance(const std::vector<SeenLightSample>& samples, const glm::dvec3& normal);

} // namespace render
