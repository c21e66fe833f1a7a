#include "sim/retarded.h"
#include "engine/verify/truth_table.h"

#include <array>

/// retarded.csv: a uniformly moving point as a moving observer sees it.
namespace engine {
namespace {

ComputedRows see_each(const content::CsvTable& table) {
    const auto vector = [&](std::size_t row, const std::array<const char*, 3>& names) {
        return glm::dvec3(table.number(row, table.column(names[0])), table.number(row, table.column(names[1])),
                          table.number(row, table.column(names[2])));
    };
    ComputedRows computed;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const sim::InertialObject object{vector(row, {"px", "py", "pz"}), vector(row, {"vx", "vy", "vz"})};
        const sim::Event observer{table.number(row, table.column("T")), vector(row, {"ox", "oy", "oz"})};
        const sim::Emission emission = sim::retarded_emission(object, observer);
        const sim::SeenFrom seen = sim::where_seen(sim::boosted_eye(vector(row, {"ux", "uy", "uz"})), emission.from);
        const glm::dvec3& at = emission.event.space;
        const glm::dvec3& n = seen.head_direction;
        computed.push_back(
            {emission.event.t, at.x, at.y, at.z, n.x, n.y, n.z, emission.wavelength_ratio * seen.wavelength_ratio});
    }
    return computed;
}

} // namespace

TruthTable retarded_truth_table() {
    TruthTable table;
    table.name = "retarded";
    for (const char* input : {"px", "py", "pz", "vx", "vy", "vz", "T", "ox", "oy", "oz", "ux", "uy", "uz"}) {
        table.columns.push_back({input, ""});
    }
    for (const char* output : {"t_emit", "x_emit", "y_emit", "z_emit"}) {
        table.columns.push_back({output, "event of emission"});
    }
    for (const char* output : {"dir_x", "dir_y", "dir_z"}) {
        table.columns.push_back({output, "direction"});
    }
    table.columns.push_back({"D_total", "D_total"});
    table.tolerance = 1e-12;
    table.compute = see_each;
    return table;
}

} // namespace engine
