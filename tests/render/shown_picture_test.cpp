#include "render/shown_picture.h"

#include "render/colour/display.h"
#include "render/colour/false_colour_scale.h"
#include "scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using Catch::Matchers::WithinAbs;

namespace {

constexpr int side = 201;

render::Picture grey(float value) {
    return {side, side, 3, std::vector<float>(std::size_t{3} * side * side, value)};
}

std::array<int, 3> at(const content::Image& image, int column, int row) {
    const auto pixel = static_cast<std::size_t>(4 * (row * image.width + column));
    return {image.rgba[pixel], image.rgba[pixel + 1], image.rgba[pixel + 2]};
}

} // namespace

TEST_CASE("the scale of D reaches all that can be seen, with iso-lines at powers of two or their roots") {
    for (const double rapidity : {0.0, 1e-3, 0.1, 0.5, 1.4722, 3.0, 10.0, 30.0}) {
        const render::ShiftScale scale = render::shift_scale(sim::Rapidity(rapidity));
        CAPTURE(rapidity);
        CHECK(scale.range >= rapidity / std::numbers::ln2);
        CHECK(std::abs(std::remainder(std::log2(scale.step), 1.0)) < 1e-12);
        CHECK(scale.range / scale.step >= 4.0);
        CHECK(scale.range / scale.step <= 8.0);
    }
}

TEST_CASE("an eye at rest sees no iso-line") {
    // D is 1 everywhere: what single precision leaves of it must not be drawn as lines.
    render::RenderFrame frame = scene_kit::frame(0.0, {0.0, 0.0, -1.0}, {0.3, 0.1, -1.0}, side, side);
    frame.display.dither = false;
    const content::Image plain = render::shown_picture(grey(0.1f), frame, 0.0);
    frame.display.iso_lines = true;
    CHECK(render::shown_picture(grey(0.1f), frame, 0.0).rgba == plain.rgba);
}

TEST_CASE("iso-lines of D are the circles that aberration says") {
    // Looking ahead at rapidity xi, D = e^-xi cos^2(t/2) + e^xi sin^2(t/2) at the angle t from the motion, so D is seen
    // on the circle cos t = (cosh xi - D) / sinh xi.
    constexpr double xi = 1.2;
    render::RenderFrame frame = scene_kit::frame(xi, {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, side, side);
    frame.display.iso_lines = true;
    frame.display.dither = false;
    const content::Image image = render::shown_picture(grey(0.1f), frame, 0.0);
    const std::array<int, 3> plain = at(render::shown_picture(grey(0.1f), render::Exposure{}), 0, 0);
    const render::ShiftScale scale = render::shift_scale(sim::Rapidity(xi));
    int lines = 0;
    for (double level = -scale.range; level < scale.range; level += scale.step) {
        const double cosine = (std::cosh(xi) - std::exp2(level)) / std::sinh(xi);
        const double radius = 0.5 * side * std::sqrt(1.0 / (cosine * cosine) - 1.0); // 90 degrees: focal = half width
        if (cosine <= 0.75 || cosine >= 0.999) {
            continue; // beyond the picture's edge, or a circle too small to measure
        }
        ++lines;
        // The line's middle along the row to the right of the centre, weighted by how much it changes the picture.
        double weight = 0.0;
        double sum = 0.0;
        for (int column = side / 2; column < side; ++column) {
            const double off = column + 0.5 - 0.5 * side;
            if (std::abs(off - radius) < 3.0) {
                const double changed = std::abs(at(image, column, side / 2)[0] - plain[0]);
                weight += changed;
                sum += changed * off;
            }
        }
        CAPTURE(level, radius);
        REQUIRE(weight > 100.0);
        // Bytes and the difference quotient for the gradient place a line of two pixels within a tenth.
        CHECK_THAT(sum / weight, WithinAbs(radius, 0.1));
    }
    CHECK(lines >= 3);
}

TEST_CASE("false colours tell D by sim's own numbers, rings by the middles of their bands") {
    render::RenderFrame frame =
        scene_kit::frame(0.8, glm::normalize(glm::dvec3(1.0, 0.4, -0.5)), {0.0, 0.0, -1.0}, side, side);
    frame.display.dither = false;
    const render::ShiftScale scale = render::shift_scale(sim::Rapidity(0.8));
    for (const render::View view : {render::View::doppler, render::View::rings}) {
        frame.display.view = view;
        const content::Image image = render::shown_picture(grey(0.1f), frame, 0.0);
        for (const auto& [column, row] : {std::pair(0, 0), {100, 100}, {200, 30}, {77, 190}}) {
            const double ratio = sim::see(frame.eye.world_from_head,
                                          render::head_direction_from_pixel(frame.eye, column + 0.5, row + 0.5))
                                     .wavelength_ratio;
            const double level = std::log2(ratio);
            const double shown =
                view == render::View::rings ? (std::floor(level / scale.step) + 0.5) * scale.step : level;
            const auto expected =
                render::display_bytes(render::shift_colour(shown, scale.range), {column, side - 1 - row}, false);
            CHECK(at(image, column, row) == std::array<int, 3>{expected[0], expected[1], expected[2]});
        }
    }
}

TEST_CASE("the luminance view tells stops from middle grey, whatever the hue") {
    render::RenderFrame frame = scene_kit::frame(0.0, {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, side, side);
    frame.display.view = render::View::luminance;
    frame.display.dither = false;
    render::Picture light = grey(0.18f * 8.0f);
    light.values[0] = 0.18f * 8.0f / 0.2126f; // the first pixel: a red of the same luminance
    light.values[1] = light.values[2] = 0.0f;
    const content::Image image = render::shown_picture(light, frame, -1.0);
    const auto expected = render::display_bytes(render::brightness_colour((2.0 + 10.0) / 16.0), {0, 0}, false);
    for (int i = 0; i < 3; ++i) {
        CHECK(std::abs(at(image, 0, 0)[static_cast<std::size_t>(i)] - expected[static_cast<std::size_t>(i)]) <= 1);
        CHECK(std::abs(at(image, 100, 50)[static_cast<std::size_t>(i)] - expected[static_cast<std::size_t>(i)]) <= 1);
    }
}

TEST_CASE("the false colours' lightness tells the size: it falls from D = 1 outwards, and grows with brightness") {
    for (int i = 0; i < 20; ++i) {
        for (const double side_of : {-1.0, 1.0}) {
            CHECK(render::luminance(render::shift_colour(side_of * i / 20.0, 1.0)) >
                  render::luminance(render::shift_colour(side_of * (i + 1) / 20.0, 1.0)));
        }
        CHECK(render::luminance(render::brightness_colour(i / 20.0)) <
              render::luminance(render::brightness_colour((i + 1) / 20.0)));
    }
}
