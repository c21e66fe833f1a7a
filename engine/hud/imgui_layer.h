#pragma once

#include <filesystem>
#include <imgui.h>
#include <memory>
#include <optional>

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

/// Dear ImGui on the current OpenGL context, with a window or without one. There may be several: between begin() and
/// end() ImGui's functions mean this one, else the one that was there before it.
class ImguiLayer {
  public:
    /// `window`: whose mouse and keyboard to use; null: none. `scale`: pixels per point of text.
    ImguiLayer(GLFWwindow* window, float scale);
    ~ImguiLayer();
    ImguiLayer(const ImguiLayer&) = delete;
    ImguiLayer& operator=(const ImguiLayer&) = delete;

    /// Begins a frame of `width` x `height` pixels, `seconds` after the last.
    void begin(int width, int height, double seconds);
    /// Without a window: where a pointer is in the next frame, pixels from the upper left corner, and whether it
    /// presses; none: nowhere. Before begin().
    void point(const std::optional<ImVec2>& at, bool pressed);
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
    /// Makes a layer's context ImGui's current one for as long as it lives.
    class Current {
      public:
        explicit Current(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
            ImGui::SetCurrentContext(context);
        }
        ~Current() { ImGui::SetCurrentContext(before_); }
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

      private:
        ImGuiContext* before_;
    };

    std::unique_ptr<ImGuiContext, DestroyContext> context_;
    std::optional<Current> drawing_; ///< between begin() and end()
    bool in_window_;
    float scale_;
    HudFonts fonts_;
};

} // namespace engine
