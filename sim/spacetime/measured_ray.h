#pragma once

#include "sim/spacetime/sky_tracer.h"

namespace sim {

/// Adds up the angle that a ray's position turns about the chart's origin, with the sign of its angular momentum at the
/// eye. A visitor for follow_ray.
class SweptAngle {
  public:
    /// `axis`: the sense of turning that counts as positive, not zero; any vector for a radial ray.
    explicit SweptAngle(const glm::dvec3& axis) : axis_(axis) {}

    Visit operator()(const RaySegment& segment) {
        turn(space(segment.from.position), space(segment.to.position));
        last_ = space(segment.to.position);
        return Visit::go_on;
    }
    /// From the last position on to the direction in which the ray's other end lies.
    double angle_with(const glm::dvec3& direction) {
        turn(last_, direction);
        return angle_;
    }
    double angle() const { return angle_; }

  private:
    void turn(const glm::dvec3& a, const glm::dvec3& b);

    glm::dvec3 axis_;
    glm::dvec3 last_{0.0};
    double angle_ = 0.0;
};

/// All that can be told about one ray.
struct MeasuredRay {
    RayResult ray; ///< error: estimated, rad; infinite when it could not be told; NaN for rays that do not escape
    RayKernel kernel = RayKernel::generic;
    double eye_over_energy = 1.0; ///< nu_eye/nu at infinity by the ray's energy -p_t, even for one that is captured
    /// Angle that its position turns about the origin on its way, on to infinity when it escapes; rad, more than a
    /// circle for rays that go round; from -2 pi when dragged against its first sense.
    double swept_angle = 0.0;
};

/// The ray that an eye sees from the unit direction `seen`, with the step (from the kernel's standard) halved until its
/// estimated error is below `error` (> 0, rad), or as far as 1/2^14.
MeasuredRay measure_ray(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                        const glm::dvec3& seen, double error, const RaySettings& settings = {},
                        RayKernel kernel = RayKernel::automatic);

} // namespace sim
