#include "engine/hud/imgui_layer.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

namespace engine {
namespace {

constexpr std::array<ImWchar, 11> glyph_ranges{0x0020, 0x00FF, // Latin
                                               0x0391, 0x03C9, // Greek
                                               0x2010, 0x2026, // dashes, ellipsis
                                               0x2070, 0x207F, // superscripts
                                               0x2212, 0x2212, // minus
                                               0};

HudFonts load_fonts(float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const auto pixels = [scale](float points) { return std::round(points * scale); };
    HudFonts fonts;
    if (const std::filesystem::path file = instrument_font(); std::filesystem::exists(file)) {
        const auto load = [&](float points) {
            return atlas.AddFontFromFileTTF(file.c_str(), pixels(points), nullptr, glyph_ranges.data());
        };
        fonts = {load(13.0F), load(15.0F), load(34.0F), true};
    } else {
        const auto load = [&](float points) {
            ImFontConfig config;
            config.SizePixels = pixels(points);
            return atlas.AddFontDefault(&config);
        };
        fonts = {load(13.0F), load(13.0F), load(26.0F), false};
    }
    ImGui::GetIO().FontDefault = fonts.text;
    return fonts;
}

/// Calm and dark: the panel is an instrument, not a dialogue.
void apply_style(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6.0F;
    style.FrameRounding = 3.0F;
    style.GrabRounding = 3.0F;
    style.WindowBorderSize = 0.0F;
    style.WindowPadding = {14.0F, 12.0F};
    style.ItemSpacing = {8.0F, 7.0F};
    style.Colors[ImGuiCol_WindowBg] = {0.035F, 0.05F, 0.065F, 0.88F};
    style.Colors[ImGuiCol_TitleBg] = {0.035F, 0.05F, 0.065F, 0.88F};
    style.Colors[ImGuiCol_TitleBgActive] = {0.06F, 0.10F, 0.13F, 0.95F};
    style.Colors[ImGuiCol_FrameBg] = {0.13F, 0.18F, 0.22F, 0.80F};
    style.Colors[ImGuiCol_SliderGrab] = {0.47F, 0.83F, 0.90F, 0.85F};
    style.Colors[ImGuiCol_SliderGrabActive] = {0.65F, 0.93F, 1.00F, 1.00F};
    style.Colors[ImGuiCol_CheckMark] = {0.55F, 0.90F, 0.97F, 1.00F};
    style.Colors[ImGuiCol_Header] = {0.16F, 0.30F, 0.36F, 0.80F};
    style.Colors[ImGuiCol_Button] = {0.16F, 0.26F, 0.32F, 0.85F};
    style.Colors[ImGuiCol_ButtonHovered] = {0.22F, 0.38F, 0.46F, 0.95F};
    style.ScaleAllSizes(scale);
}

} // namespace

std::filesystem::path instrument_font() {
    return "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
}

ImguiLayer::ImguiLayer(GLFWwindow* window, float scale)
    : context_(ImGui::CreateContext()), in_window_(window != nullptr), scale_(scale) {
    // The first layer's context stays the current one: the window's callbacks mean it.
    ImGuiContext* const before = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(context_.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // a flight leaves nothing behind but what the pilot asked for
    io.LogFilename = nullptr;
    fonts_ = load_fonts(scale);
    apply_style(scale);
    if (in_window_) {
        ImGui_ImplGlfw_InitForOpenGL(window, true);
    }
    ImGui_ImplOpenGL3_Init("#version 450 core");
    if (before != nullptr) {
        ImGui::SetCurrentContext(before);
    }
}

ImguiLayer::~ImguiLayer() {
    ImGuiContext* const before = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(context_.get());
    ImGui_ImplOpenGL3_Shutdown();
    if (in_window_) {
        ImGui_ImplGlfw_Shutdown();
    }
    if (before != context_.get()) {
        ImGui::SetCurrentContext(before);
    }
}

void ImguiLayer::begin(int width, int height, double seconds) {
    drawing_.emplace(context_.get());
    ImGui_ImplOpenGL3_NewFrame();
    if (in_window_) {
        ImGui_ImplGlfw_NewFrame();
    }
    ImGuiIO& io = ImGui::GetIO();
    // Everything is laid out in framebuffer pixels, so that text is as sharp as the monitor.
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DisplayFramebufferScale = {1.0F, 1.0F};
    io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 1.0));
    ImGui::NewFrame();
}

void ImguiLayer::end(unsigned framebuffer, int width, int height) {
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    drawing_.reset();
}

void ImguiLayer::point(const std::optional<ImVec2>& at, bool pressed) {
    const Current current(context_.get());
    ImGuiIO& io = ImGui::GetIO();
    // Set, not queued: ImGui 1.86 has no queue, and later ones take both.
    io.MousePos = at.value_or(ImVec2(-FLT_MAX, -FLT_MAX));
    io.MouseDown[0] = at.has_value() && pressed;
}

bool ImguiLayer::wants_keyboard() const {
    const Current current(context_.get());
    return ImGui::GetIO().WantTextInput;
}

bool ImguiLayer::wants_mouse() const {
    const Current current(context_.get());
    return ImGui::GetIO().WantCaptureMouse;
}

} // namespace engine
