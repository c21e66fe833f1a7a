#include "input/xr_session.h"

#include "input/xr_failure.h"

#include <cmath>
#include <vector>

namespace input {
namespace {

constexpr XrViewConfigurationType stereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
constexpr XrSpaceLocationFlags place_known =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;

XrFailure lost(const char* why) {
    return {XrFailure::Cause::lost, why};
}

} // namespace

XrFlightSession::XrFlightSession(const XrRuntime& runtime, const void* graphics_binding, XrBase base)
    : runtime_(runtime), base_(base) {
    const XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, graphics_binding, 0, runtime.system()};
    runtime.check(runtime.call().xrCreateSession(runtime.instance(), &info, &session_), "xrCreateSession");
    try {
        head_space_ = reference_space(XR_REFERENCE_SPACE_TYPE_VIEW);
        base_space_ =
            reference_space(base == XrBase::stage ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL);
    } catch (...) {
        runtime.call().xrDestroySession(session_);
        throw;
    }
}

XrFlightSession::~XrFlightSession() {
    runtime_.call().xrDestroySession(session_); // and all that belongs to it
}

XrSpace XrFlightSession::reference_space(XrReferenceSpaceType type) const {
    const XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, type, pose_of({})};
    XrSpace space = XR_NULL_HANDLE;
    const XrResult result = runtime_.call().xrCreateReferenceSpace(session_, &info, &space);
    if (result == XR_ERROR_REFERENCE_SPACE_UNSUPPORTED) {
        throw XrFailure(XrFailure::Cause::unsuited, "the headset knows no floor: fly without --stage");
    }
    runtime_.check(result, "xrCreateReferenceSpace");
    return space;
}

void XrFlightSession::poll() {
    for (;;) {
        XrEventDataBuffer event{};
        event.type = XR_TYPE_EVENT_DATA_BUFFER;
        const XrResult result = runtime_.call().xrPollEvent(runtime_.instance(), &event);
        runtime_.check(result, "xrPollEvent");
        if (result == XR_EVENT_UNAVAILABLE) {
            return;
        }
        hear(event);
    }
}

void XrFlightSession::hear(const XrEventDataBuffer& event) {
    switch (event.type) {
    case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED:
        follow(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state);
        break;
    case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
        throw lost("the OpenXR runtime is going away");
    case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING:
        ++origin_changes_;
        break;
    default:
        break;
    }
}

void XrFlightSession::follow(XrSessionState state) {
    state_ = state;
    switch (state) {
    case XR_SESSION_STATE_READY: {
        const XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO, nullptr, stereo};
        runtime_.check(runtime_.call().xrBeginSession(session_, &info), "xrBeginSession");
        running_ = true;
        break;
    }
    case XR_SESSION_STATE_STOPPING:
        running_ = false;
        runtime_.check(runtime_.call().xrEndSession(session_), "xrEndSession");
        break;
    case XR_SESSION_STATE_LOSS_PENDING:
        throw lost("the OpenXR runtime loses the session");
    default:
        break;
    }
}

void XrFlightSession::request_exit() {
    if (running_) {
        runtime_.check(runtime_.call().xrRequestExitSession(session_), "xrRequestExitSession");
    }
}

XrFrame XrFlightSession::begin_frame() {
    const XrFrameWaitInfo wait{XR_TYPE_FRAME_WAIT_INFO, nullptr};
    XrFrameState state{XR_TYPE_FRAME_STATE, nullptr, 0, 0, XR_FALSE};
    runtime_.check(runtime_.call().xrWaitFrame(session_, &wait, &state), "xrWaitFrame");
    const XrFrameBeginInfo begin{XR_TYPE_FRAME_BEGIN_INFO, nullptr};
    runtime_.check(runtime_.call().xrBeginFrame(session_, &begin), "xrBeginFrame");
    return {state.predictedDisplayTime, 1e-9 * static_cast<double>(state.predictedDisplayPeriod),
            state.shouldRender == XR_TRUE};
}

void XrFlightSession::end_frame(const XrFrame& frame, std::span<const XrCompositionLayerBaseHeader* const> layers) {
    const XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO,
                             nullptr,
                             frame.display_time,
                             XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
                             static_cast<std::uint32_t>(layers.size()),
                             layers.data()};
    runtime_.check(runtime_.call().xrEndFrame(session_, &end), "xrEndFrame");
}

XrMotion XrFlightSession::locate(XrSpace space, XrTime time) const {
    XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY, nullptr, 0, {}, {}};
    XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, &velocity, 0, pose_of({})};
    runtime_.check(runtime_.call().xrLocateSpace(space, base_space_, time, &location), "xrLocateSpace");
    XrMotion motion;
    motion.tracked = (location.locationFlags & place_known) == place_known;
    if (motion.tracked) {
        motion.place = place_of(location.pose);
        if ((velocity.velocityFlags & XR_SPACE_VELOCITY_LINEAR_VALID_BIT) != 0) {
            motion.velocity = {velocity.linearVelocity.x, velocity.linearVelocity.y, velocity.linearVelocity.z};
            motion.measured = true;
        }
    }
    return motion;
}

XrMotion XrFlightSession::head(XrTime time) {
    XrMotion motion = locate(head_space_, time);
    if (motion.tracked) {
        last_head_ = motion.place;
    } else {
        motion.place = last_head_;
    }
    return motion;
}

XrEyes XrFlightSession::eyes(XrTime time) {
    std::array<XrView, 2> views{};
    for (XrView& view : views) {
        view.type = XR_TYPE_VIEW;
    }
    const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, stereo, time, head_space_};
    XrViewState state{XR_TYPE_VIEW_STATE, nullptr, 0};
    std::uint32_t count = 0;
    runtime_.check(runtime_.call().xrLocateViews(session_, &info, &state, views.size(), &count, views.data()),
                   "xrLocateViews");
    constexpr XrViewStateFlags known = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    if (count != views.size()) {
        throw XrFailure(XrFailure::Cause::unsuited, "the headset's views are gone");
    }
    if ((state.viewStateFlags & known) == known) {
        for (std::size_t i = 0; i < views.size(); ++i) {
            const auto tangent = [](float angle) { return std::tan(static_cast<double>(angle)); };
            const XrFovf& field = views[i].fov;
            last_eyes_[i] = {place_of(views[i].pose), tangent(field.angleLeft), tangent(field.angleRight),
                             tangent(field.angleDown), tangent(field.angleUp)};
        }
    }
    return last_eyes_;
}

} // namespace input
