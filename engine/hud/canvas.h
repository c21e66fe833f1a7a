#pragma once

#include "engine/hud/imgui_layer.h"

#include <string>
#include <vector>

namespace engine {

enum class Align { left, centre, right };

/// Text and lines in points of the instruments' scale, with a soft shadow so that they read over any sky.
class Canvas {
  public:
    Canvas(ImDrawList& list, const ImguiLayer& layer);

    float width() const { return size_.x; }  ///< points
    float height() const { return size_.y; } ///< points
    const HudFonts& fonts() const { return layer_.fonts(); }

    /// Returns the text's width in points. `at`: its upper corner or middle, by `align`.
    float text(ImVec2 at, const std::string& text, ImFont* font, ImU32 colour, Align align = Align::left);
    float text_width(const std::string& text, ImFont* font) const;
    void line(ImVec2 from, ImVec2 to, ImU32 colour, float thickness = 1.0F);
    void stroke(ImVec2 from, ImVec2 to, ImU32 colour, float thickness);           ///< a line without a shadow
    void curve(const std::vector<ImVec2>& points, ImU32 colour, float thickness); ///< through the points, no shadow
    void circle(ImVec2 centre, float radius, ImU32 colour, float thickness = 1.0F);
    void disc(ImVec2 centre, float radius, ImU32 colour);
    void triangle(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 colour);
    /// A band over the full width that darkens from `clear` to `dark` (heights).
    void shade(float clear, float dark, ImU32 colour);
    void plate(ImVec2 from, ImVec2 to, ImU32 colour);
    void bar(ImVec2 from, ImVec2 to, ImU32 colour); ///< with square corners, no shadow

  private:
    ImVec2 pixels(ImVec2 points) const { return {points.x * scale_, points.y * scale_}; }

    ImDrawList& list_;
    const ImguiLayer& layer_;
    float scale_;
    ImVec2 size_;
};

} // namespace engine
