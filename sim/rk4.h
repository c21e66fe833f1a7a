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

/// A second-order system y'' = f(y), with integrals z' = g(y) that ride along.
template <class Position, class Integral>
struct NystroemState {
    Position y;
    Position velocity; ///< y'
    Integral z;
};

/// What a second-order system's right-hand side gives.
template <class Position, class Integral>
struct NystroemRate {
    Position acceleration; ///< f(y)
    Integral z;            ///< g(y)
};

/// The same Runge-Kutta method where the force knows no velocity (Nystroem 1925): k2 and k3 fall together, so three
/// evaluations give order 4. `rate(y)` gives a NystroemRate; h is a number or one for each lane.
template <class Position, class Integral, class Step, class Rate>
NystroemState<Position, Integral> rk4_nystroem_step(const NystroemState<Position, Integral>& s, const Step& h,
                                                    const Rate& rate) {
    const Step h2 = h * h;
    const auto k1 = rate(s.y);
    const auto k2 = rate(s.y + (0.5 * h) * s.velocity + (0.125 * h2) * k1.acceleration);
    const auto k3 = rate(s.y + h * s.velocity + (0.5 * h2) * k2.acceleration);
    const Step sixth = h * Step(1.0 / 6.0);
    return {s.y + h * s.velocity + (h * sixth) * (k1.acceleration + 2.0 * k2.acceleration),
            s.velocity + sixth * (k1.acceleration + 4.0 * k2.acceleration + k3.acceleration),
            s.z + sixth * (k1.z + 4.0 * k2.z + k3.z)};
}

} // namespace sim
