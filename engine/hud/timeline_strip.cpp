#include "engine/hud/timeline_strip.h"

#include "engine/hud/hud_model.h"
#include "engine/hud/palette.h"
#include "engine/hud/readouts.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace engine {
namespace {

constexpr std::size_t most_points = 800; // about one for two pixels of a full screen
constexpr ImU32 thrust_colour = IM_COL32(255, 190, 92, 220);
constexpr ImU32 beta_colour = IM_COL32(122, 212, 230, 255);
constexpr ImU32 gamma_colour = IM_COL32(190, 150, 255, 255);
constexpr ImU32 ground = IM_COL32(8, 12, 16, 170);

// Points.
constexpr float margin = 24.0F;
constexpr float text_height = 18.0F;
constexpr float gap = 6.0F; ///< to the readouts
constexpr float strip_height = TimelineStrip::height - text_height - gap;

std::string speed_text(const ReplayDeck& deck) {
    const double speed = deck.speed();
    const std::string factor = speed < 1.0 ? fmt::format("1/{:g}", 1.0 / speed) : fmt::format("{:g}", speed);
    return fmt::format("{}{} x", deck.paused() ? "paused, " : "", (deck.backwards() ? "-" : "") + factor);
}

} // namespace

TimelineStrip::TimelineStrip(const ReplayDeck& deck) : points_(timeline(deck.recording(), most_points)) {
    for (const TimelinePoint& point : points_) {
        largest_thrust_ = std::max(largest_thrust_, point.thrust);
        largest_rapidity_ = std::max(largest_rapidity_, std::acosh(point.gamma));
    }
}

std::optional<double> TimelineStrip::draw(const ImguiLayer& layer, const ReplayDeck& deck,
                                          const std::string& clock_unit) const {
    const float scale = layer.scale();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float left = margin * scale;
    const float width = std::max(screen.x - 2.0F * left, 1.0F);
    const float top = screen.y - (readouts_height + gap + strip_height) * scale;
    const float tall = strip_height * scale;
    const auto first = static_cast<double>(deck.first());
    const double span = std::max(static_cast<double>(deck.end()) - first, 1.0);
    const auto across = [&](double tick) { return left + width * static_cast<float>((tick - first) / span); };

    ImGui::SetNextWindowPos({left, top - text_height * scale});
    ImGui::SetNextWindowSize({width, tall + text_height * scale});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::Begin("timeline", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    ImGui::InvisibleButton("scrub", {width, tall + text_height * scale});
    std::optional<double> wanted;
    if (ImGui::IsItemActive()) {
        wanted = first + span * static_cast<double>((ImGui::GetIO().MousePos.x - left) / width);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left, top}, {left + width, top + tall}, ground, 4.0F * scale);
    const auto curve = [&](ImU32 colour, const auto& share) {
        for (std::size_t i = 1; i < points_.size(); ++i) {
            const auto at = [&](const TimelinePoint& point) {
                return ImVec2(across(static_cast<double>(point.tick)),
                              top + tall * (0.96F - 0.92F * static_cast<float>(share(point))));
            };
            list.AddLine(at(points_[i - 1]), at(points_[i]), colour, 1.5F * scale);
        }
    };
    if (largest_thrust_ > 0.0) {
        curve(thrust_colour, [this](const TimelinePoint& p) { return p.thrust / largest_thrust_; });
    }
    if (largest_rapidity_ > 0.0) { // gamma by its logarithm: it may grow without end
        curve(gamma_colour, [this](const TimelinePoint& p) { return std::acosh(p.gamma) / largest_rapidity_; });
    }
    curve(beta_colour, [](const TimelinePoint& p) { return p.beta; });
    for (const ReplayMark& mark : deck.marks()) {
        const float x = across(static_cast<double>(mark.tick));
        list.AddLine({x, top}, {x, top + tall}, palette::line, scale);
        if (ImGui::IsItemHovered() && std::abs(ImGui::GetIO().MousePos.x - x) < 4.0F * scale) {
            ImGui::SetTooltip("%s", mark.what.c_str());
        }
    }
    const float now = across(deck.position());
    list.AddLine({now, top - 3.0F * scale}, {now, top + tall + 3.0F * scale}, palette::value, 2.0F * scale);

    ImFont* font = layer.fonts().small;
    const float size = font->FontSize;
    float x = left;
    const auto word = [&](const std::string& text, ImU32 colour) {
        list.AddText(font, size, {x, top - text_height * scale}, colour, text.c_str());
        x += font->CalcTextSizeA(size, width, 0.0F, text.c_str()).x + 14.0F * scale;
    };
    const sim::VehicleState state = deck.state();
    word(clock_text(state.ship_clock.value, clock_unit), palette::value);
    word(speed_text(deck), palette::value);
    word(fmt::format("thrust, to {:.3g} c/{}", largest_thrust_, clock_unit), thrust_colour);
    word("beta, 0 to 1", beta_colour);
    word(fmt::format("gamma, 1 to {:.3g} (its logarithm)", std::cosh(largest_rapidity_)), gamma_colour);
    ImGui::End();
    ImGui::PopStyleVar();
    return wanted;
}

} // namespace engine
