#pragma once

#include "content/camera_path.h"
#include "render/render_frame.h"
#include "sim/cubic_spline.h"
#include "sim/quantities.h"

#include <optional>
#include <vector>

namespace engine {

/// An eye on a path: what moves between keyframes moves along C2 cubic splines (sim::CubicSpline) over the world's
/// time, so that velocity, and with it aberration and Doppler shift, changes without a kink. These are, of the
/// keyframes: the position; the rapidity vector artanh|v| v/|v| of observers' own velocities, which stays below c; the
/// look, then brought to length 1, or the place looked at, then turned to where its light is seen; the roll; the
/// logarithm of tan(field of view / 2). Modes hold from their keyframe on.
class PathCamera {
  public:
    /// `metres_per_light_unit`: scene metres in a light clock unit. Throws sim::BadInput with file and keyframe where
    /// the path is as fast as light, and for a mode that is none.
    PathCamera(content::CameraPath path, double metres_per_light_unit);

    /// World times of the first and the last keyframe, clock units.
    double first() const { return position_.times().front(); }
    double last() const { return position_.times().back(); }

    struct Pose {
        glm::dvec3 position{0.0}; ///< scene metres, world
        glm::dvec3 velocity{0.0}; ///< c, world
        sim::Lorentz<sim::World, sim::Head> world_from_head;
        double horizontal_field_of_view = 1.5707963267948966; ///< radians
        std::optional<render::Mode> mode;                     ///< none: that of the film
    };
    /// At a world time, clock units. Throws sim::BadInput where there is no direction to look in: at the very place
    /// looked at.
    Pose at(double time) const;

    /// Whether the eye's velocity is the path's: one eye travels it, and has a clock.
    bool travels() const { return !rapidity_; }
    /// What that clock has gone since the first keyframe, clock units: the integral of sqrt(1 - v^2).
    sim::ProperTime proper_time(double time) const;
    /// The world time at which the clock shows it.
    double world_time(sim::ProperTime clock) const;

    /// Whether keyframes say modes.
    bool has_modes() const;

  private:
    using Ends = sim::CubicSpline<double>::Ends;
    glm::dvec3 velocity(double time) const;
    glm::dvec3 look(const Pose& pose, double time) const;
    void refuse_faster_than_light() const;
    /// Of a part of a stretch between keyframes.
    double clock_over(double from, double to) const;

    content::CameraPath path_;
    double metres_per_light_unit_;
    sim::CubicSpline<glm::dvec3> position_; ///< light clock units
    std::optional<sim::CubicSpline<glm::dvec3>> rapidity_;
    sim::CubicSpline<glm::dvec3> sight_; ///< looks, or places looked at in light clock units
    sim::CubicSpline<double> roll_;
    sim::CubicSpline<double> log_tangent_; ///< of half the field of view
    std::vector<std::optional<render::Mode>> modes_;
    std::vector<double> clock_; ///< at the keyframes
};

} // namespace engine
