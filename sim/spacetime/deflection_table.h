#pragma once

#include "sim/spacetime/sky_tracer.h"

#include <array>
#include <vector>

namespace sim {

/// All that one eye sees of the sky at infinity, from a table over one angle: where the spacetime is symmetric about an
/// axis through the event (spherical ones everywhere, the warp bubble on its line of flight), light seen at the angle
/// psi from the axis comes from the angle Theta(psi) in the same plane. The table is that of an observer in free fall
/// along the axis; any other eye at the event sees its sky aberrated (a Lorentz transformation from tetrad to tetrad),
/// however it moves. The frequency follows from the constant -p.xi of the Killing vector xi = d_t + v d_x, v the
/// bubble's speed or 0.
///
/// Theta is tabulated over ln |psi - psi_c| on both sides of the edge psi_c of the shadow, the wormhole's mouth or the
/// cone behind a fast bubble, so that images of all orders are as exact; cubic between the nodes.
class DeflectionTable {
  public:
    /// Whether there is such an axis through the event, with one edge at most on its sky: in a bubble, within half its
    /// radius of the bridge, for from outside light is lost and found again more than once.
    static bool fits(const AnySpacetime& spacetime, const Components<double>& event);

    /// Doubles the number of nodes until rays traced halfway between them are met to `error` (> 0, rad), or to 2^15
    /// nodes a side. `settings.step` is chosen here. Precondition: fits.
    DeflectionTable(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                    const RaySettings& settings, double error = 1e-7);

    /// As SkyTracer::trace; the rays have no steps and no drift.
    void trace(std::span<const glm::dvec3> seen, std::span<SkyRay> rays) const;

    /// The largest difference from traced rays found halfway between nodes, rad, for rays further than 1e-6 rad from
    /// the edge: nearer ones are themselves not known so well.
    double error() const { return error_; }
    /// On each side of the edge.
    std::size_t nodes() const { return nodes_; }

  private:
    /// One side of the edge. All its rays end alike.
    struct Branch {
        RayOutcome outcome = RayOutcome::captured;
        int side = 1;
        double first_ln = 0.0; ///< of |psi - psi_c| at the first node
        double step_ln = 1.0;
        std::vector<double> theta; ///< Theta unwrapped; empty where nothing escapes
    };

    SkyRay ray_at(double psi) const;
    std::vector<SkyRay> rays_at(std::span<const double> psi) const;
    double theta_of(const SkyRay& ray) const;
    double find_edge() const;
    Branch branch(double end) const;
    double interpolated(const Branch& branch, double distance) const;
    double measured_error(const Branch& branch, double sign) const;

    glm::dvec3 outward_; ///< the axis in the chart, unit; psi and Theta are counted from -outward and outward
    std::array<glm::dvec3, 2> across_;
    SkyTracer tracer_;                               ///< of the falling observer: looks along -outward, up is across[1]
    std::array<LinearInDirection, 4> fall_from_eye_; ///< the photon's components in the falling tetrad
    LinearInDirection constant_;                     ///< -p.xi
    double speed_ = 0.0;                             ///< v
    double edge_ = 0.0;                              ///< psi_c
    std::size_t nodes_ = 512;
    Branch inner_; ///< psi below the edge
    Branch outer_;
    double error_ = 0.0;
};

} // namespace sim
