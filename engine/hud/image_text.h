#pragma once

#include "content/scene_desc.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <imgui.h>

#include <string>

namespace engine {

/// Text and plates in pictures in memory, in the instruments' font; needs no OpenGL.
class ImageText {
  public:
    /// `scale`: pixels a point of text, as the instruments have it for a picture of this height.
    explicit ImageText(float scale);

    float scale() const { return scale_; }
    float width(const std::string& text) const; ///< pixels
    /// Latin text; `align`: which share of its width lies left of `at`, its upper edge.
    void write(content::Image& image, const glm::ivec2& at, const std::string& text, float align) const;
    /// A rectangle mixed in; encoded sRGB. What lies outside the picture is left out.
    void fill(content::Image& image, const glm::ivec2& low, const glm::ivec2& high, const glm::vec3& colour,
              float opacity) const;

  private:
    float scale_;
    ImFontAtlas atlas_;
    ImFont* font_ = nullptr;
    const unsigned char* coverage_ = nullptr; ///< of the atlas
    int atlas_width_ = 0;
    int atlas_height_ = 0;
};

} // namespace engine
