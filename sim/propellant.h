#pragma once

#include "sim/vehicle.h"

#include <cmath>

/// The relativistic rocket (Ackeret 1946): a ship that throws propellant out at the speed v loses dm/m = -a dtau / v,
/// at any speed; so ln(mass at the start / mass now) = (integral of a dtau) / v. One engine, turned where it is needed,
/// burns by the magnitude of a.
namespace sim {

/// The integral of a dtau that all of the propellant is good for; infinite where the propellant is.
inline Rapidity rapidity_budget(const VehicleSettings& settings) {
    return Rapidity(settings.exhaust_speed * std::log1p(settings.propellant));
}

/// What is left of it; never below 0.
inline Rapidity rapidity_left(const VehicleSettings& settings, const VehicleState& state) {
    return Rapidity(std::fmax(rapidity_budget(settings).value - state.rapidity_spent.value, 0.0));
}

/// Mass before over mass after a burn of this integral of a dtau.
inline double mass_ratio(const VehicleSettings& settings, Rapidity spent) {
    return std::exp(spent.value / settings.exhaust_speed);
}

/// Propellant left, in masses of the ship without it.
inline double propellant_left(const VehicleSettings& settings, const VehicleState& state) {
    return std::expm1(rapidity_left(settings, state).value / settings.exhaust_speed);
}

} // namespace sim
