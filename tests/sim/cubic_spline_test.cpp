#include "sim/cubic_spline.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <array>
#include <vector>

using Catch::Matchers::WithinAbs;
using Spline = sim::CubicSpline<double>;

namespace {

constexpr double rounding = 1e-14; // of numbers of order 10

const std::vector<double> times{0.0, 1.0, 1.5, 4.0, 6.0};
const std::vector<double> values{0.0, 2.0, -1.0, 3.0, 3.5};

} // namespace

TEST_CASE("a spline goes through its points, and bends without a kink") {
    for (const Spline::Ends ends : {Spline::Ends::free, Spline::Ends::at_rest}) {
        const Spline spline(times, values, ends);
        for (std::size_t i = 0; i < times.size(); ++i) {
            CHECK_THAT(spline.value(times[i]), WithinAbs(values[i], rounding));
        }
        // A derivative of degree 2 has the second derivatives 2 (middle - begin) / h and 2 (end - middle) / h.
        const auto bend = [&spline](std::size_t i, bool at_end) {
            const Spline::Derivative d = spline.derivative_on(i);
            return 2.0 * (at_end ? d.end - d.middle : d.middle - d.begin) / (times[i + 1] - times[i]);
        };
        for (std::size_t i = 1; i + 1 < times.size(); ++i) {
            CHECK_THAT(spline.derivative_on(i - 1).end, WithinAbs(spline.derivative_on(i).begin, rounding));
            CHECK_THAT(bend(i - 1, true), WithinAbs(bend(i, false), 1e-13)); // divided by stretches down to 0.5
        }
        if (ends == Spline::Ends::free) {
            CHECK_THAT(bend(0, false), WithinAbs(0.0, rounding));
            CHECK_THAT(bend(times.size() - 2, true), WithinAbs(0.0, rounding));
        } else {
            CHECK(spline.derivative(times.front()) == 0.0);
            CHECK(spline.derivative(times.back()) == 0.0);
        }
    }
}

TEST_CASE("a spline of two points is uniform, or starts and stops as 3 s^2 - 2 s^3") {
    const Spline uniform({1.0, 3.0}, {5.0, 9.0}, Spline::Ends::free);
    const Spline resting({1.0, 3.0}, {5.0, 9.0}, Spline::Ends::at_rest);
    for (const double s : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
        const double time = 1.0 + 2.0 * s;
        CHECK_THAT(uniform.value(time), WithinAbs(5.0 + 4.0 * s, rounding));
        CHECK_THAT(uniform.derivative(time), WithinAbs(2.0, rounding));
        CHECK_THAT(resting.value(time), WithinAbs(5.0 + 4.0 * s * s * (3.0 - 2.0 * s), rounding));
        CHECK_THAT(resting.derivative(time), WithinAbs(2.0 * 6.0 * s * (1.0 - s), rounding));
    }
    CHECK(Spline({1.0}, {5.0}, Spline::Ends::free).value(7.0) == 5.0);
}
