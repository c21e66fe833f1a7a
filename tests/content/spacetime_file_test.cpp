#include "content/spacetime_file.h"

#include "sim/bad_input.h"
#include "sim/spacetime/measured_ray.h"
#include "sim/spacetime/observer.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <filesystem>
#include <fstream>
#include <random>

using Catch::Matchers::ContainsSubstring;

namespace {

namespace fs = std::filesystem;

class File {
  public:
    explicit File(const std::string& text) { std::ofstream(path_) << text; }
    ~File() { fs::remove(path_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    std::string name() const { return path_.string(); }

  private:
    fs::path path_ =
        fs::temp_directory_path() / ("rapidity-spacetime-" + std::to_string(std::random_device()()) + ".toml");
};

/// Schwarzschild in isotropic coordinates, a chart that the program has nowhere else.
const std::string isotropic = R"toml(name = "Schwarzschild, isotropic"
flat_radius = 3e4
[parameters]
M = 2.0
[definitions]
rho = "sqrt(x^2 + y^2 + z^2)"
q = "M/(2*rho)"
spatial = "(1 + q)^4"
[metric]
tt = "-((1 - q)/(1 + q))^2"
xx = "spatial"
yy = "spatial"
zz = "spatial"
)toml";

std::string replaced(std::string text, const std::string& old, const std::string& with) {
    text.replace(text.find(old), old.size(), with);
    return text;
}

std::string refusal(const std::string& text, const sim::ParameterValues& given = {}) {
    const File file(text);
    try {
        content::read_spacetime(file.name(), given);
    } catch (const sim::BadInput& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST_CASE("a user's own metric bends light as the built-in chart of the same hole does") {
    const File file(isotropic);
    const auto custom = content::read_spacetime(file.name(), {{"M", 1.0}});
    // reference/schwarzschild_static_observer.csv: at r = 10, psi = 1 and 2 from the inward direction.
    const double r = 10.0;
    const double rho = 0.5 * (r - 1.0 + std::sqrt(r * r - 2.0 * r));
    const sim::Components<double> event{0.0, rho, 0.0, 0.0};
    const auto u = sim::observer_velocity(custom, event, sim::ObserverKind::at_rest);
    const auto eye = sim::camera_tetrad(custom, event, u.value(), {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    for (const auto& [psi, swept] : {std::pair{1.0, 2.66000410131596271}, {2.0, 1.2969414231071171}}) {
        const auto ray = sim::measure_ray(custom, event, eye, {std::sin(psi), 0.0, -std::cos(psi)}, 1e-9);
        CHECK(ray.ray.outcome == sim::RayOutcome::escaped);
        // Not flat beyond 3e4 M yet: 2 M b/r^2 = 2e-8 is left.
        CHECK(std::abs(ray.swept_angle - swept) < 5e-8);
        CHECK(std::abs(ray.ray.frequency_ratio() - 1.0 / std::sqrt(0.8)) < 1e-12);
        CHECK(ray.ray.drifts[0] < 1e-12); // nothing depends on t
    }
    // Towards the hole: a horizon, known by its blueshift alone.
    const auto caught = sim::measure_ray(custom, event, eye, {0.1, 0.0, -std::sqrt(0.99)}, 1e-6);
    CHECK(caught.ray.outcome == sim::RayOutcome::captured);
}

TEST_CASE("automatic differentiation of a formula is the metric's derivative") {
    const File file(isotropic);
    const auto custom = content::read_spacetime(file.name());
    const sim::GeodesicState<double> state{{0.0, 5.0, 3.0, -2.0}, {-1.0, 0.4, -0.7, 0.3}};
    const auto rate = sim::hamilton_equations(custom, state);
    for (int mu = 0; mu < 4; ++mu) {
        const auto at = [&](double step) {
            auto moved = state;
            moved.position[mu] += step;
            return sim::hamiltonian(custom, moved);
        };
        const double h = 1e-3; // fourth order: 1e-12 of the fifth derivative, and 1e-13 by rounding
        const double slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
        CHECK(std::abs(rate.momentum[mu] + slope) < 1e-11);
    }
}

TEST_CASE("a metric that cannot be is refused by file, key and text") {
    CHECK_THAT(refusal(replaced(isotropic, "M/(2*rho)", "M/(2*rhp)")),
               ContainsSubstring("rhp is not known; did you mean rho"));
    CHECK_THAT(refusal(replaced(isotropic, "sqrt(x^2", "sqrt(q^2")), ContainsSubstring("needs itself"));
    CHECK_THAT(refusal(replaced(isotropic, "tt = \"-((", "tt = \"((")), ContainsSubstring("signature"));
    CHECK_THAT(refusal(replaced(isotropic, "zz = \"spatial\"\n", "")), ContainsSubstring("metric.zz"));
    CHECK_THAT(refusal(replaced(isotropic, "xx = \"spatial\"", "xx = \"spatial +\"")), ContainsSubstring("breaks off"));
    CHECK_THAT(refusal(replaced(isotropic, "xx = \"spatial\"", "xx = \"spatial^0.5\"")),
               ContainsSubstring("whole number"));
    CHECK_THAT(refusal(replaced(isotropic, "xx = \"spatial\"", "xx = \"2*spatial\"")), ContainsSubstring("metric.xx"));
    CHECK_THAT(refusal(replaced(isotropic, "flat_radius", "flat_radios")),
               ContainsSubstring("did you mean flat_radius"));
    CHECK_THAT(refusal(replaced(isotropic, "M = 2.0", "M = \"a\"")), ContainsSubstring("parameters.M"));
    CHECK_THAT(refusal(isotropic, {{"spin", 0.5}}), ContainsSubstring("spin"));
    CHECK_THAT(refusal("[metric"), ContainsSubstring("line 1"));
    CHECK(refusal(isotropic).empty());
    CHECK_THROWS_AS(content::read_spacetime("no-such-file.toml"), sim::BadInput);
}
