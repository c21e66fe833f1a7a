#include "content/spectrum.h"
#include "content/spectrum_input.h"
#include "sim/bad_input.h"
#include "tests/content/temporary_folder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <fstream>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinRel;
using content::SpectrumUse;

namespace {

using Samples = std::vector<std::pair<double, double>>;

void check_refused(const Samples& samples, SpectrumUse use, const std::string& words) {
    std::vector<std::string> notes;
    CHECK_THROWS_MATCHES(content::checked_spectrum(samples, use, "lamp.csv", "spectrum", notes), sim::BadInput,
                         MessageMatches(ContainsSubstring("lamp.csv") && ContainsSubstring(words)));
}

} // namespace

TEST_CASE("spectra add up and multiply wavelength by wavelength") {
    const content::Spectrum ramp(content::SampledSpectrum{{400.0, 500.0, 700.0}, {0.0, 1.0, 0.5}});
    const content::Spectrum body(content::BlackBody{5000.0});
    const double planck = content::black_body_radiance(450.0, 5000.0);
    CHECK(ramp.at(450.0) == 0.5);
    CHECK(ramp.at(600.0) == 0.75);
    CHECK(ramp.at(399.0) == 0.0);
    CHECK_THAT((2.0 * (ramp * body) + body).at(450.0), WithinRel(2.0 * planck, 1e-15));
    CHECK(body.black_body_kelvin() == 5000.0);
    CHECK_FALSE((ramp * body).black_body_kelvin());
    CHECK((ramp * body).shortest_nm() == 400.0);
    CHECK((ramp * body).longest_nm() == 700.0);
}

TEST_CASE("samples that are no spectrum are refused by value") {
    check_refused({}, SpectrumUse::light, "empty");
    check_refused({{-400.0, 1.0}}, SpectrumUse::light, "-400");
    check_refused({{500.0, 1.0}, {450.0, 1.0}}, SpectrumUse::light, "450");
    check_refused({{500.0, 1.0}, {500.0, 1.0}}, SpectrumUse::light, "must rise");
    check_refused({{500.0, 1.0}, {600.0, -0.5}}, SpectrumUse::reflectance, "-0.5");
    check_refused({{500.0, 0.3}, {600.0, 1.25}}, SpectrumUse::reflectance, "1.25");
    check_refused({{200.0, 1.0}, {300.0, 1.0}}, SpectrumUse::light, "no light within");
}

TEST_CASE("gaps in a spectrum are noted") {
    std::vector<std::string> notes;
    content::checked_spectrum({{370.0, 0.2}, {450.0, 0.4}, {500.0, 0.4}, {740.0, 0.1}}, SpectrumUse::reflectance, "a",
                              "b", notes);
    REQUIRE(notes.size() == 2);
    CHECK_THAT(notes[0], ContainsSubstring("gap from 370 to 450"));
    CHECK_THAT(notes[1], ContainsSubstring("gap from 500 to 740"));
}

TEST_CASE("a spectrum's file says which line is wrong") {
    const samples::TemporaryFolder folder;
    const auto file = folder.path() / "lamp.csv";
    std::ofstream(file) << "wavelength_nm,value\n500,1\n550,bright\n";
    std::vector<std::string> notes;
    CHECK_THROWS_MATCHES(content::read_spectrum(file, SpectrumUse::light, notes), sim::BadInput,
                         MessageMatches(ContainsSubstring("line 3") && ContainsSubstring("bright")));
    std::ofstream(file) << "";
    CHECK_THROWS_MATCHES(content::read_spectrum(file, SpectrumUse::light, notes), sim::BadInput,
                         MessageMatches(ContainsSubstring("empty")));
}
