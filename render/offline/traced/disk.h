#pragma once

#include <vector>

namespace render {

/// A thin accretion disk around a Kerr hole of mass 1 and spin a, |a| < 1 (a = 0: Schwarzschild): matter on circular
/// geodesics in the plane z = 0. r is the Boyer-Lindquist (and Kerr-Schild) radius. A retrograde disk around spin a is
/// a prograde one around -a. Source: Bardeen, Press, Teukolsky, ApJ 178 (1972) 347 (orbits); Page, Thorne, ApJ 191
/// (1974) 499 (flux).
namespace disk {

/// Radius of the innermost stable circular orbit, eq. 2.21 of Bardeen et al.
double innermost_stable_radius(double spin);
/// dphi/dt of the circular orbit, 1 / (r^(3/2) + a), eq. 2.16.
double angular_velocity(double spin, double r);
/// u^t of the orbit: (1 + a r^(-3/2)) / sqrt(1 - 3/r + 2 a r^(-3/2)); NaN where no time-like orbit exists.
double time_dilation(double spin, double r);
/// E_emitted / E_infinity = u^t (1 - Omega b) of light with impact parameter b = L_z / E.
double emitted_over_infinity(double spin, double r, double impact_parameter);
/// Flux from one face, up to a constant factor: Page & Thorne eq. 15n over r^... with no torque at the innermost stable
/// orbit; 0 within it.
double flux(double spin, double r);

} // namespace disk

/// The temperature over the disk's radius: (flux / largest flux)^(1/4) times the peak.
class DiskTemperature {
  public:
    DiskTemperature(double spin, double peak_temperature);
    /// Kelvin; 0 within the innermost stable orbit.
    double at(double r) const;
    double innermost_stable_radius() const { return inner_; }

  private:
    double inner_;
    std::vector<double> values_; ///< over even steps of ln(r / inner)
};

} // namespace render
