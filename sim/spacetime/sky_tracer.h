#pragma once

#include "sim/spacetime/mino.h"

#include <vector>

namespace sim {

/// The kernels that follow light. Their steps differ: each is fixed in its own parameter.
enum class RayKernel : std::uint8_t {
    automatic, ///< mino where it fits, else generic
    generic,   ///< Hamilton's equations of any metric
    mino,      ///< holes in Mino time
};

/// Steps that each kernel takes when nobody asks for an error: about 1e-5 rad away from the orbit of light.
double standard_step(RayKernel kernel);

/// What one eye sees of the sky at infinity: both kernels behind one interface. Holds copies of all it needs; `trace`
/// may be called from several threads at once.
class SkyTracer {
  public:
    /// `settings.step` is the kernel's. Throws std::invalid_argument when mino is asked for and does not fit.
    SkyTracer(AnySpacetime spacetime, const Components<double>& event, const Tetrad& tetrad,
              const RaySettings& settings, RayKernel kernel = RayKernel::automatic,
              Precision precision = Precision::double_precision);

    /// The rays seen from the unit directions `seen` (right, up, back), into as many `rays`. `crossings`: empty, or as
    /// many where `gives_crossings`.
    void trace(std::span<const glm::dvec3> seen, std::span<SkyRay> rays,
               std::span<PlaneCrossings> crossings = {}) const;

    /// As `trace`, each ray with its own step: halved until the estimated error of the direction is below `error`
    /// (> 0, rad), at most `most_halvings` times. `errors`: what was reached, infinite where outcomes still differ and
    /// 0 for captured rays. Returns how many rays did not reach it.
    std::size_t trace_to_error(std::span<const glm::dvec3> seen, double error, std::span<SkyRay> rays,
                               std::span<double> errors, int most_halvings = 12) const;

    /// Sets the step so that of the rays `sample` (not empty) the given share (0 to 1) has an estimated error below
    /// `error`, and returns it. Captured rays do not count.
    double choose_step(std::span<const glm::dvec3> sample, double error, double share = 0.99);

    RayKernel kernel() const { return mino_ ? RayKernel::mino : RayKernel::generic; }
    bool gives_crossings() const { return mino_.has_value(); }
    const RaySettings& settings() const { return settings_; }

  private:
    void trace_with_step(double step, std::span<const glm::dvec3> seen, std::span<SkyRay> rays,
                         std::span<PlaneCrossings> crossings) const;

    AnySpacetime spacetime_;
    Components<double> event_;
    Tetrad tetrad_;
    RaySettings settings_;
    Precision precision_;
    std::optional<MinoEye> mino_;
};

/// The halved step's error by comparison with the whole step's: twice 1/15 of the angle between them (order 4), or of
/// the relative difference in frequency where that is more. Infinite when the outcomes differ, 0 for two captures.
double estimated_error(const SkyRay& whole, const SkyRay& halved);

} // namespace sim
