#include "engine/proof/integrator_comparison.h"

#include "engine/failure.h"
#include "engine/gnuplot.h"
#include "recorded_flight.h"
#include "tests/engine/command.h"
#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace {

content::CsvTable true_flights() {
    return content::read_csv(tests::source_folder() + "/tests/reference/flights.csv");
}

const engine::IntegratorRow& row(const std::vector<engine::IntegratorRow>& rows, std::string_view name, double rate) {
    const auto found = std::ranges::find_if(
        rows, [&](const engine::IntegratorRow& r) { return r.integrator == name && r.rate == rate; });
    REQUIRE(found != rows.end());
    return *found;
}

/// Sets the search path for programs for a while.
class SearchPath {
  public:
    explicit SearchPath(const char* path) : before_(std::getenv("PATH")) { setenv("PATH", path, 1); }
    ~SearchPath() { setenv("PATH", before_.c_str(), 1); }
    SearchPath(const SearchPath&) = delete;
    SearchPath& operator=(const SearchPath&) = delete;

  private:
    std::string before_;
};

} // namespace

TEST_CASE("the record of the integrators: fourth order, exactness, and what each projection keeps") {
    const std::vector<engine::IntegratorRow> rows = engine::compare_integrators(true_flights(), 1);
    CHECK(rows.size() == 7 * engine::comparison_rates.size());

    // What flies: 1e-10 at 240 Hz is the promise, 4.3e-11 of gamma the truncation; fourth order from 30 to 240 Hz.
    const auto& flies = row(rows, engine::flying_integrator, 240.0);
    for (const engine::MotionErrors& errors : {flies.truth_table, flies.closed_forms}) {
        CHECK(errors.event < 1e-10);
        CHECK(errors.gamma < 1e-10);
        CHECK(errors.orientation < 1e-10);
    }
    const double order =
        std::log2(row(rows, engine::flying_integrator, 30.0).truth_table.event / flies.truth_table.event) / 3.0;
    CHECK(std::abs(order - 4.0) < 0.05);
    CHECK(flies.determinant_drift.value() < 1e-15); // a rounding or two
    CHECK(flies.norm_drift < 4e-15);

    for (const double rate : engine::comparison_rates) {
        // Roundings of each step at most; axes as well as the truth table's doubles fix them at gamma 1e4.
        const auto& exact = row(rows, engine::exact_integrator, rate);
        CHECK(exact.truth_table.event < 2e-14);
        CHECK(exact.closed_forms.event < 2e-14);
        CHECK(exact.closed_forms.gamma < 2e-14);
        CHECK(exact.closed_forms.orientation < 2e-13);
        CHECK(exact.truth_table.orientation < 1e-12);
        CHECK(exact.nanoseconds_a_step > 0.0);
    }
    // Scaling spreads the rounding of det, gamma * 2e-16, over Lambda: at gamma 2e8 nothing better than 1e-9 is left.
    CHECK(row(rows, "SL(2,C) RK4, scaled", 960.0).truth_table.event > 1e-9);
    CHECK(row(rows, "SL(2,C) RK4, corrected", 960.0).truth_table.event < 1e-12);
    // u.u of components as large as gamma cannot be told from zero there: normalising by it has no result.
    CHECK(std::isinf(row(rows, "four-velocity RK4, normalised", 240.0).truth_table.event));
    CHECK(row(rows, "four-velocity RK4", 15.0).norm_drift > 1e-6);
    CHECK(row(rows, "SL(2,C) RK4", 15.0).determinant_drift.value() > 1e-8);
}

TEST_CASE("bench observer writes its table and plot, and says when gnuplot is missing") {
    const recorded_flight::Folder folder;
    const std::string flights = tests::source_folder() + "/tests/reference/flights.csv";
    const std::string csv = (folder / "o.csv").string();
    const std::string plot = (folder / "it's a plot.svg").string();
    const auto bench = [&](const std::string& table) {
        return tests::rapidity(
            {"bench", "observer", "--flights", table, "--csv", csv, "--plot", plot, "--rounds", "1"});
    };
    REQUIRE(engine::has_gnuplot()); // ./check installs it
    REQUIRE(bench(flights) == 0);
    std::ifstream table(csv);
    std::string line;
    std::getline(table, line);
    CHECK(line.find("rate [steps/clock unit],time_per_step [ns],steps_per_second [1/s]") != std::string::npos);
    int rows = 0;
    while (std::getline(table, line)) {
        ++rows;
    }
    CHECK(rows == 49);
    std::ostringstream drawn;
    drawn << std::ifstream(plot).rdbuf();
    CHECK(drawn.str().find("lossless sums (flies)") != std::string::npos);

    CHECK(bench((folder / "none.csv").string()) == 2);
    CHECK_THROWS_AS(engine::run_gnuplot("no command of gnuplot\n"), engine::Failure);
    const SearchPath nothing("/nowhere");
    CHECK_FALSE(engine::has_gnuplot());
    CHECK_THROWS_AS(engine::run_gnuplot("set output\n"), engine::Failure);
}
