#include "engine/verify/truth_table.h"
#include "sim/spacetime/measured_ray.h"
#include "sim/spacetime/observer.h"

#include <algorithm>
#include <cmath>

/// Light on the bridge of a warp bubble and through a wormhole.
namespace engine {
namespace {

using sim::Components;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double ray_error = 1e-13; // 1 + v cos(theta) may be 1e-5: that takes 1e-13 to 1e-8

/// What a freely falling eye sees, looking along `look` (x axis), at the angle psi from there.
sim::MeasuredRay seen_in_free_fall(const sim::AnySpacetime& spacetime, const Components<double>& event, double look,
                                   double psi) {
    const sim::Tetrad eye = std::visit(
        [&](const auto& chosen) {
            const auto u = sim::observer_velocity(chosen, event, sim::ObserverKind::free_fall);
            return sim::camera_tetrad(chosen, event, u.value(), {look, 0.0, 0.0}, {0.0, 0.0, 1.0});
        },
        spacetime);
    return sim::measure_ray(spacetime, event, eye, {std::sin(psi), 0.0, -std::cos(psi)}, ray_error);
}

ComputedRows bridge_each(const content::CsvTable& table) {
    ComputedRows computed;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double v = table.number(row, table.column("v"));
        const sim::Alcubierre bubble(v, table.number(row, table.column("R")), table.number(row, table.column("sigma")));
        const auto seen = seen_in_free_fall(bubble, {}, 1.0, table.number(row, table.column("psi_bridge_rad")));
        if (seen.ray.outcome != sim::RayOutcome::escaped) {
            computed.push_back({seen.ray.outcome == sim::RayOutcome::captured ? 1.0 : none, none, none, none});
            continue;
        }
        const double theta = sim::angle_between(seen.ray.infinity.direction, {1.0, 0.0, 0.0});
        computed.push_back({0.0, theta, seen.ray.frequency_ratio(), 1.0 + v * std::cos(theta)});
    }
    return computed;
}

ComputedRows wormhole_each(const content::CsvTable& table) {
    ComputedRows computed;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const sim::Wormhole wormhole{table.number(row, table.column("b0"))};
        const double l = table.number(row, table.column("l0"));
        const auto seen = seen_in_free_fall(wormhole, {0.0, wormhole.isotropic_radius(l), 0.0, 0.0}, -1.0,
                                            table.number(row, table.column("psi_from_throat_rad")));
        computed.push_back({static_cast<double>(seen.ray.infinity.side), seen.swept_angle});
    }
    return computed;
}

} // namespace

TruthTable warp_bridge_truth_table() {
    TruthTable kind;
    kind.name = "warp_bridge";
    kind.columns = {{"v", ""},
                    {"R", ""},
                    {"sigma", ""},
                    {"psi_bridge_rad", ""},
                    {"dark", "dark"},
                    {"theta_inf_rad", "theta_inf_rad"},
                    {"nu_bridge_over_nu_inf", "nu_bridge_over_nu_inf"},
                    {"exact_1_plus_v_cos", "exact_1_plus_v_cos"}};
    kind.tolerance = 1e-8;
    kind.compute = bridge_each;
    // The table holds twelve decimals of frequencies that may be nearly zero.
    kind.rounding = [](const std::vector<double>& expected) {
        const double smallest = std::min(expected[2], expected[3]);
        return smallest > 0.0 ? 1e-12 / smallest : 0.0;
    };
    return kind;
}

TruthTable wormhole_truth_table() {
    TruthTable kind;
    kind.name = "wormhole";
    kind.columns = {{"b0", ""},
                    {"l0", ""},
                    {"psi_from_throat_rad", ""},
                    {"final_side", "final_side"},
                    {"angle_swept_rad", "angle_swept_rad"}};
    kind.tolerance = 1e-8;
    kind.compute = wormhole_each;
    return kind;
}

} // namespace engine
