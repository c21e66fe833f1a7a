#include "render/colour/scene_colour.h"

#include "render/colour/colour_difference.h"
#include "render/colour/frame_colour_table.h"
#include "render/offline/seen_colour.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <glm/geometric.hpp>

#include <cmath>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

content::Spectrum sodium_lamp() {
    return content::Spectrum(content::SampledSpectrum{{585.0, 589.0, 593.0}, {0.0, 1.0, 0.0}});
}

/// One material of every kind, and three lights.
content::SceneDesc every_kind() {
    content::SceneDesc scene;
    scene.materials.resize(6);
    scene.materials[1].vegetation = true;
    scene.materials[2].invisible_reflectance.infrared = 0.9f;
    scene.materials[3].reflectance_spectrum = content::Spectrum(content::SampledSpectrum{
        {400.0, 550.0, 700.0, 1000.0}, {0.1, 0.6, 0.2, 0.9}, content::TabulatedSpectrum::Beyond::held});
    scene.materials[4].emission_temperature = 2400.0f;
    scene.materials[5].invisible_emission.ultraviolet = 2.0f;
    scene.lamps.push_back({"incandescent", {}, glm::vec3(1.0f), 0.0f, content::Spectrum(content::BlackBody{2700.0})});
    scene.lamps.push_back({"sodium", {}, glm::vec3(1.0f), 0.0f, sodium_lamp()});
    return scene;
}

glm::dvec3 reflected(const render::SceneColour& colour, std::size_t material, const glm::dvec3& reflectance,
                     double ratio) {
    const render::SceneSpectra& spectra = colour.spectra();
    const render::MaterialTerms& terms = spectra.materials()[material];
    return colour.seen(terms.reflected, spectra.reflected(terms, reflectance, glm::dvec3(1.0)), render::Mode::full,
                       std::log(ratio));
}

double largest(const render::TermColumns& columns) {
    double value = 0.0;
    for (const glm::dvec3& column : columns) {
        value = std::max({value, std::abs(column.x), std::abs(column.y), std::abs(column.z)});
    }
    return value;
}

/// Below this share of the white at rest nothing is compared: black bodies fade beyond what an adapted eye sees; of a
/// line at the visible's end what is left is told by the matching functions' last digits.
double least_seen(const render::SceneSpectra& spectra, std::size_t group) {
    return spectra.lights()[spectra.groups()[group].light].black_body_kelvin() ? 1e-6 : 1e-3;
}

content::SceneDesc one_material(content::ReflectanceModel model) {
    content::SceneDesc scene;
    scene.materials.emplace_back();
    scene.reflectance_model = model;
    return scene;
}

} // namespace

TEST_CASE("CIEDE2000 gives the differences of Sharma, Wu and Dalal's test pairs") {
    struct Pair {
        glm::dvec3 a;
        glm::dvec3 b;
        double difference;
    };
    const std::array<Pair, 9> pairs{{{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
                                     {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
                                     {{50, 0, 0}, {50, -1, 2}, 2.3669},
                                     {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
                                     {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
                                     {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
                                     {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
                                     {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                                     {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630}}};
    for (const Pair& pair : pairs) {
        CHECK_THAT(render::ciede2000(pair.a, pair.b), WithinAbs(pair.difference, 5e-5)); // four digits are published
        CHECK_THAT(render::ciede2000(pair.b, pair.a), WithinAbs(pair.difference, 5e-5));
    }
}

TEST_CASE("every model gives every RGB back at rest, and keeps greys black bodies") {
    const render::Observer observer;
    for (const auto model : {content::ReflectanceModel::five_terms, content::ReflectanceModel::three_primaries,
                             content::ReflectanceModel::dominant_wavelength}) {
        content::SceneDesc scene = one_material(model);
        scene.materials.emplace_back();
        scene.materials.back().vegetation = true;
        scene.materials.emplace_back();
        scene.materials.back().invisible_reflectance = {0.3f, 0.8f};
        const render::SceneColour colour(scene);
        // Primaries are corrected exactly; lines are sums over 1 nm of their own table.
        const double tolerance = model == content::ReflectanceModel::dominant_wavelength ? 1e-3 : 1e-9;
        for (std::size_t material = 0; material < scene.materials.size(); ++material) {
            for (int i = 0; i < 125; ++i) {
                const glm::dvec3 rgb = 0.25 * glm::dvec3(i % 5, i / 5 % 5, i / 25);
                const glm::dvec3 back = reflected(colour, material, rgb, 1.0);
                // Invisible bands fade in where the eye sees a last trace: they add 1e-3 at the most.
                CHECK(glm::length(back - rgb) <= (material == 2 ? 1e-3 : tolerance));
            }
        }
        const glm::dvec3 white = reflected(colour, 0, glm::dvec3(1.0), 0.7);
        const glm::dvec3 grey = reflected(colour, 0, glm::dvec3(0.25), 0.7);
        const render::LogXyz body = observer.black_body(5762.0 / 0.7);
        const glm::dvec3 expected =
            std::exp(body.ln_y - observer.black_body(5762.0).ln_y) *
            (colour.doppler().white().rgb_from_xyz() * glm::dvec3(body.x_over_y, 1.0, body.z_over_y));
        CHECK(glm::length(white - expected) <
              1e-5 * glm::length(expected)); // the terms' sum in their file is 1 to 1e-6
        CHECK(glm::length(4.0 * grey - white) < 1e-5 * glm::length(expected));
    }
}

TEST_CASE("smooth terms make reflectances within 0 and 1 at all wavelengths") {
    for (const auto rule : {content::ReflectanceRule::five_terms, content::ReflectanceRule::three_primaries,
                            content::ReflectanceRule::vegetation}) {
        const auto terms = content::smooth_terms(rule);
        double least = 0.0;
        double most = 1.0;
        for (int i = 0; i < 125; ++i) {
            const auto weights =
                content::coefficients(rule, 0.25 * glm::dvec3(i % 5, i / 5 % 5, i / 25), glm::dvec3(1.0));
            for (double nm = 40.0; nm < 12000.0; nm *= 1.02) {
                double reflectance = 0.0;
                for (std::size_t term = 0; term < terms.size(); ++term) {
                    reflectance += weights.at(term) * terms[term].at(nm);
                }
                least = std::min(least, reflectance);
                most = std::max(most, reflectance);
            }
        }
        CHECK(least > -1e-3); // the terms' file was fitted to that
        CHECK(most < 1.001);
    }
}

TEST_CASE("tables of every kind of surface and light agree with sums over the spectrum, and stay numbers") {
    const content::SceneDesc scene = every_kind();
    const render::SceneColour tables(scene);
    const render::SpectralColour truth(tables.spectra());
    double worst = 0.0;
    double worst_line = 0.0;
    std::size_t compared = 0;
    for (std::size_t group = 0; group < tables.spectra().groups().size(); ++group) {
        for (double ln_ratio = std::log(1e-4); ln_ratio <= std::log(1e4); ln_ratio += 0.0531) {
            for (const auto mode :
                 {render::Mode::geometry, render::Mode::doppler, render::Mode::searchlight, render::Mode::full}) {
                const auto approximate = tables.columns(group, mode, ln_ratio);
                CHECK(std::isfinite(largest(approximate)));
                const auto exact = truth.columns(group, mode, std::exp(ln_ratio));
                const double scale = largest(exact);
                if (scale < least_seen(tables.spectra(), group)) {
                    continue;
                }
                ++compared;
                const bool line = least_seen(tables.spectra(), group) > 1e-6;
                for (std::size_t i = 0; i < exact.size(); ++i) {
                    double& largest_error = line ? worst_line : worst;
                    largest_error = std::max(largest_error, glm::length(approximate.at(i) - exact.at(i)) / scale);
                }
            }
        }
    }
    CHECK(compared > 1000);
    CAPTURE(worst, worst_line);
    CHECK(worst < 1e-3);      // a fifth of what an eye may notice: cubics over 0.6 % across the terms' rows of 10 nm
    CHECK(worst_line < 3e-3); // cubics over 0.2 % across the matching functions' bends, rows of 5 nm
}

TEST_CASE("a laser's light is what the matching functions have at its wavelength as received") {
    // Two hundredths of a nanometre wide: sums over 1 nm would miss it.
    content::SceneDesc scene;
    scene.materials.resize(1);
    scene.materials[0].emission_spectrum =
        content::Spectrum(content::SampledSpectrum{{531.99, 532.0, 532.01}, {0.0, 1.0, 0.0}});
    const render::SceneColour colour(scene);
    const std::size_t group = colour.spectra().materials()[0].emitted;
    const render::SpectralColour truth(colour.spectra());
    const render::Observer observer;
    const glm::dmat3& to_rgb = colour.doppler().white().rgb_from_xyz();
    const double at_rest = content::luminance_of(to_rgb * observer.matching(532.0));
    for (const double ratio : {0.8, 0.913, 1.0, 1.07, 1.22}) {
        const glm::dvec3 expected = std::pow(ratio, -4.0) / at_rest * (to_rgb * observer.matching(532.0 * ratio));
        // The truth's pieces between bends are 0.01 nm long; of the table's cubics over 1 nm across bends a thousandth.
        CHECK(glm::length(truth.columns(group, render::Mode::full, ratio)[0] - expected) <
              1e-4 * glm::length(expected));
        CHECK(glm::length(colour.columns(group, render::Mode::full, std::log(ratio))[0] - expected) <
              2e-3 * glm::length(expected));
    }
}

TEST_CASE("invisible bands show when they are shifted into view, and only then") {
    content::SceneDesc scene;
    scene.materials.resize(3);
    scene.materials[1].invisible_reflectance = {0.0f, 1.0f};
    scene.materials[2].invisible_reflectance = {1.0f, 0.0f};
    const render::SceneColour colour(scene);
    const glm::dvec3 grey(0.5);
    const double plain = content::luminance_of(reflected(colour, 0, grey, 0.4));
    // At D = 0.4 the eye sees 900 to 2075 nm, at D = 3 it sees 120 to 277 nm.
    CHECK_THAT(content::luminance_of(reflected(colour, 1, grey, 0.4)), WithinRel(2.0 * plain, 1e-3));
    CHECK(content::luminance_of(reflected(colour, 2, grey, 0.4)) < 1e-3 * plain);
    const double ultraviolet = content::luminance_of(reflected(colour, 0, grey, 3.0));
    CHECK_THAT(content::luminance_of(reflected(colour, 2, grey, 3.0)), WithinRel(2.0 * ultraviolet, 1e-3));
}

TEST_CASE("leaves are bright in the infrared, and a painted green is not as bright") {
    const content::SceneDesc scene = every_kind();
    const render::SceneColour colour(scene);
    const glm::dvec3 green(0.05, 0.12, 0.03);
    const double white = content::luminance_of(reflected(colour, 0, glm::dvec3(1.0), 0.55));
    const double leaf = content::luminance_of(reflected(colour, 1, green, 0.55)) / white;
    CHECK(leaf > 0.35); // leaves reflect about half from 750 to 1300 nm
    CHECK(leaf < 0.65);
}

TEST_CASE("a lamp's light is that of its own temperature, as bright as its intensity says") {
    const content::SceneDesc scene = every_kind();
    const render::SceneColour colour(scene);
    const render::Observer observer;
    const render::SceneSpectra& spectra = colour.spectra();
    REQUIRE(spectra.falling_lights() == 3);
    const render::MaterialTerms& plain = spectra.materials()[0];
    const std::size_t group = plain.reflected + spectra.lamps()[0];
    const auto weights = spectra.reflected(plain, glm::dvec3(1.0), glm::dvec3(3.0));
    CHECK_THAT(content::luminance_of(colour.seen(group, weights, render::Mode::geometry, 0.0)), WithinRel(3.0, 1e-5));
    const render::LogXyz at_rest = observer.black_body(2700.0);
    const glm::dmat3& to_rgb = colour.doppler().white().rgb_from_xyz();
    const double unit = content::luminance_of(to_rgb * glm::dvec3(at_rest.x_over_y, 1.0, at_rest.z_over_y));
    for (const double ratio : {0.5, 0.8, 1.3}) {
        const render::LogXyz seen = observer.black_body(2700.0 / ratio);
        const glm::dvec3 expected =
            3.0 / unit * std::exp(seen.ln_y - at_rest.ln_y) * (to_rgb * glm::dvec3(seen.x_over_y, 1.0, seen.z_over_y));
        const glm::dvec3 got = colour.seen(group, weights, render::Mode::full, std::log(ratio));
        CHECK(glm::length(got - expected) < 1e-5 * glm::length(expected)); // sum of the terms: 1e-6
    }
    // Sodium's yellow line leaves the visible when it is shifted by a half either way.
    const std::size_t sodium = plain.reflected + spectra.lamps()[1];
    for (const double ratio : {0.5, 1.5}) {
        CHECK(glm::length(colour.seen(sodium, weights, render::Mode::full, std::log(ratio))) == 0.0);
    }
}

TEST_CASE("the microwave background is dark at rest and glows ahead of a very fast eye") {
    content::SceneDesc scene;
    scene.microwave_background = true;
    const render::SceneColour colour(scene);
    const std::size_t group = *colour.spectra().microwave_background();
    const auto seen = [&](double ratio) {
        return content::luminance_of(colour.seen(group, {1.0}, render::Mode::full, std::log(ratio)));
    };
    CHECK(seen(1.0) == 0.0);
    CHECK(seen(1.0 / 20.0) < 1e-12);
    // gamma = 300: ahead D = 1/600, a black body of 1635 K; 683 lm/W, relative to the luminance of radiance 1.
    const render::LogXyz body = render::Observer().black_body(2.725 * 600.0);
    const glm::dvec3 rgb = std::exp(body.ln_y) * 683.002e-9 / render::night_luminance_unit *
                           (colour.doppler().white().rgb_from_xyz() * glm::dvec3(body.x_over_y, 1.0, body.z_over_y));
    CHECK_THAT(seen(1.0 / 600.0), WithinRel(content::luminance_of(rgb), 1e-5));
    CHECK(seen(1.0 / 600.0) > 1e3); // hundreds of cd/m^2: dazzling beside stars
}

TEST_CASE("a frame's colour table interpolates every group to the light") {
    const content::SceneDesc scene = every_kind();
    const render::SceneColour colour(scene);
    const auto table = render::frame_colour_table(colour, render::Mode::full, std::exp(-1.5), std::exp(1.5), 4.0);
    double worst = 0.0;
    double worst_line = 0.0;
    for (std::size_t group = 0; group < colour.spectra().groups().size(); ++group) {
        double& worst_here = least_seen(colour.spectra(), group) > 1e-6 ? worst_line : worst;
        const std::size_t count = colour.spectra().surfaces()[colour.spectra().groups()[group].surface].count();
        for (double ln_ratio = -1.5; ln_ratio <= 1.5; ln_ratio += 0.00371) {
            const double position = (static_cast<double>(table.coordinate_scale) * ln_ratio / std::log(2.0) +
                                     static_cast<double>(table.coordinate_offset)) *
                                        render::FrameColourTable::samples -
                                    0.5;
            const int left = static_cast<int>(std::clamp(position, 0.0, render::FrameColourTable::samples - 2.0));
            const double t = position - left;
            const auto exact = colour.columns(group, render::Mode::full, ln_ratio);
            const double scale = 4.0 * largest(exact);
            if (scale < 4.0 * least_seen(colour.spectra(), group)) {
                continue;
            }
            for (std::size_t term = 0; term < count; ++term) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const int layer =
                        table.first_layer[group] + static_cast<int>(term < 3 ? term : (term == 3 ? i : term - 1));
                    const std::size_t component = term == 3 ? 3 : i;
                    const double a = static_cast<double>(table.texels[table.texel(layer, left) + component]);
                    const double b = static_cast<double>(table.texels[table.texel(layer, left + 1) + component]);
                    const double wanted = 4.0 * exact.at(term)[static_cast<int>(i)];
                    worst_here = std::max(worst_here, std::abs(a + t * (b - a) - wanted) / scale);
                }
            }
        }
    }
    CAPTURE(worst, worst_line);
    CHECK(worst < 1e-3); // as the table says
    // Straight pieces over 0.3 % of the wavelength, 2 nm, across the matching functions' bends: at the visible's ends,
    // where a thousandth of the light is left, these grow twofold within 5 nm.
    CHECK(worst_line < 2e-2);
}
