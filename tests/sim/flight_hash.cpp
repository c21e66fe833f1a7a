#include "sim/state_hash.h"

#include <cmath>
#include <cstdio>

/// Prints the state's hash every ten thousand ticks of a long flight that tumbles, boosts and brakes: what two builds
/// of sim must agree about.
int main() {
    sim::VehicleSettings settings;
    settings.maximum_acceleration = {0.6, 0.5, 1.1};
    settings.maximum_turn_rate = {1.5, 1.0, 0.7};
    sim::VehicleState state;
    for (int i = 1; i <= 100000; ++i) {
        const int phase = (i / 600) % 5;
        const double way = phase % 2 == 0 ? 1.0 : -1.0;
        sim::ControlFrame control;
        control.proper_acceleration = {0.7 * way, 0.1 * phase, -way};
        control.angular_velocity = {0.3, 0.11 * phase, -0.9 * way};
        control.buttons = phase == 2 ? sim::ControlFrame::boost : phase == 4 ? sim::ControlFrame::brake : 0u;
        state = sim::advance(state, settings, control);
        if (i % 10000 == 0) {
            std::printf("%d %016llx\n", i, static_cast<unsigned long long>(sim::state_hash(state)));
        }
    }
    return std::isfinite(state.event.t) ? 0 : 1;
}
