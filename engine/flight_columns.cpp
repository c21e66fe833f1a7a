#include "engine/flight_columns.h"

#include "sim/state_fields.h"

#include <fmt/format.h>
#include <string_view>

namespace engine {

std::vector<std::string> flight_columns() {
    std::vector<std::string> names{"tau", "t", "x", "y", "z"};
    for (const std::string vector : {"e0", "e1", "e2", "e3"}) {
        for (const std::string component : {"_t", "_x", "_y", "_z"}) {
            names.push_back(vector + component);
        }
    }
    return names;
}

std::vector<std::string> flight_header() {
    std::vector<std::string> header = flight_columns();
    for (std::size_t i = 0; i < header.size(); ++i) {
        const std::string_view unit = i < 2 ? sim::unit_clock : i < 5 ? sim::unit_length : "1";
        header[i] += fmt::format(" [{}]", unit);
    }
    return header;
}

std::array<double, flight_column_count> flight_values(const sim::VehicleState& state) {
    std::array<double, flight_column_count> values{state.ship_clock.value, state.event.t, state.event.space.x,
                                                   state.event.space.y, state.event.space.z};
    std::size_t i = 5;
    for (const auto& vector : sim::tetrad(state.world_from_vehicle)) {
        for (const double component : {vector.t, vector.space.x, vector.space.y, vector.space.z}) {
            values[i++] = component;
        }
    }
    return values;
}

} // namespace engine
