#include "render/offline/spectrum_probe.h"

#include "render/offline/seen_colour.h"
#include "render/raycast/ray_caster.h"
#include "scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr glm::dvec3 ahead(0.0, 0.0, -1.0);

/// A grey wall all around the view's middle, at rest radiance 0.4.
content::SceneDesc grey_wall() {
    content::SceneDesc scene;
    scene_kit::add(scene, scene_kit::rectangle({0.0f, 0.0f, -5.0f}, {50.0f, 0.0f, 0.0f}, {0.0f, 50.0f, 0.0f}),
                   scene_kit::unlit(glm::vec3(0.4f)));
    scene.instances.back().name = "wall";
    scene.materials.back().name = "plaster";
    return scene;
}

/// Planck's law relative to that of the scene's light at 560 nm, from its closed form.
double planck(double nm, double temperature, double light_temperature) {
    const auto shape = [](double wavelength, double kelvin) {
        return 1.0 / (std::pow(wavelength, 5.0) * std::expm1(1.438776877e7 / (wavelength * kelvin)));
    };
    return shape(nm, temperature) / shape(560.0, light_temperature);
}

content::Lamp sodium() {
    return {"sodium",
            {-0.5f, 0.0f, 0.0f},
            {8.0f, 5.0f, 0.5f},
            0.0f,
            content::Spectrum(content::SampledSpectrum{{560.0, 589.0, 620.0}, {0.0, 1.0, 0.0}})};
}

/// All that has a spectrum of its own: five terms, leaves, an infrared of its own, a measured reflectance; lit by the
/// scene's light, an incandescent lamp and, if wanted, a sodium lamp; a material that glows.
content::SceneDesc spectra_of_all_kinds(bool with_sodium) {
    content::SceneDesc scene;
    scene.ambient = glm::vec3(0.3f, 0.35f, 0.4f);
    scene.lamps.push_back(
        {"warm", {0.5f, 0.0f, 0.0f}, glm::vec3(8.0f), 0.0f, content::Spectrum(content::BlackBody{2700.0})});
    if (with_sodium) {
        scene.lamps.push_back(sodium());
    }
    std::vector<content::Material> materials(5, scene_kit::matte({0.15f, 0.4f, 0.08f}));
    materials[1].vegetation = true;
    materials[2].invisible_reflectance.infrared = 0.9f;
    materials[3].reflectance_spectrum = content::Spectrum(content::SampledSpectrum{
        {400.0, 550.0, 700.0, 1000.0}, {0.1, 0.6, 0.2, 0.9}, content::TabulatedSpectrum::Beyond::held});
    materials[4].emission = glm::vec3(0.4f);
    materials[4].emission_temperature = 2400.0f;
    constexpr float width = 1.6f;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const float x = width * (static_cast<float>(i) - 2.0f);
        scene_kit::add(scene, scene_kit::rectangle({x, 0.0f, -5.0f}, {0.5f * width, 0, 0}, {0, 9.0f, 0}), materials[i]);
    }
    return scene;
}

} // namespace

TEST_CASE("the probe's grey is a black body: as received one at T/D") {
    const content::SceneDesc scene = grey_wall();
    const render::SpectrumProbe probe(scene);
    for (const double rapidity : {0.0, 0.7, -0.7, 2.5}) {
        const render::RenderFrame frame =
            scene_kit::frame(std::abs(rapidity), rapidity < 0.0 ? -ahead : ahead, ahead, 101, 61);
        const render::ProbedLight light = probe.at(frame, {50.5, 30.5});
        CHECK(light.source == render::ProbedLight::Source::surface);
        CHECK(light.object == "wall");
        CHECK(light.material == "plaster");
        CHECK_THAT(light.distance, WithinRel(5.0, 1e-6)); // the hit's plane in single precision
        CHECK_THAT(light.wavelength_ratio, WithinRel(std::exp(-rapidity), 1e-12));
        const double temperature = 5762.0 / light.wavelength_ratio;
        for (const double nm : {60.0, 150.0, 380.0, 555.0, 730.0, 1500.0, 11000.0}) {
            CAPTURE(rapidity, nm);
            // The primaries sum to 1 within 1e-5, their weights come from a matrix inverse; 0.4 is single precision.
            CHECK_THAT(light.emitted(nm), WithinRel(0.4 * planck(nm, 5762.0, 5762.0), 3e-5));
            CHECK_THAT(light.received(nm), WithinRel(0.4 * planck(nm, temperature, 5762.0), 3e-5));
        }
    }
}

TEST_CASE("the probe's colour is what its spectrum looks like to the observer") {
    content::SceneDesc scene = grey_wall();
    scene.materials.back().base_colour = glm::vec4(0.7f, 0.2f, 0.1f, 1.0f);
    const render::SpectrumProbe probe(scene);
    const render::ProbedLight light = probe.at(scene_kit::frame(0.3, ahead, ahead, 101, 61), {20.0, 15.0});
    const render::Observer observer;
    const glm::dvec3 seen = observer.xyz([&](double nm) { return light.received(nm); });
    const glm::dvec3 white = observer.xyz([](double nm) { return planck(nm, 5762.0, 5762.0); });
    const double y_of_rgb = glm::dot(light.seen, glm::dvec3(0.2126, 0.7152, 0.0722));
    // Adaptation from the light's white to D65 moves the luminance of colours by a few per cent.
    CHECK_THAT(seen.y / white.y, WithinRel(y_of_rgb, 0.05));
    CHECK(light.seen.r > light.seen.b);
}

TEST_CASE("the probe's spectrum, seen by the observer, is the colour that is drawn") {
    // Without a lamp of lines the colour is the very sum over whole nanometres; with it, its three bends lie between
    // them: each is missed by an eighth of its change of slope, sum 0.13 of the lamp's 30 nm, at D = 0.55 3.3 times
    // that: 2e-3 of the lamp's own light, which is a tenth of what is seen here.
    for (const auto& [with_sodium, of_plain_sum] : {std::pair(false, 1e-9), std::pair(true, 2e-4)}) {
        const content::SceneDesc scene = spectra_of_all_kinds(with_sodium);
        const render::SpectrumProbe probe(scene);
        const render::SceneColour colour(scene);
        const render::RayCaster caster(scene, colour);
        const glm::dmat3 rgb_from_xyz = render::SpectralColour(render::SceneSpectra(scene)).rgb_from_xyz();
        const render::Observer observer;
        const double white_y = observer.xyz([](double nm) { return planck(nm, 5762.0, 5762.0); }).y;
        for (const double rapidity : {0.0, 0.15, 0.6, -0.2}) {
            render::RenderFrame frame =
                scene_kit::frame(std::abs(rapidity), rapidity < 0.0 ? -ahead : ahead, ahead, 101, 61);
            frame.mode = render::Mode::full;
            const render::Picture drawn = caster.picture(frame);
            for (int column = 4; column < 100; column += 8) {
                const render::ProbedLight light = probe.at(frame, {column + 0.5, 30.5});
                const glm::dvec3 seen =
                    rgb_from_xyz * (observer.xyz([&](double nm) { return light.received(nm); }) / white_y);
                const glm::dvec3 pixel = scene_kit::colour_at(drawn, column, 30);
                CAPTURE(rapidity, column, light.object, light.material, seen.x, pixel.x, seen.y, pixel.y, seen.z,
                        pixel.z);
                CHECK(glm::length(light.seen - seen) < of_plain_sum * glm::length(seen));
                // Tables in ln D (0.02 %), the picture's own in single precision (0.1 %).
                CHECK(glm::length(pixel - seen) < 2e-3 * glm::length(seen));
            }
        }
    }
}

TEST_CASE("a lamp's lines are summed exactly, wherever they fall between nanometres") {
    content::SceneDesc scene;
    scene.lamps.push_back(sodium());
    content::Material grey;
    grey.reflectance_spectrum =
        content::Spectrum(content::SampledSpectrum{{555.0}, {0.5}, content::TabulatedSpectrum::Beyond::held});
    scene_kit::add(scene, scene_kit::rectangle({0.0f, 0.0f, -5.0f}, {9.0f, 0, 0}, {0, 9.0f, 0}), grey);
    const render::SpectrumProbe probe(scene);
    const render::Observer observer;
    const glm::dmat3 rgb_from_xyz = render::SpectralColour(render::SceneSpectra(scene)).rgb_from_xyz();
    const double white_y = observer.xyz([](double nm) { return planck(nm, 5762.0, 5762.0); }).y;
    for (const double rapidity : {0.0, 0.1, 0.25, -0.2}) {
        const render::RenderFrame frame =
            scene_kit::frame(std::abs(rapidity), rapidity < 0.0 ? -ahead : ahead, ahead, 101, 61);
        const render::ProbedLight light = probe.at(frame, {50.5, 30.5});
        // Middles of a thousandth of a nanometre: h^2/24 of what bends less than once a nanometre, and a kink's h^2/8.
        constexpr double step = 1e-3;
        glm::dvec3 sum(0.0);
        for (double nm = 360.0 + 0.5 * step; nm < 830.0; nm += step) {
            sum += step * light.received(nm) * observer.matching(nm);
        }
        const glm::dvec3 seen = rgb_from_xyz * (sum / white_y);
        CAPTURE(rapidity, seen.x, seen.y, seen.z);
        CHECK(glm::length(light.seen - seen) < 1e-6 * glm::length(seen));
    }
}

TEST_CASE("the probe finds the sky, and a star near the point") {
    content::SceneDesc scene;
    content::Star star;
    star.position = {0.0, 0.0, -10.0};
    star.temperature = 4000.0f;
    scene.stars.push_back(star);
    const render::SpectrumProbe probe(scene);
    render::RenderFrame frame = scene_kit::frame(1.0, ahead, ahead, 201, 121);
    frame.metres_per_light_year = 1.0;
    const render::ProbedLight found = probe.at(frame, {102.0, 61.0});
    CHECK(found.source == render::ProbedLight::Source::star);
    CHECK_THAT(found.distance, WithinAbs(10.0, 1e-12));
    CHECK_THAT(found.wavelength_ratio, WithinRel(std::exp(-1.0), 1e-12));
    for (const double nm : {200.0, 560.0, 2000.0}) {
        CHECK_THAT(found.received(nm), WithinRel(planck(nm, 4000.0 / std::exp(-1.0), 4000.0), 1e-6));
    }
    const render::ProbedLight sky = probe.at(frame, {30.0, 20.0});
    CHECK(sky.source == render::ProbedLight::Source::sky);
    CHECK(sky.object.empty());
}
