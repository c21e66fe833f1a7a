#include "render/offline/compare.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <limits>

using Catch::Matchers::WithinAbs;

namespace {

content::Image grey(std::uint8_t level) {
    content::Image image;
    image.width = 4;
    image.height = 4;
    image.rgba.assign(64, level);
    return image;
}

/// Object ids sampled at `per_pixel` points along each side of each of 40 x 30 pixels.
render::Picture objects(int per_pixel, const std::function<float(double x, double y)>& id) {
    render::Picture picture;
    picture.width = 40 * per_pixel;
    picture.height = 30 * per_pixel;
    picture.channels = 1;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            picture.values.push_back(id((column + 0.5) / per_pixel, (row + 0.5) / per_pixel));
        }
    }
    return picture;
}

/// Two objects side by side.
std::function<float(double, double)> edge_at(double where) {
    return [where](double x, double) { return x < where ? 0.0f : 1.0f; };
}

render::TrueObjects truth_of(const std::function<float(double, double)>& id) {
    return {objects(1, id), objects(4, id)};
}

} // namespace

TEST_CASE("the signal-to-noise ratio is 20 log10 of 255 over an even difference") {
    CHECK_THAT(render::peak_signal_to_noise(grey(100), grey(110)), WithinAbs(20.0 * std::log10(25.5), 1e-12));
    CHECK(render::peak_signal_to_noise(grey(7), grey(7)) == std::numeric_limits<double>::infinity());
    CHECK(render::difference_picture(grey(100), grey(110)).rgba[0] == 40);
    CHECK(render::difference_picture(grey(100), grey(200)).rgba[1] == 255);
}

TEST_CASE("an exact picture is not displaced, not even where its centres alone see an object") {
    CHECK(render::edge_displacement(objects(1, edge_at(20.2)), truth_of(edge_at(20.2)), 1.0) == 0.0);
    const auto sliver = [](double x, double) { return x == 20.5 ? 2.0f : 0.0f; };
    CHECK(render::edge_displacement(objects(1, sliver), truth_of(sliver), 1.0) == 0.0);
}

TEST_CASE("a shifted edge is displaced by its shift") {
    // Pixels 20, 21 and 22 (centres 20.5 to 22.5) show object 0, which truly ends at x = 20, sub-sample centre 19.875.
    const render::Picture shifted = objects(1, edge_at(23.0));
    const render::TrueObjects truth = truth_of(edge_at(20.0));
    CHECK_THAT(render::edge_displacement(shifted, truth, 1.0), WithinAbs(std::hypot(2.625, 0.125), 1e-12));
    CHECK(render::edge_displacement(shifted, truth, 0.9) == 0.0);
}

TEST_CASE("an object that is nowhere near is displaced by the cap") {
    const render::Picture wrong = objects(1, [](double, double) { return 7.0f; });
    CHECK(render::edge_displacement(wrong, truth_of(edge_at(20.0)), 0.5) == render::largest_displacement);
}
