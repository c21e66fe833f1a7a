#include "input/xr_runtime.h"

#include "input/xr_failure.h"

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/core.h>

namespace input {
namespace {

using Cause = XrFailure::Cause;

constexpr const char* egl_extension = "XR_MNDX_egl_enable"; // its header part needs EGL's headers
constexpr const char* depth_extension = XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME;

std::vector<XrExtensionProperties> offered_extensions(const XrLibrary& library) {
    const auto enumerate = library.function<PFN_xrEnumerateInstanceExtensionProperties>(
        XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties");
    std::uint32_t count = 0;
    const XrResult result = enumerate(nullptr, 0, &count, nullptr);
    if (XR_FAILED(result)) {
        throw XrFailure(Cause::no_runtime,
                        fmt::format("no OpenXR runtime can be loaded (result {}); XR_RUNTIME_JSON or "
                                    "openxr/1/active_runtime.json names one, see `rapidity doctor`",
                                    static_cast<int>(result)));
    }
    std::vector<XrExtensionProperties> extensions(count, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
    if (XR_FAILED(enumerate(nullptr, count, &count, extensions.data()))) {
        extensions.clear();
    }
    return extensions;
}

bool lists(const std::vector<XrExtensionProperties>& extensions, const char* wanted) {
    return std::ranges::any_of(extensions, [wanted](const XrExtensionProperties& extension) {
        return std::strcmp(static_cast<const char*>(extension.extensionName), wanted) == 0;
    });
}

} // namespace

XrRuntime::XrRuntime(XrGraphics graphics) {
    create(graphics);
    const auto destroy = library_.function<PFN_xrDestroyInstance>(instance_, "xrDestroyInstance");
    try {
        load_functions();
        find_headset();
    } catch (...) {
        destroy(instance_);
        throw;
    }
}

XrRuntime::~XrRuntime() {
    functions_.xrDestroyInstance(instance_);
}

void XrRuntime::create(XrGraphics graphics) {
    const std::vector<XrExtensionProperties> offered = offered_extensions(library_);
    std::vector<const char*> extensions{XR_KHR_OPENGL_ENABLE_EXTENSION_NAME};
    if (graphics == XrGraphics::egl) {
        extensions.push_back(egl_extension);
    }
    for (const char* const needed : extensions) {
        if (!lists(offered, needed)) {
            throw XrFailure(
                Cause::unsuited,
                fmt::format("the OpenXR runtime does not take OpenGL pictures here (it has no {})", needed));
        }
    }
    if (lists(offered, depth_extension)) {
        takes_depth_ = true;
        extensions.push_back(depth_extension);
    }
    XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO, nullptr, 0, {}, 0, nullptr, 0, nullptr};
    fmt::format_to_n(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE - 1, "Rapidity");
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.enabledExtensionNames = extensions.data();
    const auto create_instance = library_.function<PFN_xrCreateInstance>(XR_NULL_HANDLE, "xrCreateInstance");
    if (const XrResult result = create_instance(&info, &instance_); XR_FAILED(result)) {
        throw XrFailure(
            Cause::no_runtime,
            fmt::format("the OpenXR runtime does not start (xrCreateInstance: result {})", static_cast<int>(result)));
    }
}

void XrRuntime::load_functions() {
#define RAPIDITY_XR_FIND(name) functions_.name = library_.function<PFN_##name>(instance_, #name);
    RAPIDITY_XR_FUNCTIONS(RAPIDITY_XR_FIND)
#undef RAPIDITY_XR_FIND
}

void XrRuntime::find_headset() {
    const XrSystemGetInfo wanted{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
    const XrResult found = functions_.xrGetSystem(instance_, &wanted, &system_);
    if (found == XR_ERROR_FORM_FACTOR_UNAVAILABLE || found == XR_ERROR_FORM_FACTOR_UNSUPPORTED) {
        throw XrFailure(Cause::no_headset, "the OpenXR runtime finds no headset");
    }
    check(found, "xrGetSystem");
    XrSystemProperties system{XR_TYPE_SYSTEM_PROPERTIES, nullptr, 0, 0, {}, {}, {}};
    check(functions_.xrGetSystemProperties(instance_, system_, &system), "xrGetSystemProperties");
    XrInstanceProperties runtime{XR_TYPE_INSTANCE_PROPERTIES, nullptr, 0, {}};
    check(functions_.xrGetInstanceProperties(instance_, &runtime), "xrGetInstanceProperties");
    name_ = fmt::format("{}, {} {}.{}.{}", static_cast<const char*>(system.systemName),
                        static_cast<const char*>(runtime.runtimeName), XR_VERSION_MAJOR(runtime.runtimeVersion),
                        XR_VERSION_MINOR(runtime.runtimeVersion), XR_VERSION_PATCH(runtime.runtimeVersion));
    require_two_views();
    // The runtime must be asked before a session is made; any context of version 4.5 does.
    const auto requirements =
        library_.function<PFN_xrGetOpenGLGraphicsRequirementsKHR>(instance_, "xrGetOpenGLGraphicsRequirementsKHR");
    XrGraphicsRequirementsOpenGLKHR versions{XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR, nullptr, 0, 0};
    check(requirements(instance_, system_, &versions), "xrGetOpenGLGraphicsRequirementsKHR");
}

void XrRuntime::require_two_views() {
    std::array<XrViewConfigurationView, 2> views{};
    for (XrViewConfigurationView& view : views) {
        view.type = XR_TYPE_VIEW_CONFIGURATION_VIEW;
    }
    constexpr XrViewConfigurationType stereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    std::uint32_t count = 0;
    check(functions_.xrEnumerateViewConfigurationViews(instance_, system_, stereo, 0, &count, nullptr),
          "xrEnumerateViewConfigurationViews");
    if (count != views.size()) {
        throw XrFailure(Cause::unsuited, fmt::format("the headset shows {} views, two are needed: {}", count, name_));
    }
    check(functions_.xrEnumerateViewConfigurationViews(instance_, system_, stereo, count, &count, views.data()),
          "xrEnumerateViewConfigurationViews");
    width_ = static_cast<int>(std::min(views[0].recommendedImageRectWidth, views[1].recommendedImageRectWidth));
    height_ = static_cast<int>(std::min(views[0].recommendedImageRectHeight, views[1].recommendedImageRectHeight));
    if (width_ < 1 || height_ < 1) {
        throw XrFailure(Cause::unsuited,
                        fmt::format("the headset's views are {}x{} pixels: {}", width_, height_, name_));
    }
}

XrPath XrRuntime::path(const char* text) const {
    XrPath path = XR_NULL_PATH;
    check(functions_.xrStringToPath(instance_, text, &path), "xrStringToPath");
    return path;
}

void XrRuntime::check(XrResult result, const char* what) const {
    if (XR_SUCCEEDED(result)) {
        return;
    }
    std::array<char, XR_MAX_RESULT_STRING_SIZE> text{};
    if (XR_FAILED(functions_.xrResultToString(instance_, result, text.data()))) {
        fmt::format_to_n(text.data(), text.size() - 1, "result {}", static_cast<int>(result));
    }
    const bool lost = result == XR_ERROR_SESSION_LOST || result == XR_ERROR_INSTANCE_LOST ||
                      result == XR_ERROR_RUNTIME_FAILURE || result == XR_ERROR_RUNTIME_UNAVAILABLE;
    throw XrFailure(lost ? Cause::lost : Cause::refused, fmt::format("{}: {}", what, text.data()));
}

} // namespace input
