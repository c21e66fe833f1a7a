#include "render/offline/traced/disk_light.h"

#include "render/offline/traced/noise.h"
#include "sim/bad_input.h"

#include <cmath>
#include <fmt/format.h>

namespace render {
namespace {

constexpr double streaks_a_radius = 14.0; // e-folds of r to lattice cells
constexpr double streaks_a_turn = 2.0;    // cells a radian
constexpr double streaks_wound = 4.0;     // radians an e-fold of r

} // namespace

DiskLight::DiskLight(const content::TracedDisk& disk, double mass, double spin, const TracedColour& colour)
    : colour_(&colour), mass_(mass), orbit_spin_(disk.retrograde ? -spin : spin), sense_(disk.retrograde ? -1.0 : 1.0),
      inner_(disk.inner_radius), outer_(disk.outer_radius), brightness_(disk.brightness), streaks_(disk.texture),
      temperature_(orbit_spin_, disk.peak_temperature) {
    if (inner_ == 0.0) {
        inner_ = mass * temperature_.innermost_stable_radius();
    }
    if (outer_ <= inner_) {
        throw sim::BadInput("disk.outer_radius", "", fmt::format("{}", outer_),
                            fmt::format("must be more than the inner radius, {:.6g}", inner_));
    }
}

double DiskLight::angular_velocity(double r) const {
    return sense_ * disk::angular_velocity(orbit_spin_, r / mass_) / mass_;
}

glm::dvec3 DiskLight::seen(double r, double azimuth, double wavelength_ratio) const {
    const double temperature = temperature_.at(r / mass_);
    if (!(temperature > 0.0)) {
        return glm::dvec3(0.0);
    }
    double brightness = brightness_;
    if (streaks_ > 0.0) {
        // Trailing spirals: noise stretched along the turn.
        const double phase = azimuth + sense_ * streaks_wound * std::log(r);
        const glm::dvec3 point(streaks_a_radius * std::log(r), streaks_a_turn * std::cos(phase),
                               streaks_a_turn * std::sin(phase));
        brightness *= 1.0 + streaks_ * fractal_noise(point, 5, 733);
    }
    return brightness * colour_->black_body(temperature, wavelength_ratio);
}

double DiskLight::wavelength_ratio(double r, double energy, double angular_momentum) const {
    return disk::time_dilation(orbit_spin_, r / mass_) * (energy - angular_velocity(r) * angular_momentum);
}

} // namespace render
