#include "engine/hud/canvas.h"

#include "engine/hud/palette.h"

#include <algorithm>
#include <cmath>

namespace engine {

Canvas::Canvas(ImDrawList& list, const ImguiLayer& layer)
    : list_(list), layer_(layer), scale_(layer.scale()),
      size_(ImGui::GetIO().DisplaySize.x / scale_, ImGui::GetIO().DisplaySize.y / scale_) {}

float Canvas::text_width(const std::string& text, ImFont* font) const {
    return font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, text.c_str()).x / scale_;
}

float Canvas::text(ImVec2 at, const std::string& text, ImFont* font, ImU32 colour, Align align) {
    const float width = text_width(text, font);
    const float shift = align == Align::left ? 0.0F : align == Align::centre ? 0.5F * width : width;
    const ImVec2 corner = pixels({at.x - shift, at.y});
    // Whole pixels: glyphs are rasterised for them.
    const ImVec2 sharp{std::round(corner.x), std::round(corner.y)};
    const float offset = std::max(1.0F, std::round(scale_));
    list_.AddText(font, font->FontSize, {sharp.x + offset, sharp.y + offset}, palette::shadow, text.c_str());
    list_.AddText(font, font->FontSize, sharp, colour, text.c_str());
    return width;
}

void Canvas::line(ImVec2 from, ImVec2 to, ImU32 colour, float thickness) {
    list_.AddLine(pixels(from), pixels(to), palette::shadow, (thickness + 1.6F) * scale_);
    list_.AddLine(pixels(from), pixels(to), colour, thickness * scale_);
}

void Canvas::stroke(ImVec2 from, ImVec2 to, ImU32 colour, float thickness) {
    list_.AddLine(pixels(from), pixels(to), colour, thickness * scale_);
}

void Canvas::curve(const std::vector<ImVec2>& points, ImU32 colour, float thickness) {
    for (const ImVec2& point : points) {
        list_.PathLineTo(pixels(point));
    }
    list_.PathStroke(colour, 0, thickness * scale_);
}

void Canvas::circle(ImVec2 centre, float radius, ImU32 colour, float thickness) {
    list_.AddCircle(pixels(centre), radius * scale_, palette::shadow, 48, (thickness + 1.6F) * scale_);
    list_.AddCircle(pixels(centre), radius * scale_, colour, 48, thickness * scale_);
}

void Canvas::disc(ImVec2 centre, float radius, ImU32 colour) {
    list_.AddCircleFilled(pixels(centre), radius * scale_, colour, 24);
}

void Canvas::triangle(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 colour) {
    list_.AddTriangleFilled(pixels(a), pixels(b), pixels(c), colour);
}

void Canvas::shade(float clear, float dark, ImU32 colour) {
    const float top = std::min(clear, dark);
    const float bottom = std::max(clear, dark);
    const ImU32 none = colour & ~IM_COL32_A_MASK;
    const ImU32 upper = clear < dark ? none : colour;
    const ImU32 lower = clear < dark ? colour : none;
    list_.AddRectFilledMultiColor(pixels({0.0F, top}), pixels({size_.x, bottom}), upper, upper, lower, lower);
}

void Canvas::plate(ImVec2 from, ImVec2 to, ImU32 colour) {
    list_.AddRectFilled(pixels(from), pixels(to), colour, 6.0F * scale_);
}

void Canvas::bar(ImVec2 from, ImVec2 to, ImU32 colour) {
    list_.AddRectFilled(pixels(from), pixels(to), colour);
}

} // namespace engine
