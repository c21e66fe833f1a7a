#include "render/colour/bloom.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using Catch::Matchers::WithinRel;

namespace {

render::Picture dark(int width, int height) {
    return {width, height, 3, std::vector<float>(static_cast<std::size_t>(3 * width * height), 0.0f)};
}

float& red(render::Picture& picture, int column, int row) {
    return picture.values[static_cast<std::size_t>(3 * (row * picture.width + column))];
}

double sum(const render::Picture& picture, std::size_t channel) {
    double total = 0.0;
    for (std::size_t i = channel; i < picture.values.size(); i += 3) {
        total += static_cast<double>(picture.values[i]);
    }
    return total;
}

} // namespace

TEST_CASE("bloom keeps the sum of the light, whatever the size, at the edges too") {
    for (const auto& [width, height] :
         {std::pair(128, 64), {1, 1}, {3, 50}, {4, 4}, {17, 5}, {33, 65}, {160, 90}, {151, 83}}) {
        for (const auto& [column, row] :
             {std::pair(0, 0), {width - 1, height - 1}, {width / 2, 0}, {width / 3, height / 2}}) {
            render::Picture light = dark(width, height);
            red(light, column, row) = 100.0f;
            light.values[static_cast<std::size_t>(3 * (row * width + column) + 2)] = 7.0f;
            const render::Picture scattered = render::bloomed(light, 0.4f);
            CAPTURE(width, height, column, row);
            // Weights of neighbouring cells are single precision, seven levels of them.
            CHECK_THAT(sum(scattered, 0), WithinRel(100.0, 2e-5));
            CHECK(sum(scattered, 1) == 0.0);
            CHECK_THAT(sum(scattered, 2), WithinRel(7.0, 2e-5));
            CHECK(*std::min_element(scattered.values.begin(), scattered.values.end()) >= 0.0f);
        }
    }
}

TEST_CASE("bloom leaves even light as it is, and does nothing when it is off") {
    render::Picture even = dark(75, 41);
    std::fill(even.values.begin(), even.values.end(), 0.7f);
    for (const float value : render::bloomed(even, 0.5f).values) {
        CHECK(std::abs(value - 0.7f) < 1e-6f); // a few roundings
    }
    red(even, 3, 4) = 9.0f;
    CHECK(render::bloomed(even, 0.0f).values == even.values);
}

TEST_CASE("glare surrounds a lamp evenly, falls with distance and leaves it its share") {
    render::Picture light = dark(257, 257);
    red(light, 128, 128) = 1000.0f;
    render::Picture scattered = render::bloomed(light, 0.1f);
    CHECK_THAT(static_cast<double>(red(scattered, 128, 128)), WithinRel(900.0, 0.01)); // and a little of the rest
    double previous = 1e9;
    for (const int distance : {4, 8, 16, 32, 64}) {
        const std::array<float, 4> around{red(scattered, 128 + distance, 128), red(scattered, 128 - distance, 128),
                                          red(scattered, 128, 128 + distance), red(scattered, 128, 128 - distance)};
        const auto [least, most] = std::minmax_element(around.begin(), around.end());
        CHECK(*least > 0.0f);
        // The lamp lies somewhere in a cell of the coarse levels: up to half a cell off the glare's middle.
        CHECK(*most < 2.5f * *least);
        CHECK(static_cast<double>(*most) < previous);
        previous = static_cast<double>(*most);
    }
}
