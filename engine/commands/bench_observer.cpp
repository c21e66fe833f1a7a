#include "engine/commands/bench.h"

#include "engine/csv_output.h"
#include "engine/gnuplot.h"
#include "engine/option_values.h"
#include "engine/proof/geodesic_cost.h"
#include "engine/proof/integrator_comparison.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>

namespace engine {
namespace {

constexpr double flown_rate = 240.0;

struct Options {
    std::string flights = "tests/reference/flights.csv";
    std::string csv;
    std::string plot;
    std::string rounds = "25";
    bool markdown = false;
};

double steps_a_second(const IntegratorRow& row) {
    return 1e9 / row.nanoseconds_a_step;
}

double worst_event(const IntegratorRow& row) {
    return std::max(row.truth_table.event, row.closed_forms.event);
}

void print_table(const std::vector<IntegratorRow>& rows) {
    fmt::print(
        "speed against error of the ship's integrators; errors: largest at the ends of segments\n"
        "  flights.csv (orientation up to gamma 1e4) and closed forms (rapidity 10 out and back, ten turns at 0.8 "
        "c)\n"
        "  event: relative to its largest component; gamma: relative; axes: radians\n");
    std::string_view last;
    for (const IntegratorRow& row : rows) {
        if (row.integrator != last) {
            last = row.integrator;
            fmt::print("\n{}\n{:>5} {:>7} {:>9} | {:>8} {:>8} {:>8} | {:>8} {:>8} {:>8} | {:>8} {:>8}\n", last, "Hz",
                       "ns/step", "steps/s", "event", "gamma", "axes", "event", "gamma", "axes", "|det-1|", "|u.u+1|");
        }
        const auto errors = [](const MotionErrors& e) {
            return fmt::format("{:8.1e} {:8.1e} {:8.1e}", e.event, e.gamma, e.orientation);
        };
        fmt::print("{:5.0f} {:7.0f} {:9.3g} | {} | {} | {:>8} {:8.1e}\n", row.rate, row.nanoseconds_a_step,
                   steps_a_second(row), errors(row.truth_table), errors(row.closed_forms),
                   row.determinant_drift ? fmt::format("{:.1e}", *row.determinant_drift) : "-", row.norm_drift);
    }
}

const IntegratorRow& row_of(const std::vector<IntegratorRow>& rows, std::string_view integrator, double rate) {
    return *std::ranges::find_if(
        rows, [&](const IntegratorRow& row) { return row.integrator == integrator && row.rate == rate; });
}

/// Where the integrator that flies stands on the curve, and why it is not another one.
void print_verdict(const std::vector<IntegratorRow>& rows) {
    const IntegratorRow& flies = row_of(rows, flying_integrator, flown_rate);
    const IntegratorRow& exact = row_of(rows, exact_integrator, flown_rate);
    fmt::print("\nflies: {} at {:.0f} Hz, {:.1e} in the event for {:.0f} ns a step\n", flies.integrator, flies.rate,
               worst_event(flies), flies.nanoseconds_a_step);
    fmt::print(
        "the {} has {:.1e} for {:.0f} ns at any rate, and does not fly because\n"
        "  it knows only thrust and turn that are constant during a step, in flat spacetime, where RK4 also takes\n"
        "  light through curved spacetimes by the same code;\n"
        "  it needs roots and, for long steps, hyperbolic functions, where RK4's sums and products give the same\n"
        "  bits, and so the same replay, with every C library;\n"
        "  and {:.1e} of the way is less than a pilot's hand, held for a tick, can tell. simulate --exact uses it.\n",
        exact.integrator, worst_event(exact), exact.nanoseconds_a_step, worst_event(flies));
}

/// The README's table.
void print_markdown(const std::vector<IntegratorRow>& rows) {
    fmt::print("| integrator | ns a step | event at 60 Hz | 240 Hz | 960 Hz | gamma, axes at 240 Hz | \\|det-1\\|, "
               "\\|u.u+1\\| at 240 Hz |\n| --- | --- | --- | --- | --- | --- | --- |\n");
    for (std::size_t i = 0; i < rows.size(); i += comparison_rates.size()) {
        const auto at = [&](double rate) -> const IntegratorRow& { return row_of(rows, rows[i].integrator, rate); };
        const IntegratorRow& usual = at(flown_rate);
        const auto worst = [&](double MotionErrors::*kind) {
            return std::max(usual.truth_table.*kind, usual.closed_forms.*kind);
        };
        fmt::print("| {}{} | {:.0f} | {:.1e} | {:.1e} | {:.1e} | {:.1e}, {:.1e} | {}, {:.1e} |\n", usual.integrator,
                   usual.integrator == flying_integrator ? " (flies)" : "", usual.nanoseconds_a_step,
                   worst_event(at(60.0)), worst_event(usual), worst_event(at(960.0)), worst(&MotionErrors::gamma),
                   worst(&MotionErrors::orientation),
                   usual.determinant_drift ? fmt::format("{:.1e}", *usual.determinant_drift) : "-", usual.norm_drift);
    }
}

void write_rows(const std::string& file, const std::vector<IntegratorRow>& rows) {
    CsvOutput table{{"integrator", "rate [steps/clock unit]", "time_per_step [ns]", "steps_per_second [1/s]",
                     "flights_event [1]", "flights_gamma [1]", "flights_axes [rad]", "closed_event [1]",
                     "closed_gamma [1]", "closed_axes [rad]", "determinant_drift [1]", "norm_drift [1]"},
                    {}};
    for (const IntegratorRow& row : rows) {
        std::vector<std::string>& cells = table.rows.emplace_back();
        cells.push_back(fmt::format("\"{}\"", row.integrator)); // has commas
        for (const double value : {row.rate, row.nanoseconds_a_step, steps_a_second(row), row.truth_table.event,
                                   row.truth_table.gamma, row.truth_table.orientation, row.closed_forms.event,
                                   row.closed_forms.gamma, row.closed_forms.orientation}) {
            cells.push_back(exact_text(value));
        }
        cells.push_back(row.determinant_drift ? exact_text(*row.determinant_drift) : "");
        cells.push_back(exact_text(row.norm_drift));
    }
    write_csv(file, table);
}

/// The rows as gnuplot's data, a block an integrator: steps/s, clock units of ship time/s, error.
std::string plot_data(const std::vector<IntegratorRow>& rows) {
    std::string data = "$rows << END\n";
    std::string_view last = rows.front().integrator;
    for (const IntegratorRow& row : rows) {
        if (row.integrator != last) {
            last = row.integrator;
            data += "\n\n";
        }
        // A log axis has no zero; a rounding is the least that means anything, and what fails stands at the top.
        data += fmt::format("{} {} {}\n", steps_a_second(row), steps_a_second(row) / row.rate,
                            std::clamp(worst_event(row), 1e-16, 1.0));
    }
    return data + "END\n";
}

/// One curve an integrator: a column of plot_data against the error.
std::string plot_curves(const std::vector<IntegratorRow>& rows, int column) {
    constexpr std::array colours{"#999999", "#cc79a7", "#e69f00", "#d55e00", "#56b4e9", "#0072b2", "#009e73"};
    std::vector<std::string> curves;
    for (std::size_t i = 0; i < rows.size(); i += comparison_rates.size()) {
        const bool flies = rows[i].integrator == flying_integrator;
        curves.push_back(fmt::format("$rows index {} using {}:3 with linespoints pointtype {} linecolor rgb '{}' "
                                     "linewidth {} title {}",
                                     curves.size(), column, curves.size() + 4, colours[curves.size() % colours.size()],
                                     flies ? 3.0 : 1.5,
                                     gnuplot_text(fmt::format("{}{}", rows[i].integrator, flies ? " (flies)" : ""))));
    }
    return fmt::format("plot {}\n", fmt::join(curves, ", "));
}

std::string plot_script(const std::string& file, const std::vector<IntegratorRow>& rows) {
    return fmt::format("{}set terminal svg size 1200,620 background '#ffffff' font 'sans,13'\n"
                       "set output {}\n"
                       "set multiplot layout 1,2\n"
                       "set logscale xy\nset format x '10^{{%T}}'\nset format y '10^{{%T}}'\n"
                       "set grid linecolor rgb '#dddddd'\n"
                       "set ylabel 'largest error of the event (relative)'\nset yrange [1e-16:1]\n"
                       "set title 'Steps a second of processor time'\nset xlabel 'steps/s'\n"
                       "set xrange [1e6:1e8]\nset key off\n{}"
                       "set title 'Ship time flown a second of processor time, 15 to 960 steps a clock unit'\n"
                       "set xlabel 'clock units/s'\nset xrange [1e3:1e7]\nset key top left Left reverse\n{}"
                       "unset multiplot\n",
                       plot_data(rows), gnuplot_text(file), plot_curves(rows, 1), plot_curves(rows, 2));
}

/// The same template on rays of light.
void print_geodesics(int rounds) {
    fmt::print("\nthe same rk4_step on a ray of light, straight code without allocation or virtual call:\n");
    for (const GeodesicCost& cost : geodesic_costs(rounds)) {
        fmt::print("  {:<15} {:4.0f} ns a step\n", cost.spacetime, cost.nanoseconds_a_step);
    }
}

void bench_observer(const Options& options) {
    const int rounds = whole_number_option("--rounds", options.rounds, 1, 1000);
    const content::CsvTable flights = content::read_csv(options.flights);
    const std::vector<IntegratorRow> rows = compare_integrators(flights, rounds);
    if (options.markdown) {
        print_markdown(rows);
    } else {
        print_table(rows);
        print_verdict(rows);
        print_geodesics(rounds);
    }
    if (!options.csv.empty()) {
        write_rows(options.csv, rows);
        fmt::print("table: {}\n", options.csv);
    }
    if (!options.plot.empty()) {
        std::fflush(stdout); // before what gnuplot may say
        run_gnuplot(plot_script(options.plot, rows));
        fmt::print("plot: {}\n", options.plot);
    }
}

} // namespace

void add_bench_observer(CLI::App& bench) {
    CLI::App* command =
        bench.add_subcommand("observer", "speed against error of the ship's integrator and of others, 15 to 960 Hz");
    const auto options = std::make_shared<Options>();
    command->add_option("--flights", options->flights, "truth table of flights")->capture_default_str();
    command->add_option("--csv", options->csv, "write the table as CSV");
    command->add_option("--plot", options->plot, "draw speed against error as SVG (needs gnuplot)");
    command->add_flag("--markdown", options->markdown, "print a short table in Markdown instead");
    command->add_option("--rounds", options->rounds, "measurements of each speed, whose median counts")
        ->capture_default_str();
    command->callback([options] { bench_observer(*options); });
}

} // namespace engine
