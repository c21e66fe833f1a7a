#include "render/colour/doppler_colour.h"

#include "content/csv.h"
#include "content/spectrum_data.h"
#include "render/colour/colour_space.h"
#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <filesystem>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const std::filesystem::path reference_tables = std::filesystem::path(tests::source_folder()) / "tests" / "reference";

double largest(const glm::dmat3& m) {
    double value = 0.0;
    for (int i = 0; i < 9; ++i) {
        value = std::max(value, std::abs(m[i / 3][i % 3]));
    }
    return value;
}

} // namespace

TEST_CASE("black bodies have the tristimulus values of the reference table") {
    const auto table = content::read_csv(reference_tables / "blackbody_xyz.csv");
    const render::Observer observer;
    const render::BlackBodyTable interpolated(observer);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double temperature = table.number(row, table.column("temperature_K"));
        const glm::dvec3 expected(table.number(row, table.column("X")), table.number(row, table.column("Y")),
                                  table.number(row, table.column("Z")));
        for (const render::LogXyz& xyz :
             {observer.black_body(temperature), interpolated.at_ln(std::log(temperature))}) {
            // The reference has 9 digits and the constants of CODATA 2018: 1e-7 is what rounding the exponent
            // c2 / (lambda T) to those digits leaves; the table adds its interpolation, 1e-6.
            const double y = std::exp(xyz.ln_y);
            CHECK_THAT(y, WithinRel(expected.y, 2e-6));
            CHECK_THAT(y * xyz.x_over_y, WithinRel(expected.x, 2e-6));
            CHECK_THAT(y * xyz.z_over_y, WithinAbs(expected.z, 2e-6 * (expected.z + expected.y)));
        }
    }
}

TEST_CASE("a white surface under 5762 K seen at D is that of the reference table") {
    const auto table = content::read_csv(reference_tables / "doppler_white_5762K.csv");
    const render::DopplerColour colour(5762.0);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double ratio = table.number(row, table.column("D"));
        const double expected_y = table.number(row, table.column("Y_rel"));
        const glm::dvec3 expected(table.number(row, table.column("X_rel")), expected_y,
                                  table.number(row, table.column("Z_rel")));
        const glm::dvec3 rgb = colour.matrix(render::Mode::full, std::log(ratio)) * glm::dvec3(1.0);
        const glm::dvec3 xyz = glm::inverse(colour.white().rgb_from_xyz()) * rgb;
        // 9 digits in the table, 1e-6 from interpolation.
        CHECK_THAT(xyz.y, WithinRel(expected.y, 5e-6));
        CHECK_THAT(xyz.x, WithinRel(expected.x, 5e-6));
        // Z comes out of the red with up to 400 times less than Y: rounding of the two matrices, relative to Y.
        CHECK_THAT(xyz.z, WithinAbs(expected.z, 5e-6 * (expected.z + expected.y)));
    }
}

TEST_CASE("the shifted spectrum is D^-5 L(lambda / D)") {
    // By brute force in another form: the spectrum itself, not the black body at T/D, and every term at once.
    const render::Observer observer;
    const auto primaries = content::reflectance_primaries();
    const render::DirectDopplerColour colour(5762.0);
    const render::SceneWhite white(5762.0, observer.black_body(5762.0), observer.relative_xyz(primaries, 1.0, 5762.0));
    for (const double ratio : {0.3, 0.55, 0.8, 1.25, 1.9, 4.0}) {
        const auto seen = [&](const glm::dvec3& weights) {
            return observer.xyz([&](double nm) {
                double reflectance = 0.0;
                for (std::size_t i = 0; i < 3; ++i) {
                    reflectance += weights[static_cast<int>(i)] * primaries[i].at(nm / ratio);
                }
                return std::pow(ratio, -5.0) * reflectance * content::black_body_radiance(nm / ratio, 5762.0);
            });
        };
        const glm::dvec3 red = white.rgb_from_xyz() * seen({0.7, 0.2, 0.1}) / std::exp(white.ln_y());
        // RGB at rest of that very surface, by the same integral at D = 1.
        const glm::dvec3 at_rest = white.rgb_from_xyz() * observer.xyz([&](double nm) {
            return (0.7 * primaries[0].at(nm) + 0.2 * primaries[1].at(nm) + 0.1 * primaries[2].at(nm)) *
                   content::black_body_radiance(nm, 5762.0);
        }) / std::exp(white.ln_y());
        const glm::dvec3 shifted = colour.matrix(render::Mode::full, std::log(ratio)) * at_rest;
        for (int i = 0; i < 3; ++i) {
            // Rounding only: the same sum in another order.
            CHECK_THAT(shifted[i], WithinAbs(red[i], 1e-10 * (std::abs(red.x) + std::abs(red.y) + std::abs(red.z))));
        }
    }
}

TEST_CASE("at D = 1 every colour is itself, and grey stays a black body") {
    const render::DopplerColour colour(5762.0);
    for (const render::Mode mode :
         {render::Mode::geometry, render::Mode::doppler, render::Mode::searchlight, render::Mode::full}) {
        CHECK(largest(colour.matrix(mode, 0.0) - glm::dmat3(1.0)) < 1e-13); // rounding of an inverse and two products
    }
    // The primaries sum to one, so grey keeps the shifted light's own colour: any grey is a multiple of white.
    const glm::dmat3 shifted = colour.matrix(render::Mode::full, std::log(0.7));
    const glm::dvec3 white = shifted * glm::dvec3(1.0);
    const render::LogXyz body = render::Observer().black_body(5762.0 / 0.7);
    const glm::dvec3 expected = std::exp(body.ln_y - colour.white().ln_y()) *
                                (colour.white().rgb_from_xyz() * glm::dvec3(body.x_over_y, 1.0, body.z_over_y));
    for (int i = 0; i < 3; ++i) {
        CHECK_THAT(white[i], WithinRel(expected[i], 1e-5)); // the primaries' sum in their file is 1 to 1e-6
    }
}

TEST_CASE("reflectance primaries give linear sRGB back under D65") {
    const render::Observer observer;
    const auto primaries = content::reflectance_primaries();
    const auto d65 = content::illuminant_d65();
    const auto xyz_under_d65 = [&](const content::TabulatedSpectrum& reflectance) {
        return observer.xyz([&](double nm) { return reflectance.at(nm) * d65.at(nm); });
    };
    const glm::dvec3 white = observer.xyz([&](double nm) { return d65.at(nm); });
    const glm::dmat3 rgb_from_xyz =
        render::srgb_from_xyz() * render::bradford_adaptation(white / white.y, render::d65_xyz);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 rgb = rgb_from_xyz * xyz_under_d65(primaries[static_cast<std::size_t>(i)]) / white.y;
        for (int j = 0; j < 3; ++j) {
            // Sums at 1 and at 5 nm over these piecewise linear tables differ by this much; the file was solved on
            // one of them.
            CHECK_THAT(rgb[j], WithinAbs(i == j ? 1.0 : 0.0, 2e-3));
        }
    }
}

TEST_CASE("tables agree with direct spectral integration and never leave the numbers") {
    const render::DopplerColour table(5762.0);
    const render::DirectDopplerColour direct(5762.0);
    double worst = 0.0;
    for (double ln_ratio = std::log(1e-4); ln_ratio <= std::log(1e4); ln_ratio += 0.0437) {
        for (const render::Mode mode : {render::Mode::doppler, render::Mode::full}) {
            const glm::dmat3 approximate = table.matrix(mode, ln_ratio);
            const glm::dmat3 exact = direct.matrix(mode, ln_ratio);
            CHECK(std::isfinite(largest(approximate)));
            const double scale = largest(exact);
            if (scale > 1e-12) {
                worst = std::max(worst, largest(approximate - exact) / scale);
            }
        }
    }
    // Fifty times below the 0.5 % that an eye could see; what is left is the kinks of the primaries, linear between
    // rows of 10 nm, over steps of 0.3 %.
    CHECK(worst < 1e-4);
}
