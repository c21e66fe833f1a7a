#pragma once

#include "render/render_frame.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace render {

/// An eye's view split for the warp: rotations in double precision, and one number for the boost.
///
/// Axis frame: the boosted frame (or, for world directions, the world) turned so that z is the direction of motion.
/// World directions appear multiplied by D, which keeps them algebraic in the eye ray (RENDERING, 'Formulas').
struct BoostedView {
    glm::dmat3 axis_from_head{1.0};
    glm::dmat3 axis_from_world{1.0};
    double exp_rapidity = 1.0;
    double rapidity = 0.0;
    glm::dvec2 half_extent{1.0}; ///< half the screen's width and height, as tangents
    glm::dvec2 middle{0.0};      ///< of the screen, tangents from the eye's axis, x right and y up
    int width = 0;
    int height = 0;

    /// Unit eye ray, axis frame, of a point on the screen in pixels from the lower left corner.
    glm::dvec3 seen(const glm::dvec2& pixel) const;
    /// World direction times D, axis frame, that is seen at a point on the screen. Its length is D.
    glm::dvec3 direction_times_ratio(const glm::dvec2& pixel) const;
};

BoostedView boosted_view(const EyeView& eye);

/// The same for single precision, as shared/pixel_ray.glsl wants it: the unnormalised eye ray of a point is
/// origin + x right + y up, in the axis frame, x and y pixels from the lower left corner.
struct ScreenRays {
    glm::vec3 origin{0.0f};
    glm::vec3 right{0.0f};
    glm::vec3 up{0.0f};
    float exp_rapidity = 1.0f;
    glm::mat3 world_from_axis{1.0f};
};

ScreenRays screen_rays(const BoostedView& view);

/// Smallest and largest D.
struct RatioRange {
    double least = 1.0;
    double most = 1.0;
};

/// The range of D over a rectangle of the screen (pixels), exactly: D depends only on the angle to the axis, whose
/// extremes lie at corners, where an edge passes the axis closest, or at the axis itself.
RatioRange ratio_range(const BoostedView& view, const glm::dvec2& low, const glm::dvec2& high);

/// n D for a unit eye ray, both in the axis frame; e^xi given.
glm::dvec3 direction_times_ratio(const glm::dvec3& seen, double exp_rapidity);

} // namespace render
