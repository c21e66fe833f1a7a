#pragma once

#include "engine/cockpit/comfort.h"
#include "engine/frame_builder.h"
#include "engine/hud/hud_model.h"
#include "engine/hud/imgui_layer.h"
#include "render/gl/gl_objects.h"

#include <glm/vec2.hpp>

#include <optional>

namespace engine {

/// Who operates the screens.
struct PanelTouch {
    std::optional<glm::dvec2> place; ///< shares of the picture from its upper left corner; none: nobody points at it
    bool pressed = false;
};

/// The picture that the cockpit's screens show: navigation to the left, motion and clocks in the middle, and to the
/// right what can be set, for a pointer. Needs an OpenGL 4.5 context.
class PanelPicture {
  public:
    /// `scale`: pixels per point of text.
    explicit PanelPicture(float scale);

    /// Draws what is to be read and set; changes `picture` and `comfort` at once as the pointer says. `locked`: nothing
    /// can be set.
    void draw(const HudModel& model, PictureSettings& picture, ComfortSettings& comfort, const PanelTouch& touch,
              bool locked, double seconds);

    /// Encoded, with mipmaps; its first row is the lowest.
    GLuint texture() const { return texture_.name(); }
    /// A widget was under the pointer in the last picture.
    bool hears_pointer() const { return layer_.wants_mouse(); }

    static constexpr float width = 1152.0F; ///< points
    static constexpr float height = 162.0F;
    static constexpr float side_width = 306.0F; ///< of the left and the right screen

  private:
    ImguiLayer layer_;
    int columns_;
    int rows_;
    render::Texture texture_;
    render::Framebuffer framebuffer_;
};

} // namespace engine
