#include "engine/cockpit/panel_picture.h"

#include "content/generator/cabin.h"
#include "engine/hud/instrument_parts.h"
#include "engine/hud/navigation_display.h"
#include "engine/hud/palette.h"
#include "engine/hud/readouts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

namespace engine {
namespace {

constexpr ImU32 glass = IM_COL32(7, 12, 16, 255);
constexpr float margin = 14.0F;

void draw_navigation_screen(Canvas& canvas, const HudModel& model) {
    constexpr float line = 17.0F;
    constexpr std::size_t most_lines = 7;
    canvas.text({margin, 8.0F}, "navigation", canvas.fonts().small, palette::label);
    canvas.text({PanelPicture::side_width - margin, 8.0F}, model.title, canvas.fonts().small, palette::label,
                Align::right);
    std::vector<NavigationLine> lines = voyage_lines(model);
    for (const std::string& clock : clock_lines(model)) {
        lines.push_back({clock, palette::value});
    }
    if (lines.empty()) {
        lines.push_back({"no target, no beacons", palette::label});
    }
    lines.resize(std::min(lines.size(), most_lines));
    float y = 32.0F;
    for (const NavigationLine& text : lines) {
        canvas.text({margin, y}, text.text, canvas.fonts().small, text.colour);
        y += line;
    }
}

void draw_motion_screen(Canvas& canvas, const HudModel& model) {
    const float left = PanelPicture::side_width + margin + 6.0F;
    const float right = PanelPicture::width - PanelPicture::side_width - margin - 6.0F;
    draw_motion_readouts(canvas, model, {left, 14.0F});
    draw_rapidity_scale(canvas, model.readings.rapidity, left, right, 82.0F);
    float x = left;
    for (const auto& [label, value] :
         {std::pair(std::string("ship clock"), clock_text(model.ship_clock, model.clock_unit)),
          {"world clock", clock_text(model.world_clock, model.clock_unit)},
          {"felt", g_text(model.felt_g)},
          {"picture", mode_name(model.mode)}}) {
        x = readout(canvas, {x, 117.0F}, label, value, 76.0F);
    }
    const ImU32 lamp = model.recording_trouble.empty() ? palette::recording : palette::warning;
    if (model.recording || !model.recording_trouble.empty()) {
        canvas.disc({right - 4.0F, 14.0F}, 3.5F, lamp);
    }
    if (model.paused) {
        canvas.text({right - 14.0F, 7.0F}, "paused", canvas.fonts().small, palette::accent, Align::right);
    }
}

void draw_mode_buttons(PictureSettings& picture, float scale) {
    constexpr std::array modes{std::pair(render::Mode::geometry, "geometry"),
                               std::pair(render::Mode::doppler, "Doppler"),
                               std::pair(render::Mode::searchlight, "light"), std::pair(render::Mode::full, "all")};
    for (std::size_t i = 0; i < modes.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine(0.0F, 5.0F * scale);
        }
        const bool chosen = picture.mode == modes.at(i).first;
        if (chosen) {
            ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.22F, 0.50F, 0.58F, 1.0F));
        }
        if (ImGui::Button(modes.at(i).second, {64.0F * scale, 26.0F * scale})) {
            picture.mode = modes.at(i).first;
        }
        if (chosen) {
            ImGui::PopStyleColor();
        }
    }
    ImGui::Checkbox("automatic exposure", &picture.exposure.automatic);
    ImGui::SliderFloat("stops", &picture.exposure.stops, -12.0F, 12.0F, "%+.1f");
}

/// The right screen: what can be set.
void draw_settings_screen(float scale, PictureSettings& picture, ComfortSettings& comfort) {
    ImGui::SetNextWindowPos({(PanelPicture::width - PanelPicture::side_width) * scale, 0.0F});
    ImGui::SetNextWindowSize({PanelPicture::side_width * scale, PanelPicture::height * scale});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.0F, 0.0F, 0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(margin * scale, 6.0F * scale));
    ImGui::Begin("cockpit", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushItemWidth(150.0F * scale);
    if (ImGui::BeginTabBar("pages")) {
        if (ImGui::BeginTabItem("picture")) {
            draw_mode_buttons(picture, scale);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("comfort")) {
            ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8.0F * scale, 3.0F * scale));
            ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4.0F * scale, 1.0F * scale));
            draw_comfort_settings(comfort);
            ImGui::PopStyleVar(2);
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::PopItemWidth();
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

} // namespace

static_assert(content::generator::panel_aspect == 1152.0 / 162.0);

PanelPicture::PanelPicture(float scale)
    : layer_(nullptr, scale), columns_(static_cast<int>(std::lround(width * scale))),
      rows_(static_cast<int>(std::lround(height * scale))), texture_(render::Texture::create(GLenum{GL_TEXTURE_2D})),
      framebuffer_(render::Framebuffer::create()) {
    constexpr GLsizei levels = 4; // an eighth is the farthest that a screen is seen from
    glTextureStorage2D(texture_.name(), levels, GL_RGBA8, columns_, rows_);
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture_.name(), 0);
}

void PanelPicture::draw(const HudModel& model, PictureSettings& picture, ComfortSettings& comfort,
                        const PanelTouch& touch, bool locked, double seconds) {
    const std::optional<ImVec2> at =
        touch.place && !locked ? std::optional(ImVec2(static_cast<float>(touch.place->x) * static_cast<float>(columns_),
                                                      static_cast<float>(touch.place->y) * static_cast<float>(rows_)))
                               : std::nullopt;
    layer_.point(at, touch.pressed);
    layer_.begin(columns_, rows_, seconds);
    {
        Canvas canvas(*ImGui::GetBackgroundDrawList(), layer_);
        canvas.bar({0.0F, 0.0F}, {width, height}, glass);
        draw_navigation_screen(canvas, model);
        draw_motion_screen(canvas, model);
        if (locked) {
            canvas.text({width - 0.5F * side_width, 0.5F * height - 8.0F}, "demonstration", canvas.fonts().text,
                        palette::label, Align::centre);
        } else {
            draw_settings_screen(layer_.scale(), picture, comfort);
        }
        if (at) {
            Canvas pointer(*ImGui::GetForegroundDrawList(), layer_);
            pointer.circle({at->x / layer_.scale(), at->y / layer_.scale()}, touch.pressed ? 3.0F : 5.0F,
                           palette::accent, 1.5F);
        }
    }
    layer_.end(framebuffer_.name(), columns_, rows_);
    glGenerateTextureMipmap(texture_.name());
}

} // namespace engine
