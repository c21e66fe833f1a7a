#pragma once

#include "render/offline/traced/traced_ray.h"
#include "sim/spacetime/sky_tracer.h"

#include <array>
#include <optional>
#include <vector>

namespace render {

/// How an eye's sky is symmetric about the radial direction of a spherical spacetime: a ray at the angle psi from the
/// inward direction of the head comes from the angle Theta(psi) from the outward direction of the chart, in the same
/// plane.
struct RadialSymmetry {
    glm::dvec3 head_outward; ///< unit, and two unit directions square to it
    std::array<glm::dvec3, 2> head_across;
    glm::dvec3 chart_outward; ///< and what they are in the chart
    std::array<glm::dvec3, 2> chart_across;
};

/// The symmetry of an eye that is at rest or moves along the radius; nothing for other motions.
std::optional<RadialSymmetry> radial_symmetry(const sim::AnySpacetime& spacetime, const sim::Components<double>& event,
                                              const sim::Tetrad& tetrad);

/// Theta over psi as a table in ln |psi - psi_c| on both sides of the edge psi_c of the shadow, or of the wormhole's
/// mouth, so that images of all orders are as exact; cubic between its nodes. The frequency ratio of a stationary
/// spacetime is linear in the direction and needs two rays.
class DeflectionTable : public RaySource {
  public:
    /// Traces the nodes with `tracer`. Its step is chosen here for an error of 1e-9.
    DeflectionTable(sim::SkyTracer tracer, const RadialSymmetry& symmetry);

    void trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
               std::size_t error_every) const override;

    /// The largest difference from traced rays found halfway between nodes, radians, nearest to the edge apart.
    double error() const { return error_; }

  private:
    struct Branch {
        bool escapes = false; ///< else it is dark
        RayFate fate = RayFate::captured;
        double first_ln = 0.0; ///< of |psi - psi_c| at the first node
        double step_ln = 1.0;
        std::vector<double> theta; ///< unwrapped
    };

    sim::SkyRay ray_at(double psi) const;
    double theta_of(const sim::SkyRay& ray) const;
    double find_edge() const;
    Branch branch(double edge, double end) const;
    double interpolated(const Branch& branch, double distance) const;
    double measured_error() const;

    sim::SkyTracer tracer_;
    RadialSymmetry symmetry_;
    double edge_ = 0.0;
    Branch inner_; ///< psi below the edge
    Branch outer_;
    double frequency_constant_ = 1.0; ///< D = constant - slope cos psi
    double frequency_slope_ = 0.0;
    double error_ = 0.0;
};

} // namespace render
