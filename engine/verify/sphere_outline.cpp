#include "engine/verify/truth_table.h"
#include "sim/sky_cap.h"

#include <cmath>

/// sphere_outline.csv: the outline of a sphere at rest for a moving observer.
namespace engine {
namespace {

ComputedRows outline_each(const content::CsvTable& table) {
    const std::size_t rapidity = table.column("rapidity");
    const std::size_t centre = table.column("theta_centre_world_rad");
    const std::size_t sine = table.column("sin_half_angle_world");
    ComputedRows computed;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double theta = table.number(row, centre);
        const sim::BoostAndRotation eye{sim::Rapidity(table.number(row, rapidity)), {0.0, 0.0, -1.0}, glm::dmat3(1.0)};
        const sim::SkyCap<sim::World> sphere{{{std::sin(theta), 0.0, -std::cos(theta)}},
                                             sim::Radians(std::asin(table.number(row, sine)))};
        const sim::SkyCap<sim::Head> seen = sim::where_seen(eye, sphere);
        const glm::dvec3& axis = seen.axis.unit;
        computed.push_back({std::atan2(std::hypot(axis.x, axis.y), -axis.z), seen.half_angle.value});
    }
    return computed;
}

} // namespace

TruthTable sphere_outline_truth_table() {
    TruthTable table;
    table.name = "sphere_outline";
    table.columns = {{"rapidity", ""},
                     {"theta_centre_world_rad", ""},
                     {"sin_half_angle_world", ""},
                     {"axis_angle_observer_rad", "axis_angle_observer_rad"},
                     {"half_angle_observer_rad", "half_angle_observer_rad"}};
    table.tolerance = 1e-12;
    table.compute = outline_each;
    return table;
}

} // namespace engine
