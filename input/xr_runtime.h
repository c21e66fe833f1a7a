#pragma once

#include "input/xr_library.h"

#include <cstdint>
#include <string>
#include <vector>

namespace input {

/// How an OpenGL context is handed to the runtime.
enum class XrGraphics : std::uint8_t {
    glx, ///< XR_KHR_opengl_enable, of a window under X
    egl, ///< XR_MNDX_egl_enable, without a window or under Wayland
};

/// The OpenXR functions in use, under their own names.
struct XrFunctions {
// clang-format off
#define RAPIDITY_XR_FUNCTIONS(use) \
    use(xrAcquireSwapchainImage) use(xrApplyHapticFeedback) use(xrAttachSessionActionSets) use(xrBeginFrame) \
    use(xrBeginSession) use(xrCreateAction) use(xrCreateActionSet) use(xrCreateActionSpace) \
    use(xrCreateReferenceSpace) use(xrCreateSession) use(xrCreateSwapchain) use(xrDestroyActionSet) \
    use(xrDestroyInstance) use(xrDestroySession) use(xrDestroySpace) use(xrDestroySwapchain) use(xrEndFrame) \
    use(xrEndSession) use(xrEnumerateReferenceSpaces) use(xrEnumerateSwapchainFormats) \
    use(xrEnumerateSwapchainImages) use(xrEnumerateViewConfigurationViews) use(xrGetActionStateBoolean) \
    use(xrGetActionStateFloat) use(xrGetActionStatePose) use(xrGetActionStateVector2f) \
    use(xrGetInstanceProperties) use(xrGetSystem) use(xrGetSystemProperties) use(xrLocateSpace) \
    use(xrLocateViews) use(xrPollEvent) use(xrReleaseSwapchainImage) use(xrRequestExitSession) \
    use(xrResultToString) use(xrStopHapticFeedback) use(xrStringToPath) \
    use(xrSuggestInteractionProfileBindings) use(xrSyncActions) use(xrWaitFrame) use(xrWaitSwapchainImage)
// clang-format on
#define RAPIDITY_XR_MEMBER(name) PFN_##name name = nullptr;
    RAPIDITY_XR_FUNCTIONS(RAPIDITY_XR_MEMBER)
#undef RAPIDITY_XR_MEMBER
};

/// An OpenXR instance and the headset that it offers.
class XrRuntime {
  public:
    /// Throws XrFailure: no loader, runtime or headset, or one without OpenGL or without two views.
    explicit XrRuntime(XrGraphics graphics);
    ~XrRuntime();
    XrRuntime(const XrRuntime&) = delete;
    XrRuntime& operator=(const XrRuntime&) = delete;

    /// For people: headset and runtime with its version.
    const std::string& name() const { return name_; }
    /// Pixels that the runtime recommends for an eye's picture.
    int recommended_width() const { return width_; }
    int recommended_height() const { return height_; }
    /// Whether pictures may come with their depths (XR_KHR_composition_layer_depth).
    bool takes_depth() const { return takes_depth_; }

    XrInstance instance() const { return instance_; }
    XrSystemId system() const { return system_; }
    const XrFunctions& call() const { return functions_; }
    XrPath path(const char* text) const;

    /// Throws XrFailure, naming the call, when it failed: `lost` where session or instance are gone.
    void check(XrResult result, const char* what) const;

  private:
    void create(XrGraphics graphics);
    void load_functions();
    void find_headset();
    void require_two_views();

    XrLibrary library_;
    XrFunctions functions_;
    XrInstance instance_ = XR_NULL_HANDLE;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
    std::string name_;
    int width_ = 0;
    int height_ = 0;
    bool takes_depth_ = false;
};

} // namespace input
