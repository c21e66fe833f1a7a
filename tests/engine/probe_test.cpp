#include "engine/probe_plot.h"
#include "engine/probe_text.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using Catch::Matchers::WithinAbs;

TEST_CASE("the spectrum's vertical scale ends at the power of ten above the largest value") {
    const engine::RadianceAxis axis(37.0);
    CHECK(axis.label(0) == "100");
    CHECK(axis.label(2) == "1");
    CHECK(axis.label(4) == "0.01");
    CHECK(axis.label(6) == "1e-4");
    CHECK(axis.height(100.0) == 1.0);
    CHECK_THAT(axis.height(1.0), WithinAbs(1.0 - 2.0 / engine::RadianceAxis::decades, 1e-12)); // a logarithm's rounding
    CHECK(axis.height(1e-30) == 0.0);
    CHECK(axis.height(0.0) == 0.0);
    CHECK(engine::RadianceAxis(2e7).label(0) == "1e8");
    CHECK(engine::RadianceAxis(10.0).label(0) == "10");
    CHECK(engine::RadianceAxis(0.0).label(0) == "1"); // darkness
}

TEST_CASE("a probe says what its numbers are told in") {
    render::ProbedLight light;
    CHECK(engine::radiance_unit(light) == "spectral radiance, 1: white in the scene's light at 560 nm, at rest");
    light.source = render::ProbedLight::Source::star;
    CHECK(engine::radiance_unit(light) == "spectral radiance, 1: the star itself at 560 nm, at rest");
}

TEST_CASE("a probe calls rounding no shift, and darkness by its name") {
    render::ProbedLight light;
    light.emitted = [](double nm) { return 500.0 < nm && nm < 501.0 ? 1.0 : 0.0; };
    light.wavelength_ratio = 1.0 + 4e-16;
    std::vector<std::string> lines = engine::probe_lines(light);
    CHECK(lines[1] == "D 1.00: no shift");
    CHECK_THAT(lines.back(), StartsWith("strongest at 50")); // 500 or 501, in steps of 0.1 %
    light.wavelength_ratio = 0.5;
    light.emitted = [](double) { return 0.0; };
    lines = engine::probe_lines(light);
    CHECK(lines[1] == "D 0.500: blueshift");
    CHECK(lines.back() == "strongest at no wavelength emitted, no wavelength received");
}

TEST_CASE("a probe's plot holds both spectra, the visible, and where what is seen was emitted") {
    render::ProbedLight light;
    light.object = "car's door";
    light.source = render::ProbedLight::Source::surface;
    light.wavelength_ratio = 0.5;
    light.emitted = [](double nm) { return 1.0 / nm; };
    const std::string script = engine::probe_plot_script("it's.svg", light);
    CHECK_THAT(script, ContainsSubstring("set output 'it''s.svg'"));
    CHECK_THAT(script, ContainsSubstring("set title 'car''s door, 0 m away; D 0.500: blueshift'"));
    CHECK_THAT(script, ContainsSubstring("\n100 0.01 0.16\n")); // received: 2^5 of 1 / 200
    CHECK_THAT(script, ContainsSubstring("set yrange [1e-6:1e0]"));
    CHECK_THAT(script, ContainsSubstring("from first 380, graph 0 to first 385, graph 1 "));
    CHECK_THAT(script, ContainsSubstring("from first 760, graph 0 to first 770, graph 0.04 "));
}
