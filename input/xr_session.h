#pragma once

#include "input/xr_pose.h"
#include "input/xr_runtime.h"

#include <cstdint>
#include <optional>
#include <span>

namespace input {

/// What the head's places are measured in.
enum class XrBase : std::uint8_t {
    local, ///< sitting: from where the head was at the start, or at the last recentring
    stage, ///< standing: from the middle of the floor of the pilot's room
};

/// When a frame will be seen.
struct XrFrame {
    XrTime display_time = 0; ///< of the runtime's clock, nanoseconds
    double period = 0.0;     ///< seconds from one frame to the next
    bool shown = false;      ///< false: the runtime would show no picture, so none is drawn
};

/// An OpenXR session: its states, its spaces and its frames.
class XrFlightSession {
  public:
    /// `graphics_binding`: the XrGraphicsBinding... structure of a current OpenGL context. `runtime` must outlive this.
    /// Throws XrFailure.
    XrFlightSession(const XrRuntime& runtime, const void* graphics_binding, XrBase base);
    ~XrFlightSession();
    XrFlightSession(const XrFlightSession&) = delete;
    XrFlightSession& operator=(const XrFlightSession&) = delete;

    /// Hears what the runtime has to say and follows it. Throws XrFailure (lost) when it ends session or instance.
    void poll();
    /// Frames are wanted.
    bool running() const { return running_; }
    /// Controllers are heard.
    bool focused() const { return state_ == XR_SESSION_STATE_FOCUSED; }
    /// The runtime, or request_exit, has ended the session for good.
    bool ended() const { return state_ == XR_SESSION_STATE_EXITING; }
    /// Asks the runtime to end the session; go on with frames until ended().
    void request_exit();

    /// Waits for the time to make the next frame and begins it. Only while running().
    XrFrame begin_frame();
    /// Ends it with what it shows; no layers: nothing.
    void end_frame(const XrFrame& frame, std::span<const XrCompositionLayerBaseHeader* const> layers);

    /// The head in the base space at a time. Where it is not tracked: the last known place, at rest.
    XrMotion head(XrTime time);
    /// Something else in the base space.
    XrMotion locate(XrSpace space, XrTime time) const;
    /// The eyes in the head and what their screens cover.
    XrEyes eyes(XrTime time);
    /// Counts changes of the base space's origin by the runtime: the pilot recentred with its own button.
    int origin_changes() const { return origin_changes_; }
    XrBase base() const { return base_; }

    XrSession handle() const { return session_; }
    XrSpace base_space() const { return base_space_; }
    const XrRuntime& runtime() const { return runtime_; }

  private:
    void hear(const XrEventDataBuffer& event);
    void follow(XrSessionState state);
    XrSpace reference_space(XrReferenceSpaceType type) const;

    const XrRuntime& runtime_;
    XrBase base_;
    XrSession session_ = XR_NULL_HANDLE;
    XrSpace base_space_ = XR_NULL_HANDLE;
    XrSpace head_space_ = XR_NULL_HANDLE;
    XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
    bool running_ = false;
    int origin_changes_ = 0;
    XrPlace last_head_;
    XrEyes last_eyes_;
};

} // namespace input
