#pragma once

#include "input/xr_session.h"

#include <cstdint>
#include <span>
#include <vector>

namespace input {

/// The pictures that an eye's screen takes turns to show: OpenGL textures of the runtime's, by their names.
class XrSwapchainOfTextures {
  public:
    enum class Use : std::uint8_t { colour, depth };

    /// `formats`: OpenGL's internal formats, best first. Throws XrFailure when the runtime has none of them.
    XrSwapchainOfTextures(const XrFlightSession& session, int width, int height, Use use,
                          std::span<const std::int64_t> formats);
    ~XrSwapchainOfTextures();
    XrSwapchainOfTextures(const XrSwapchainOfTextures&) = delete;
    XrSwapchainOfTextures& operator=(const XrSwapchainOfTextures&) = delete;

    /// The texture to draw the next picture into; waits until the runtime has read it.
    std::uint32_t acquire();
    /// Hands it over.
    void release();

    XrSwapchain handle() const { return swapchain_; }
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    const XrRuntime& runtime_;
    XrSwapchain swapchain_ = XR_NULL_HANDLE;
    std::vector<std::uint32_t> textures_;
    int width_;
    int height_;
};

} // namespace input
