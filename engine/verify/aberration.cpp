#include "engine/verify/truth_table.h"
#include "sim/readings.h"

#include <glm/geometric.hpp>

#include <cmath>

/// aberration.csv: one direction as a moving eye sees it, and where it is in the world.
namespace engine {
namespace {

/// Angle between two unit vectors, without cancellation near 0 and pi.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return 2.0 * std::atan2(glm::length(a - b), glm::length(a + b));
}

ComputedRows see_each(const content::CsvTable& table) {
    const std::size_t rapidity = table.column("rapidity");
    const std::size_t angle = table.column("theta_observer_rad");
    const glm::dvec3 ahead(0.0, 0.0, -1.0);
    ComputedRows computed;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double theta = table.number(row, angle);
        const sim::Rapidity xi(table.number(row, rapidity));
        sim::VehicleState ship;
        ship.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(xi, ahead);
        const sim::Readings readings = sim::readings(ship);
        const auto eye = sim::world_from_head(ship.world_from_vehicle, glm::dquat(1.0, 0.0, 0.0, 0.0));
        const sim::SeenLight seen = sim::see(eye, {{std::sin(theta), 0.0, -std::cos(theta)}});
        const double d = seen.wavelength_ratio;
        computed.push_back({readings.beta, readings.gamma, angle_between(seen.world_direction, ahead), d, d * d});
    }
    return computed;
}

} // namespace

TruthTable aberration_truth_table() {
    TruthTable table;
    table.name = "aberration";
    table.columns = {{"rapidity", ""},
                     {"beta", "beta"},
                     {"gamma", "gamma"},
                     {"theta_observer_rad", ""},
                     {"theta_world_rad", "theta_world_rad"},
                     {"D_wavelength_ratio", "D_wavelength_ratio"},
                     {"solid_angle_ratio_observer_over_world", "solid_angle_ratio_observer_over_world"}};
    table.tolerance = 1e-12;
    table.compute = see_each;
    return table;
}

} // namespace engine
