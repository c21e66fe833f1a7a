#include "render/shown_picture.h"

#include "render/colour/bloom.h"
#include "render/colour/display.h"
#include "render/colour/false_colour_scale.h"
#include "render/eye_ray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tbb/parallel_for.h>

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

/// What a pixel is shown as, encoded.
class PixelPainter {
  public:
    PixelPainter(const Picture& light, const RenderFrame& frame, float factor, Primaries primaries)
        : light_(light), frame_(frame), factor_(factor), primaries_(primaries),
          eye_(sim::split(frame.eye.world_from_head)), shift_(shift_scale(eye_.xi)),
          primaries_from_srgb_(rgb_from_srgb(primaries)) {}

    glm::vec3 colour(int column, int row) const {
        const Display& display = frame_.display;
        if (display.view == View::luminance) {
            return luminance_view(column, row);
        }
        if (display.view == View::natural && !display.iso_lines) {
            return natural(column, row);
        }
        const double here = log2_ratio(column, row);
        glm::vec3 shown = natural(column, row);
        if (display.view != View::natural) {
            shown = shift_colour(display.view == View::rings ? band_middle(here, shift_.step) : here, shift_.range);
        }
        if (!display.iso_lines) {
            return shown;
        }
        const double change = std::hypot(log2_ratio(column + 1, row) - here, log2_ratio(column, row - 1) - here);
        return with_iso_line(shown, here, shift_.step, change, display.view == View::natural);
    }

  private:
    glm::vec3 natural(int column, int row) const {
        return display_colour(factor_ * primaries_from_srgb_ * pixel(light_, column, row), frame_.exposure.linear_curve,
                              primaries_, frame_.display.brightest);
    }

    glm::vec3 luminance_view(int column, int row) const {
        const double here = stops_on_grey(column, row);
        const glm::vec3 shown =
            brightness_colour((here - brightness_.darkest) / (brightness_.brightest - brightness_.darkest));
        if (!frame_.display.iso_lines) {
            return shown;
        }
        const double right = stops_on_grey(std::min(column + 1, light_.width - 1), row);
        const double above = stops_on_grey(column, std::max(row - 1, 0));
        return with_iso_line(shown, here, brightness_.step, std::hypot(right - here, above - here), false);
    }

    double stops_on_grey(int column, int row) const {
        const float shown = factor_ * luminance(pixel(light_, column, row));
        return std::log2(static_cast<double>(std::max(shown, 1e-12f)) / shown_middle_grey);
    }

    double log2_ratio(int column, int row) const {
        return std::log2(
            sim::see(eye_, head_direction_from_pixel(frame_.eye, column + 0.5, row + 0.5)).wavelength_ratio);
    }

    const Picture& light_;
    const RenderFrame& frame_;
    float factor_;
    Primaries primaries_;
    sim::BoostAndRotation eye_;
    ShiftScale shift_;
    BrightnessScale brightness_;
    glm::mat3 primaries_from_srgb_;
};

} // namespace

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

double exposure_stops(const Picture& radiance, const Exposure& exposure) {
    if (!exposure.automatic) {
        return static_cast<double>(exposure.stops);
    }
    return std::log2(AutoExposure().adapt(metered(radiance), 0.0, static_cast<double>(exposure.stops)));
}

content::Image shown_picture(const Picture& radiance, const RenderFrame& frame, double stops, Primaries primaries) {
    const Picture light = bloomed(radiance, frame.display.bloom);
    const PixelPainter painter(light, frame, static_cast<float>(std::exp2(stops)), primaries);
    content::Image image;
    image.width = light.width;
    image.height = light.height;
    image.rgba.resize(light.values.size() / 3 * 4, 255);
    tbb::parallel_for(0, image.height, [&](int row) {
        for (int column = 0; column < image.width; ++column) {
            const glm::ivec2 from_below(column, image.height - 1 - row);
            const std::array<std::uint8_t, 3> shown =
                display_bytes(painter.colour(column, row), from_below, frame.display.dither);
            const std::size_t at = 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                        static_cast<std::size_t>(column));
            std::copy(shown.begin(), shown.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(at));
        }
    });
    return image;
}

content::Image shown_picture(const Picture& radiance, const Exposure& exposure) {
    RenderFrame frame;
    frame.eye.width = radiance.width;
    frame.eye.height = radiance.height;
    frame.exposure = exposure;
    frame.display.dither = false;
    return shown_picture(radiance, frame, exposure_stops(radiance, exposure));
}

Picture in_primaries(Picture light, Primaries primaries) {
    const glm::mat3 wanted_from_srgb(rgb_from_srgb(primaries));
    for (std::size_t i = 0; i + 2 < light.values.size(); i += 3) {
        const glm::vec3 rgb = wanted_from_srgb * glm::vec3(light.values[i], light.values[i + 1], light.values[i + 2]);
        std::copy_n(&rgb[0], 3, &light.values[i]);
    }
    return light;
}

} // namespace render
