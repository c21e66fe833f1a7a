#pragma once

#include "engine/cockpit/eye_overlay.h"
#include "engine/offscreen.h"
#include "engine/option_values.h"
#include "engine/vr/eye_screens.h"
#include "input/xr_swapchain.h"
#include "render/gl/renderer.h"

#include <array>
#include <memory>
#include <vector>

namespace engine {

/// The pictures of both eyes in the runtime's textures.
class EyePictures {
  public:
    EyePictures(const input::XrFlightSession& session, const PictureSize& size);

    /// Draws what both eyes see; `frames` differ by their eyes, whose screens are `screens`. Then `overlay`, unless it
    /// is empty, over each, the eye being where `in_vehicle` says; depths, which are the scenery's, are then left out.
    void draw(render::Renderer& renderer, const input::XrEyes& eyes, const std::array<render::RenderFrame, 2>& frames,
              const std::array<EyeScreen, 2>& screens, const std::array<render::CabinView, 2>& in_vehicle,
              const EyeOverlay& overlay);
    /// Puts the pictures into the runtime's textures.
    void hand_over();
    /// The layer that shows them to a head at `base_from_head`.
    const XrCompositionLayerBaseHeader* layer(const input::XrFlightSession& session,
                                              const input::XrPlace& base_from_head, const input::XrEyes& eyes);

    PictureSize size() const { return {width_, height_}; }
    /// Of these eyes' pictures.
    std::array<EyeScreen, 2> screens(const input::XrEyes& eyes) const;

    /// The last pictures, for a mirror: each fills the lower left corner of its framebuffer as its screen says.
    const Offscreen& picture(std::size_t eye) const { return eyes_.at(eye).picture; }
    const EyeScreen& screen(std::size_t eye) const { return screens_.at(eye); }
    const render::EyeView& view(std::size_t eye) const { return eye_views_.at(eye); }
    /// Whether the last pictures came with their depths.
    bool depth_shown() const { return depth_shown_; }
    /// What the eyes had in common in the last draw.
    const render::StereoShare& share() const { return share_; }
    /// Of the last draw, by eye.
    const render::FrameStatistics& statistics(std::size_t eye) const { return statistics_.at(eye); }

  private:
    struct Eye {
        Offscreen picture;
        std::unique_ptr<input::XrSwapchainOfTextures> shown;
        std::unique_ptr<input::XrSwapchainOfTextures> depth; ///< none where the runtime takes none
    };

    std::vector<Eye> eyes_; ///< left, right
    std::array<EyeScreen, 2> screens_;
    std::array<render::EyeView, 2> eye_views_;
    std::array<render::FrameStatistics, 2> statistics_;
    render::StereoShare share_;
    std::array<XrCompositionLayerProjectionView, 2> views_{};
    std::array<XrCompositionLayerDepthInfoKHR, 2> depths_{};
    bool depth_shown_ = false; ///< both eyes' pictures come with their depths
    XrCompositionLayerProjection layer_{};
    int width_;
    int height_;
};

} // namespace engine
