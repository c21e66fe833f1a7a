#include "render/gl/egl_context.h"
#include "render/gl/sky_cube.h"
#include "render/panorama.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using Catch::Matchers::WithinAbs;

TEST_CASE("the sky cube holds the panorama, each axis where OpenGL looks for it") {
    const render::EglContext context;
    // A sky whose colour tells its direction: radiance = direction + 2.
    content::Panorama panorama;
    panorama.width = 512;
    panorama.height = 256;
    for (int row = 0; row < panorama.height; ++row) {
        for (int column = 0; column < panorama.width; ++column) {
            const double longitude = ((column + 0.5) / panorama.width - 0.5) * 2.0 * std::numbers::pi;
            const double colatitude = (row + 0.5) / panorama.height * std::numbers::pi;
            panorama.radiance.emplace_back(glm::dvec3(std::sin(colatitude) * std::sin(longitude), std::cos(colatitude),
                                                      -std::sin(colatitude) * std::cos(longitude)) +
                                           2.0);
        }
    }
    const render::SkyCube cube(panorama);
    int size = 0;
    glGetTextureLevelParameteriv(cube.texture(), 0, GL_TEXTURE_WIDTH, &size);
    CHECK(size == 192); // 2/pi of 256, rounded up to a multiple of 64
    // The centre of each face looks along an axis, in OpenGL's order of faces.
    const std::array<glm::dvec3, 6> axes{glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face) {
        std::array<float, 4> texel{};
        glGetTextureSubImage(cube.texture(), 0, size / 2, size / 2, face, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof(texel),
                             texel.data());
        for (int i = 0; i < 3; ++i) {
            // Half a texel off the axis is 1/192; half floats near 3 are exact to 1e-3.
            CHECK_THAT(texel[static_cast<std::size_t>(i)],
                       WithinAbs(axes[static_cast<std::size_t>(face)][i] + 2.0, 1.0 / 192 + 1e-3));
        }
    }
}
