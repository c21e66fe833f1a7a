#include "sim/snapshot.h"

namespace sim {

Snapshot snapshot(const VehicleState& state) {
    Snapshot values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = state_fields[i].get(state);
    }
    return values;
}

VehicleState restore(std::span<const double, state_fields.size()> values) {
    VehicleState state;
    for (std::size_t i = 0; i < values.size(); ++i) {
        state_fields[i].set(state, values[i]);
    }
    return state;
}

} // namespace sim
