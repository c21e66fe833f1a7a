#include "engine/verify/truth_table.h"
#include "sim/spacetime/measured_ray.h"
#include "sim/spacetime/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

/// Light around black holes against elliptic integrals and closed forms: both kernels, the faster one's numbers first.
namespace engine {
namespace {

using sim::Components;
using std::numbers::pi;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double far_away = 1e8; // M
constexpr double ray_error = 1e-11;

/// An eye at rest that looks towards the origin with +z up.
sim::Tetrad eye_at_rest(const sim::AnySpacetime& spacetime, const Components<double>& event) {
    return std::visit(
        [&](const auto& chosen) {
            const auto u = sim::observer_velocity(chosen, event, sim::ObserverKind::at_rest);
            return sim::camera_tetrad(chosen, event, u.value(), -sim::space(event) / sim::chart_radius(event),
                                      {0.0, 0.0, 1.0});
        },
        spacetime);
}

/// The direction in the plane z = 0 from which an eye that looks towards the origin from (r, 0, 0) sees light of impact
/// parameter b = L_z/E.
glm::dvec3 direction_of(const sim::AnySpacetime& spacetime, const Components<double>& event, const sim::Tetrad& eye,
                        double b) {
    // The eye's right is the chart's +y. A photon on its way to x > 0 past y < 0 has L_z > 0: prograde light is seen on
    // the left. L_z/E is nearly -r sine; Newton's steps with that slope take what is left.
    const auto at = [](double sine) { return glm::dvec3(sine, 0.0, -std::sqrt(1.0 - sine * sine)); };
    double sine = -b / event.x;
    for (int i = 0; i < 20; ++i) {
        const auto photon =
            std::visit([&](const auto& chosen) { return sim::seen_photon(chosen, event, eye, at(sine)); }, spacetime);
        sine += (event.x * photon.momentum.y / -photon.momentum.t - b) / event.x;
    }
    return at(sine);
}

/// Total deflection of a ray of the plane z = 0 with impact parameter b = L_z/E, from infinity to infinity, as an eye
/// at r sees it. What the ray sweeps beyond r is asin(b/r) but for M b^3/(4 r^4) and a M/r^2; nearer is better for x
/// p_y, which loses r/b roundings.
double deflection(const sim::AnySpacetime& spacetime, double b, double least_r, sim::RayKernel kernel) {
    const double r = std::max(least_r, 2e3 * std::pow(std::abs(b), 0.75));
    const Components<double> event{0.0, r, 0.0, 0.0};
    const sim::Tetrad eye = eye_at_rest(spacetime, event);
    const auto measured =
        sim::measure_ray(spacetime, event, eye, direction_of(spacetime, event, eye, b), ray_error, {}, kernel);
    return std::abs(measured.swept_angle) + std::asin(std::abs(b) / r) - pi;
}

/// The largest relative error of the generic kernel over the table's one output column.
std::string generic_remark(const content::CsvTable& table, std::size_t output,
                           const std::function<double(std::size_t row)>& compute) {
    double worst = 0.0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (!table.rows[row][output].empty()) {
            const double expected = table.number(row, output);
            worst = std::max(worst, std::abs(compute(row) / expected - 1.0));
        }
    }
    return fmt::format("generic kernel: largest relative error {:.3e} in {}", worst, table.header[output]);
}

double schwarzschild_deflection(const content::CsvTable& table, std::size_t row, sim::RayKernel kernel) {
    return deflection(sim::Schwarzschild(1.0), table.number(row, table.column("b_over_M")), 1e4, kernel);
}

double kerr_deflection(const content::CsvTable& table, std::size_t row, sim::RayKernel kernel) {
    const sim::Kerr hole(1.0, table.number(row, table.column("a_over_M")));
    return deflection(hole, table.number(row, table.column("b_over_M_prograde_positive")), 1e6, kernel);
}

sim::MeasuredRay static_observer_ray(const content::CsvTable& table, std::size_t row, sim::RayKernel kernel) {
    const sim::AnySpacetime hole = sim::Schwarzschild(1.0);
    const Components<double> event{0.0, table.number(row, table.column("r_over_M")), 0.0, 0.0};
    const double psi = table.number(row, table.column("psi_from_inward_rad"));
    return sim::measure_ray(hole, event, eye_at_rest(hole, event), {std::sin(psi), 0.0, -std::cos(psi)}, ray_error, {},
                            kernel);
}

/// The edge of the shadow in the direction (alpha, beta) - centre, by bisection between light that is caught and light
/// that escapes; in units of M, as a far observer reads it off their sky.
std::vector<double> shadow_edge(double spin, double inclination, double alpha, double beta) {
    const sim::AnySpacetime hole = sim::Kerr(1.0, spin);
    const Components<double> event{0.0, far_away * std::sin(inclination), 0.0, far_away * std::cos(inclination)};
    sim::RaySettings settings;
    settings.step = 0.02;
    const sim::SkyTracer tracer(hole, event, eye_at_rest(hole, event), settings);
    // Inside every shadow: dragging moves it by about 2 a sin(i).
    const double centre = 2.0 * spin * std::sin(inclination);
    const double length = std::hypot(alpha - centre, beta);
    const auto place = [&](double distance) {
        return std::array{centre + distance * (alpha - centre) / length, distance * beta / length};
    };
    double inside = 0.0, outside = 10.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (inside + outside);
        const auto [a, b] = place(middle);
        // alpha = -L_z/(E sin i) grows to the right of one who has the spin up.
        const double x = a / far_away, y = b / far_away;
        const glm::dvec3 seen(x, y, -std::sqrt(1.0 - x * x - y * y));
        sim::SkyRay ray;
        tracer.trace({&seen, 1}, {&ray, 1});
        (ray.outcome == sim::RayOutcome::captured ? inside : outside) = middle;
    }
    const auto edge = place(0.5 * (inside + outside));
    return {edge[0], edge[1]};
}

TruthTable one_output(const std::string& name, std::vector<std::string> inputs, const std::string& output,
                      double (*compute)(const content::CsvTable&, std::size_t, sim::RayKernel)) {
    TruthTable kind;
    kind.name = name;
    for (std::string& input : inputs) {
        kind.columns.push_back({std::move(input), ""});
    }
    kind.columns.push_back({output, output});
    kind.tolerance = 1e-8;
    kind.compute = [compute](const content::CsvTable& table) {
        ComputedRows computed;
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            computed.push_back({compute(table, row, sim::RayKernel::mino)});
        }
        return computed;
    };
    kind.remarks = [compute, output](const content::CsvTable& table) {
        return std::vector{generic_remark(table, table.column(output), [&](std::size_t row) {
            return compute(table, row, sim::RayKernel::generic);
        })};
    };
    return kind;
}

} // namespace

TruthTable schwarzschild_deflection_truth_table() {
    return one_output("schwarzschild_deflection", {"b_over_M"}, "deflection_rad", schwarzschild_deflection);
}

TruthTable kerr_equatorial_deflection_truth_table() {
    return one_output("kerr_equatorial_deflection", {"a_over_M", "b_over_M_prograde_positive"}, "deflection_rad",
                      kerr_deflection);
}

TruthTable schwarzschild_static_observer_truth_table() {
    TruthTable kind;
    kind.name = "schwarzschild_static_observer";
    kind.columns = {{"r_over_M", ""},
                    {"psi_from_inward_rad", ""},
                    {"captured", "captured"},
                    {"angle_swept_rad", "angle_swept_rad"},
                    {"nu_observer_over_nu_infinity", "nu_observer_over_nu_infinity"}};
    kind.tolerance = 1e-8;
    kind.compute = [](const content::CsvTable& table) {
        ComputedRows computed;
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            const auto ray = static_observer_ray(table, row, sim::RayKernel::mino);
            const bool captured = ray.ray.outcome == sim::RayOutcome::captured;
            computed.push_back({captured ? 1.0 : 0.0, captured ? none : ray.swept_angle, ray.eye_over_energy});
        }
        return computed;
    };
    kind.remarks = [](const content::CsvTable& table) {
        return std::vector{generic_remark(table, table.column("angle_swept_rad"), [&](std::size_t row) {
            return static_observer_ray(table, row, sim::RayKernel::generic).swept_angle;
        })};
    };
    return kind;
}

TruthTable kerr_critical_curve_truth_table() {
    TruthTable kind;
    kind.name = "kerr_critical_curve";
    kind.columns = {{"a_over_M", ""},
                    {"inclination_deg", ""},
                    {"r_photon_orbit", ""},
                    {"alpha_over_M", "edge"},
                    {"beta_over_M", "edge"}};
    kind.tolerance = 1e-6; // of at least 1.5 M to at most 7 M: within 1e-5 M
    kind.compute = [](const content::CsvTable& table) {
        ComputedRows computed;
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            // Which point of the edge: the one in the direction of the row's; how far out it is, the bisection tells.
            computed.push_back(shadow_edge(table.number(row, table.column("a_over_M")),
                                           table.number(row, table.column("inclination_deg")) * pi / 180.0,
                                           table.number(row, table.column("alpha_over_M")),
                                           table.number(row, table.column("beta_over_M"))));
        }
        return computed;
    };
    return kind;
}

} // namespace engine
