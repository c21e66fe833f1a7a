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
    check_refused({{300.0, 1.0}, {360.0, 0.0}, {800.0, 0.0}, {900.0, 1.0}}, SpectrumUse::light, "no light within");
    check_refused({{550.0, 1.0}}, SpectrumUse::light, "spectrum[0][0] = 550: a light of a single sample has no width");
    check_refused({{0.4, 0.5}, {0.7, 0.5}}, SpectrumUse::reflectance, "spectrum[1][0] = 0.7: the last wavelength");
    check_refused({{0.4, 0.5}, {0.7, 0.5}}, SpectrumUse::reflectance, "are these micrometres?");
    check_refused({{13000.0, 0.5}, {20000.0, 0.5}}, SpectrumUse::reflectance, "= 13000: the first wavelength");
}

TEST_CASE("a line narrower than a nanometre is light") {
    std::vector<std::string> notes;
    const content::Spectrum line =
        content::checked_spectrum({{589.1, 0.0}, {589.3, 2.0}, {589.5, 0.0}}, SpectrumUse::light, "a", "b", notes);
    CHECK_THAT(line.at(589.2), WithinRel(0.5, 1e-12)); // half of the largest, which is made 1; a few ten roundings
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], ContainsSubstring("known from 589.1 to 589.5 nm only"));
}

TEST_CASE("a light of any brightness has its largest value at 1") {
    for (const double brightness : {1e-300, 1.0, 1e308}) {
        std::vector<std::string> notes;
        const content::Spectrum light = content::checked_spectrum({{370.0, 0.5 * brightness}, {750.0, brightness}},
                                                                  SpectrumUse::light, "a", "b", notes);
        CHECK_THAT(light.at(370.0), WithinRel(0.5, 1e-15));
        CHECK(light.at(750.0) == 1.0);
    }
}

TEST_CASE("a reflectance is held beyond 40 nm to 12 um as it is there") {
    std::vector<std::string> notes;
    const Samples samples{{20.0, 0.2}, {60.0, 0.6}, {380.0, 0.5}, {730.0, 0.5}, {10000.0, 0.0}, {14000.0, 1.0}};
    const content::Spectrum cut = content::checked_spectrum(samples, SpectrumUse::reflectance, "a", "b", notes);
    for (const auto& [nm, value] : Samples{{10.0, 0.4}, {40.0, 0.4}, {50.0, 0.5}, {12000.0, 0.5}, {1e6, 0.5}}) {
        CHECK_THAT(cut.at(nm), WithinRel(value, 1e-14));
    }
    REQUIRE_FALSE(notes.empty());
    CHECK_THAT(notes[0], ContainsSubstring("a: b: samples below 40 and above 12000 nm are left out"));
}

TEST_CASE("one sample of reflectance is a grey, and noted") {
    std::vector<std::string> notes;
    const content::Spectrum grey = content::checked_spectrum({{550.0, 0.3}}, SpectrumUse::reflectance, "a", "b", notes);
    CHECK(grey.at(100.0) == 0.3);
    CHECK(grey.at(5000.0) == 0.3);
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], ContainsSubstring("its last value is held"));
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
    const auto check = [&](const std::string& text, const std::string& words) {
        std::ofstream(file) << text;
        std::vector<std::string> notes;
        CHECK_THROWS_MATCHES(content::read_spectrum(file, SpectrumUse::reflectance, notes), sim::BadInput,
                             MessageMatches(ContainsSubstring("lamp.csv: " + words)));
    };
    const std::string header = "# measured\nwavelength_nm,value\n";
    check(header + "500,1\n550,bright\n", "line 4, value = bright: not a finite number");
    check(header + "500,1\n550,nan\n", "line 4, value = nan: not a finite number");
    check(header + "500,1\n-550,1\n", "line 4, wavelength_nm = -550: a wavelength must be positive");
    check(header + "500,1\n\n450,1\n", "line 5, wavelength_nm = 450: wavelengths must rise; the one before is 500");
    check(header + "500,1.5\n", "line 3, value = 1.5: a reflectance must not be above 1");
    check(header + "500,-1\n", "line 3, value = -1: must not be negative");
    check(header + "500\n", "line 3: 1 cells where the header has 2");
    check(header, "the spectrum is empty");
    check("", "the file is empty");
    check("500,1\n", "wavelength_nm: this column is missing");
}
