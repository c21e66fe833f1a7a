#include "render/shown_picture.h"

#include "render/colour/auto_exposure.h"
#include "render/colour/display.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr int square = 8; // pixels, as the display pass's light meter takes them

glm::vec3 pixel(const Picture& picture, int column, int row) {
    const std::size_t at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(column));
    return {picture.values[at], picture.values[at + 1], picture.values[at + 2]};
}

// Mean of 2 x 2 pixels whose upper left is at an even place.
glm::vec3 spot(const Picture& picture, int column, int row) {
    const int left = column & ~1;
    const int top = row & ~1;
    const int right = std::min(left + 1, picture.width - 1);
    const int bottom = std::min(top + 1, picture.height - 1);
    return 0.25f * (pixel(picture, left, top) + pixel(picture, right, top) + pixel(picture, left, bottom) +
                    pixel(picture, right, bottom));
}

MeteredLight metered(const Picture& picture) {
    MeteredLight light;
    for (int top = 0; top < std::max(picture.height - square + 1, 1); top += square) {
        for (int left = 0; left < std::max(picture.width - square + 1, 1); left += square) {
            glm::vec3 sum(0.0f);
            float brightest = 0.0f;
            const int bottom = std::min(top + square, picture.height);
            const int right = std::min(left + square, picture.width);
            for (int row = top; row < bottom; ++row) {
                for (int column = left; column < right; ++column) {
                    sum += pixel(picture, column, row);
                    brightest = std::max(brightest, luminance(spot(picture, column, row)));
                }
            }
            const auto count = static_cast<float>((bottom - top) * (right - left));
            light.mean.push_back(std::max(luminance(sum) / count, 0.0f));
            light.brightest.push_back(brightest);
        }
    }
    return light;
}

} // namespace

double exposure_stops(const Picture& radiance, const Exposure& exposure) {
    if (!exposure.automatic) {
        return static_cast<double>(exposure.stops);
    }
    return std::log2(AutoExposure().adapt(metered(radiance), 0.0, static_cast<double>(exposure.stops)));
}

content::Image shown_picture(const Picture& radiance, const Exposure& exposure) {
    const auto factor = static_cast<float>(std::exp2(exposure_stops(radiance, exposure)));
    content::Image image;
    image.width = radiance.width;
    image.height = radiance.height;
    image.rgba.reserve(radiance.values.size() / 3 * 4);
    for (int row = 0; row < radiance.height; ++row) {
        for (int column = 0; column < radiance.width; ++column) {
            const std::array<std::uint8_t, 3> shown =
                display_bytes(factor * pixel(radiance, column, row), exposure.linear_curve);
            image.rgba.insert(image.rgba.end(), {shown[0], shown[1], shown[2], 255});
        }
    }
    return image;
}

} // namespace render
