#include "render/colour/dominant_wavelength.h"

#include "content/reflectance.h"
#include "render/colour/observer.h"
#include "render/colour/scene_colour.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace shader {
using glm::clamp;
using glm::dot;
using glm::max;
using glm::min;
using glm::normalize;
using glm::smoothstep;
using glm::vec3;
using std::sqrt;
#include "render/shaders/shared/reflectance.glsl"
} // namespace shader

using Catch::Matchers::WithinAbs;

namespace {

/// A matte material of this model, and what it makes of RGB.
class DominantWavelengthScene {
  public:
    DominantWavelengthScene() : colour_(scene()) {}

    const render::SceneColour& colour() const { return colour_; }
    render::TermWeights weights(const glm::dvec3& rgb) const {
        return colour_.spectra().reflected(material(), rgb, glm::dvec3(1.0));
    }
    glm::dvec3 seen(const glm::dvec3& rgb, double ratio) const {
        return colour_.seen(material().reflected, weights(rgb), render::Mode::doppler, std::log(ratio));
    }
    double reflectance(const glm::dvec3& rgb, double nm) const {
        const render::SurfaceSpectrum& surface = colour_.spectra().surfaces()[material().surface];
        const render::TermWeights mixed = weights(rgb);
        double sum = 0.0;
        for (std::size_t i = 0; i < surface.mixed_count(); ++i) {
            sum += mixed.values.at(i) * surface.at(surface.mixed_term(i, mixed.hue), nm);
        }
        return sum;
    }

    /// Wavelengths (whole nm) where the reflectance is higher than on both sides.
    std::vector<double> peaks(const glm::dvec3& rgb) const {
        std::vector<double> found;
        for (double nm = 380.0; nm <= 780.0; nm += 1.0) {
            const double here = reflectance(rgb, nm);
            if (here > reflectance(rgb, nm - 1.0) && here > reflectance(rgb, nm + 1.0)) {
                found.push_back(nm);
            }
        }
        return found;
    }

  private:
    static content::SceneDesc scene() {
        content::SceneDesc scene;
        scene.materials.emplace_back();
        scene.reflectance_model = content::ReflectanceModel::dominant_wavelength;
        return scene;
    }
    const render::MaterialTerms& material() const { return colour_.spectra().materials().front(); }

    render::SceneColour colour_;
};

/// As saturated as RGB can be, by the definition of hue.
glm::dvec3 pure(double sextants) {
    const auto component = [&](double centre) {
        const double away = std::abs(sextants - centre);
        return std::clamp(2.0 - std::min(away, 6.0 - away), 0.0, 1.0);
    };
    return {component(0.0), component(2.0), component(4.0)};
}

} // namespace

TEST_CASE("hue is linear between the corners of RGB, on the GPU as well") {
    for (const double sextants : {0.0, 0.3, 1.0, 1.6, 2.0, 2.5, 3.0, 3.1, 4.0, 4.9, 5.0, 5.99}) {
        const glm::dvec3 rgb = 0.2 + 0.7 * pure(sextants);
        const content::Hue hue = content::hue_of(rgb);
        CHECK_THAT(hue.least, WithinAbs(0.2, 1e-15));
        CHECK_THAT(hue.chroma, WithinAbs(0.7, 1e-15)); // roundings of the last place
        CHECK_THAT(hue.sextants, WithinAbs(sextants, 1e-14));
        const glm::vec3 single = shader::hue_of(glm::vec3(rgb));
        CHECK(glm::length(glm::dvec3(single) - glm::dvec3(0.2, 0.7, sextants)) < 2e-6); // four roundings of float at 6
    }
    CHECK(content::hue_of(glm::dvec3(0.4)).sextants == 0.0);
    CHECK(content::hue_of(glm::dvec3(0.4)).chroma == 0.0);
    const glm::vec3 grey = shader::hue_of(glm::vec3(0.4f));
    CHECK(grey.y == 0.0f);
    CHECK((grey.z >= 0.0f && grey.z <= 6.0f));
}

TEST_CASE("a hue's spectrum is white and one line, where a laser of that hue shines") {
    const DominantWavelengthScene scene;
    const render::Observer observer;
    const glm::dmat3& to_rgb = scene.colour().doppler().white().rgb_from_xyz();
    for (double nm = 443.0; nm < 627.0; nm += 1.7) {
        const glm::dvec3 laser = to_rgb * observer.matching(nm);
        const double least = std::min({laser.r, laser.g, laser.b});
        const glm::dvec3 rgb = (laser - least) / (std::max({laser.r, laser.g, laser.b}) - least);
        const std::vector<double> peaks = scene.peaks(0.1 + 0.8 * rgb);
        CAPTURE(nm);
        REQUIRE(peaks.size() == 1);
        // Whole nanometres are looked at; in the red, where the hue hardly turns, a line of 4 nm has that of a laser up
        // to a nanometre from its middle, and two lines at most 5 nm apart peak towards the higher one.
        CHECK_THAT(peaks.front(), WithinAbs(nm, 2.0));
    }
}

TEST_CASE("purples are lines at both ends of the spectrum") {
    const DominantWavelengthScene scene;
    for (const double sextants : {4.4, 4.8, 5.0, 5.3, 5.8}) {
        const std::vector<double> peaks = scene.peaks(pure(sextants));
        REQUIRE(peaks.size() == 2);
        CHECK_THAT(peaks.front(), WithinAbs(440.0, 2.5)); // the last whole step of hue within 440
        CHECK_THAT(peaks.back(), WithinAbs(640.0, 8.5));  // and 640 nm, where hue turns by a step in 8 nm
    }
}

TEST_CASE("dominant wavelengths reflect no less than nothing and return any RGB, under a warm light too") {
    for (const float kelvin : {2700.0f, 5762.0f, 9000.0f}) {
        content::SceneDesc described;
        described.materials.emplace_back();
        described.light_temperature = kelvin;
        described.reflectance_model = content::ReflectanceModel::dominant_wavelength;
        const render::SceneColour colour(described);
        const render::MaterialTerms& material = colour.spectra().materials().front();
        const render::SurfaceSpectrum& surface = colour.spectra().surfaces()[material.surface];
        double lowest = 0.0;
        for (std::size_t term = 0; term < surface.terms.size(); ++term) {
            for (double nm = 300.0; nm < 900.0; nm += 1.0) {
                lowest = std::min(lowest, surface.at(term, nm));
            }
        }
        CHECK(lowest > -1e-12); // the level beside a line is what the line's RGB lacks: a difference of two sums
        for (double sextants = 0.0; sextants < 6.0; sextants += 0.0173) {
            const glm::dvec3 rgb = 0.1 + 0.6 * pure(sextants);
            const auto weights = colour.spectra().reflected(material, rgb, glm::dvec3(1.0));
            const glm::dvec3 back = colour.seen(material.reflected, weights, render::Mode::full, 0.0);
            // Sums at even steps of ln wavelength across a table of 1 nm, whose bends they miss, against sums over 1
            // nm.
            CHECK(glm::length(back - rgb) < 5e-4);
        }
    }
}

TEST_CASE("as a hue turns around the wheel, its colour under Doppler shift turns without a jump") {
    const DominantWavelengthScene scene;
    constexpr int steps = 6 * 512;
    for (const double ratio : {0.8, 0.9, 1.1, 1.25}) {
        const double white = glm::length(scene.seen(glm::dvec3(1.0), ratio));
        double longest = 0.0;
        double whole = 0.0;
        glm::dvec3 before = scene.seen(pure(0.0), ratio);
        for (int i = 1; i <= steps; ++i) {
            const glm::dvec3 after = scene.seen(pure(6.0 * (i % steps) / steps), ratio);
            longest = std::max(longest, glm::length(after - before) / white);
            whole += glm::length(after - before) / white;
            before = after;
        }
        CAPTURE(ratio, longest, whole);
        CHECK(longest < 0.01 * whole); // two jumps would take half of the way
        CHECK(whole > 0.5);
    }
}
