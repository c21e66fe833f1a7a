#include "engine/hud/image_text.h"

#include "engine/hud/imgui_layer.h"

#include <algorithm>
#include <cmath>

namespace engine {
namespace {

constexpr float points = 13.0F;
constexpr glm::vec3 ink(0.93F, 0.96F, 0.97F);

void mix_in(content::Image& image, int x, int y, const glm::vec3& colour, float opacity) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) {
        return;
    }
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    for (int i = 0; i < 3; ++i) {
        std::uint8_t& byte = image.rgba[at + static_cast<std::size_t>(i)];
        const float mixed = (1.0F - opacity) * static_cast<float>(byte) + opacity * 255.0F * colour[i];
        byte = static_cast<std::uint8_t>(std::lround(mixed));
    }
}

} // namespace

ImageText::ImageText(float scale) : scale_(scale) {
    ImFontConfig config;
    config.OversampleH = 1; // glyphs are copied pixel by pixel
    config.OversampleV = 1;
    config.PixelSnapH = true;
    config.SizePixels = std::round(points * scale);
    const std::filesystem::path file = instrument_font();
    font_ = std::filesystem::exists(file)
                ? atlas_.AddFontFromFileTTF(file.c_str(), config.SizePixels, &config, atlas_.GetGlyphRangesDefault())
                : atlas_.AddFontDefault(&config);
    unsigned char* pixels = nullptr;
    atlas_.GetTexDataAsAlpha8(&pixels, &atlas_width_, &atlas_height_);
    coverage_ = pixels;
}

float ImageText::width(const std::string& text) const {
    float width = 0.0F;
    for (const char c : text) {
        width += font_->FindGlyph(static_cast<ImWchar>(static_cast<unsigned char>(c)))->AdvanceX;
    }
    return width;
}

void ImageText::write(content::Image& image, const glm::ivec2& at, const std::string& text, float align) const {
    float pen = std::round(static_cast<float>(at.x) - align * width(text));
    for (const char c : text) {
        const ImFontGlyph& glyph = *font_->FindGlyph(static_cast<ImWchar>(static_cast<unsigned char>(c)));
        const int left = static_cast<int>(std::lround(glyph.U0 * static_cast<float>(atlas_width_)));
        const int top = static_cast<int>(std::lround(glyph.V0 * static_cast<float>(atlas_height_)));
        const int right = static_cast<int>(std::lround(glyph.U1 * static_cast<float>(atlas_width_)));
        const int bottom = static_cast<int>(std::lround(glyph.V1 * static_cast<float>(atlas_height_)));
        const int x = static_cast<int>(std::lround(pen + glyph.X0));
        const int y = at.y + static_cast<int>(std::lround(glyph.Y0));
        for (int row = top; row < bottom; ++row) {
            for (int column = left; column < right; ++column) {
                const float covered =
                    static_cast<float>(
                        coverage_[static_cast<std::size_t>(row) * static_cast<std::size_t>(atlas_width_) +
                                  static_cast<std::size_t>(column)]) /
                    255.0F;
                mix_in(image, x + column - left, y + row - top, ink, covered);
            }
        }
        pen += glyph.AdvanceX;
    }
}

void ImageText::fill(content::Image& image, const glm::ivec2& low, const glm::ivec2& high, const glm::vec3& colour,
                     float opacity) const {
    for (int y = std::max(low.y, 0); y < std::min(high.y, image.height); ++y) {
        for (int x = std::max(low.x, 0); x < std::min(high.x, image.width); ++x) {
            mix_in(image, x, y, colour, opacity);
        }
    }
}

} // namespace engine
