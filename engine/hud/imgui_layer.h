#pragma once

#include <filesystem>
#include <imgui.h>
#include <memory>

struct GLFWwindow;

namespace engine {

/// Sizes of text that the instruments use, each rasterised at its own size so that it stays crisp.
struct HudFonts {
    ImFont* small = nullptr;
    ImFont* text = nullptr;
    ImFont* large = nullptr;
    bool greek = false; ///< false: no font with Greek letters was found, say words instead
};

/// The font that the instruments want: proportional, with Greek letters (Debian: fonts-dejavu-core).
std::filesystem::path instrument_font();

/// Dear ImGui on the current OpenGL context, with a window or without one.
class ImguiLayer {
  public:
    /// `window`: whose mouse and keyboard to use; null: none. `scale`: pixels per point of text.
    ImguiLayer(GLFWwindow* window, float scale);
    ~ImguiLayer();
    ImguiLayer(const ImguiLayer&) = delete;
    ImguiLayer& operator=(const ImguiLayer&) = delete;

    /// Begins a frame of `width` x `height` pixels, `seconds` after the last.
    void begin(int width, int height, double seconds);
    /// Draws what was built since into the framebuffer.
    void end(unsigned framebuffer, int width, int height);

    const HudFonts& fonts() const { return fonts_; }
    float scale() const { return scale_; }
    bool wants_keyboard() const;
    bool wants_mouse() const;

  private:
    struct DestroyContext {
        void operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }
    };
    std::unique_ptr<ImGuiContext, DestroyContext> context_;
    bool in_window_;
    float scale_;
    HudFonts fonts_;
};

} // namespace engine
