#pragma once

#include "content/traced/traced_scenario.h"
#include "render/offline/traced/disk.h"
#include "render/offline/traced/traced_colour.h"

#include <glm/vec3.hpp>

namespace render {

/// The accretion disk of a scenario around a hole of given mass and spin: what it radiates where.
class DiskLight {
  public:
    /// `spin` in units of the mass, positive about +z. Throws sim::BadInput when the disk is empty.
    DiskLight(const content::TracedDisk& disk, double mass, double spin, const TracedColour& colour);

    bool reaches(double r) const { return r >= inner_ && r <= outer_; }
    /// Coordinate angular velocity of its matter about +z; r in chart lengths, like all below.
    double angular_velocity(double r) const;
    /// Radiance as the eye sees it at D, at a place of the plane (Boyer-Lindquist's phi). The streaks are a fixed
    /// pattern.
    glm::dvec3 seen(double r, double azimuth, double wavelength_ratio) const;
    /// D of light with energy E and angular momentum L_z, both for a frequency of 1 at the eye: u^t (E - Omega L_z).
    double wavelength_ratio(double r, double energy, double angular_momentum) const;

  private:
    const TracedColour* colour_;
    double mass_;
    double orbit_spin_; ///< as the disk's matter has it: positive when it turns with the hole
    double sense_;      ///< +1 about +z, -1 about -z
    double inner_;
    double outer_;
    double brightness_;
    double streaks_;
    DiskTemperature temperature_;
};

} // namespace render
