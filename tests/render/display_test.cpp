#include "render/colour/display.h"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("sRGB bytes survive the way to linear and back") {
    for (int byte = 0; byte < 256; ++byte) {
        CHECK(render::srgb_byte_from_linear(render::linear_from_srgb(static_cast<float>(byte) / 255.0f)) == byte);
    }
}
