#pragma once

namespace sim {

/// One classical Runge-Kutta step of fixed size h. `State` needs + and (double *); `derivative(state)` gives d
/// state/ds. One template for the ship, the clocks and the light rays; it allocates nothing and calls nothing virtual.
template <class State, class Derivative>
State rk4_step(const State& y, double h, const Derivative& derivative) {
    const State k1 = derivative(y);
    const State k2 = derivative(y + (0.5 * h) * k1);
    const State k3 = derivative(y + (0.5 * h) * k2);
    const State k4 = derivative(y + h * k3);
    return y + (h / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

} // namespace sim
