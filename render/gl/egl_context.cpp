#include "render/gl/egl_context.h"

#include "sim/bad_input.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/core.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace render {
namespace {

constexpr int needed_version = 45;

bool lists(const char* extensions, const char* wanted) {
    return extensions != nullptr && std::strstr(extensions, wanted) != nullptr;
}

/// Displays to try, best first: hardware without a display server, Mesa without one, then whatever is the default.
std::vector<EGLDisplay> candidate_displays() {
    std::vector<EGLDisplay> displays;
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (lists(client, "EGL_EXT_platform_device") && lists(client, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE) {
            for (EGLint i = 0; i < count; ++i) {
                const EGLDeviceEXT device = devices.at(static_cast<std::size_t>(i));
                if (!lists(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software")) {
                    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
                }
            }
        }
    }
    if (lists(client, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

/// A context on an initialised display, current without a surface; EGL_NO_CONTEXT when that is not to be had.
EGLContext make_context(EGLDisplay display) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        return EGL_NO_CONTEXT;
    }
    const std::array<EGLint, 3> config_wishes{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (!lists(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) {
        eglChooseConfig(display, config_wishes.data(), &config, 1, &found);
    }
    const std::array<EGLint, 7> wishes{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, wishes.data());
    if (context == EGL_NO_CONTEXT) {
        return EGL_NO_CONTEXT;
    }
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE ||
        epoxy_gl_version() < needed_version) {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
        return EGL_NO_CONTEXT;
    }
    return context;
}

} // namespace

EglContext::EglContext() {
    for (EGLDisplay display : candidate_displays()) {
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
            continue;
        }
        if (EGLContext context = make_context(display); context != EGL_NO_CONTEXT) {
            display_ = display;
            context_ = context;
            return;
        }
        eglTerminate(display);
    }
    throw sim::BadInput("OpenGL", "", "",
                        "no EGL display of this machine offers OpenGL 4.5 core; Mesa's software rasteriser does "
                        "(Debian: libgl1-mesa-dri libegl1)");
}

EglContext::~EglContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

void require_opengl_45() {
    const int version = epoxy_gl_version();
    if (version < needed_version) {
        throw sim::BadInput("OpenGL", "version", fmt::format("{}.{}", version / 10, version % 10),
                            "4.5 or newer is needed; LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software rasteriser");
    }
}

} // namespace render
