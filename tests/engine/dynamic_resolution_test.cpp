#include "engine/dynamic_resolution.h"

#include <catch2/catch_test_macros.hpp>
#include <set>

using engine::DynamicResolution;

namespace {

/// Scale after `frames` frames whose cost is a fixed part and a part per pixel, in seconds at full size.
double settle(DynamicResolution& resolution, double fixed, double pixels, int frames = 400) {
    for (int i = 0; i < frames; ++i) {
        resolution.update(fixed + pixels * resolution.scale() * resolution.scale());
    }
    return resolution.scale();
}

} // namespace

TEST_CASE("cheap frames keep every pixel") {
    DynamicResolution resolution(0.030);
    CHECK(settle(resolution, 0.002, 0.020) == 1.0);
}

TEST_CASE("dear frames lose pixels until the budget holds, and not many more") {
    DynamicResolution resolution(0.030);
    const double scale = settle(resolution, 0.004, 0.060);
    CHECK(0.004 + 0.060 * scale * scale <= 0.030);
    const double two_more = scale + 2.0 * DynamicResolution::step;
    CHECK(0.004 + 0.060 * two_more * two_more > 0.030);
}

TEST_CASE("the scale comes to rest instead of breathing") {
    DynamicResolution resolution(0.030);
    for (double pixels = 0.025; pixels < 0.2; pixels *= 1.07) {
        settle(resolution, 0.003, pixels);
        std::set<double> scales;
        for (int i = 0; i < 100; ++i) {
            scales.insert(settle(resolution, 0.003, pixels, 1));
        }
        CHECK(scales.size() == 1);
    }
}

TEST_CASE("pixels come back when frames become cheap again") {
    DynamicResolution resolution(0.030);
    CHECK(settle(resolution, 0.0, 0.120) < 0.55);
    CHECK(settle(resolution, 0.0, 0.010) == 1.0);
}

TEST_CASE("hopeless cost stops at the smallest picture; one slow frame changes nothing") {
    DynamicResolution hopeless(0.030);
    CHECK(settle(hopeless, 1.0, 1.0) == DynamicResolution::smallest);
    DynamicResolution hiccup(0.030);
    settle(hiccup, 0.0, 0.015);
    CHECK(hiccup.update(0.045) == 1.0);
}
