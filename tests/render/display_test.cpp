#include "render/colour/auto_exposure.h"
#include "render/colour/display.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace display_shader {
using namespace glm;
#include "render/shaders/shared/display.glsl"
} // namespace display_shader

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("sRGB bytes survive the way to linear and back") {
    for (int byte = 0; byte < 256; ++byte) {
        CHECK(render::srgb_byte_from_linear(render::linear_from_srgb(static_cast<float>(byte) / 255.0f)) == byte);
    }
}

TEST_CASE("the shader's sRGB encoding is the standard's to a hundredth of a byte") {
    for (int i = 0; i <= 1000; ++i) {
        const float linear = static_cast<float>(i * i) / 1e6f;
        // 3.5e-5 is the fit's own error, the rest single precision.
        CHECK_THAT(display_shader::srgb_encoded(glm::vec3(linear)).g,
                   WithinAbs(static_cast<double>(render::srgb_from_linear(linear)), 3.6e-5));
    }
}

TEST_CASE("the filmic curve leaves dark colours alone and squeezes bright ones, in order") {
    CHECK(display_shader::filmic({0.2f, 0.5f, 0.0f}) == glm::vec3(0.2f, 0.5f, 0.0f));
    float previous = 0.0f;
    for (float light = 0.01f; light < 1e5f; light *= 1.3f) {
        const float shown = display_shader::filmic(glm::vec3(light)).g;
        CHECK(shown > previous);
        CHECK(shown < 1.0f);
        previous = shown;
    }
    const glm::vec3 bright_orange = display_shader::filmic({8.0f, 4.0f, 1.0f});
    CHECK(bright_orange.r > bright_orange.g);
    CHECK(bright_orange.g > bright_orange.b);
}

TEST_CASE("linear display gives bytes back, filmic display stays in range") {
    const auto bytes = [](const glm::vec3& exposed, bool linear) {
        return render::display_bytes(render::display_colour(exposed, linear), {0, 0}, false);
    };
    CHECK(bytes({1.0f, 1.0f, 1.0f}, true) == std::array<std::uint8_t, 3>{255, 255, 255});
    CHECK(bytes({0.0f, 0.0f, 0.0f}, false) == std::array<std::uint8_t, 3>{0, 0, 0});
    CHECK(bytes({5e4f, 5e4f, 5e4f}, false)[1] == 255);
}

TEST_CASE("automatic exposure settles on middle grey at once, then follows in time") {
    const auto even = [](float luminance) {
        return render::MeteredLight{std::vector<float>(1000, luminance), std::vector<float>(1000, luminance)};
    };
    const render::MeteredLight grey = even(4.0f);
    render::AutoExposure exposure;
    CHECK_THAT(exposure.adapt(grey, 0.5, 0.0), WithinRel(0.045, 1e-6)); // 0.18 / 4
    CHECK_THAT(exposure.adapt(grey, 0.5, 1.0), WithinRel(0.09, 1e-6));  // compensated one stop up

    const render::MeteredLight darker = even(0.4f);
    double previous = exposure.current(0.0);
    for (int frame = 0; frame < 30; ++frame) {
        const double now = exposure.adapt(darker, 1.0 / 30.0, 0.0);
        CHECK(now > previous);
        previous = now;
    }
    CHECK_THAT(previous, WithinRel(0.045 * std::pow(10.0, 1.0 - std::exp(-1.0 / 0.7)), 1e-6));
    CHECK_THAT(exposure.adapt(darker, 0.0, 0.0), WithinRel(0.45, 1e-6)); // no time given: at once
}

TEST_CASE("automatic exposure lets a lamp glare, and gives a stop for what is bright and wide") {
    const auto factor = [](std::ptrdiff_t bright_squares, float light) {
        render::MeteredLight street{std::vector<float>(10000, 0.09f), std::vector<float>(10000, 0.09f)};
        std::fill_n(street.brightest.begin(), bright_squares, light);
        return render::well_exposed_factor(street);
    };
    CHECK_THAT(factor(0, 0.0f), WithinRel(2.0, 1e-6));    // 0.18 / 0.09
    CHECK_THAT(factor(150, 40.0f), WithinRel(2.0, 1e-6)); // less than a fiftieth
    CHECK_THAT(factor(300, 40.0f), WithinRel(1.0, 1e-6)); // twenty times too bright: a stop
    CHECK_THAT(factor(300, 2.5f), WithinRel(1.6, 1e-6));  // the brightest that the curve tells apart is 4
}

TEST_CASE("automatic exposure keeps stars on black below the glare and survives a picture without light") {
    // One square in twenty holds a star, sixteen times as bright as the square's mean.
    render::MeteredLight night{std::vector<float>(10000, 0.0f), std::vector<float>(10000, 0.0f)};
    std::fill_n(night.mean.begin(), 500, 0.02f);
    std::fill_n(night.brightest.begin(), 500, 0.3f);
    render::AutoExposure exposure;
    const double factor = exposure.adapt(night, 0.0, 0.0);
    CHECK_THAT(factor * 0.3, WithinRel(4.0, 1e-6)); // the brightest that the curve tells apart
    const render::MeteredLight nothing{std::vector<float>(100, 0.0f), std::vector<float>(100, 0.0f)};
    CHECK_THAT(exposure.adapt(nothing, 0.0, 0.0), WithinRel(factor, 1e-12));
}

TEST_CASE("a limit on the brightest keeps all light below it, and what is dark as it was") {
    for (const bool linear : {false, true}) {
        for (const float limit : {0.1f, 0.4f, 1.0f}) {
            const float most = render::srgb_from_linear(limit);
            for (const glm::vec3& light : {glm::vec3(0.3f, 0.2f, 0.6f), glm::vec3(3.0f, 1.0f, 0.1f), glm::vec3(1e6f)}) {
                const glm::vec3 shown = render::display_colour(light, linear, render::Primaries::srgb, limit);
                CHECK(std::max({shown.r, shown.g, shown.b}) <= most + 1e-4f); // the fit of the transfer function
            }
            const glm::vec3 dark = 0.5f * limit * glm::vec3(0.9f, 0.5f, 0.7f);
            CHECK(glm::distance(render::display_colour(dark, linear, render::Primaries::srgb, limit),
                                render::display_colour(dark, linear)) < 1e-6f);
        }
    }
}
