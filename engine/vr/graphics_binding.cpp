#include "engine/vr/graphics_binding.h"

#include "input/xr_failure.h"

#include <epoxy/egl.h>
#include <epoxy/glx.h>

#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_PLATFORM_EGL
#include <openxr/openxr_platform.h>

#include <array>
#include <cstdlib>

namespace engine {
namespace {

XrGraphicsBindingEGLMNDX egl_binding(EGLContext context) {
    EGLDisplay display = eglGetCurrentDisplay();
    // A context that was made without a config has the number 0, and none is found for it: that is what is handed over.
    EGLint number = 0;
    eglQueryContext(display, context, EGL_CONFIG_ID, &number);
    const std::array<EGLint, 3> wanted{EGL_CONFIG_ID, number, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (number != 0) {
        eglChooseConfig(display, wanted.data(), &config, 1, &found);
    }
    return {XR_TYPE_GRAPHICS_BINDING_EGL_MNDX, nullptr, eglGetProcAddress, display, config, context};
}

XrGraphicsBindingOpenGLXlibKHR glx_binding(GLXContext context) {
    Display* const display = glXGetCurrentDisplay();
    int number = 0;
    glXQueryContext(display, context, GLX_FBCONFIG_ID, &number);
    const std::array<int, 3> wanted{GLX_FBCONFIG_ID, number, 0};
    int found = 0;
    GLXFBConfig* const configs = glXChooseFBConfig(display, DefaultScreen(display), wanted.data(), &found);
    if (configs == nullptr || found == 0) {
        throw input::XrFailure(input::XrFailure::Cause::unsuited, "the window's OpenGL context has no GLX config");
    }
    GLXFBConfig config = configs[0];
    XFree(configs);
    int visual = 0;
    glXGetFBConfigAttrib(display, config, GLX_VISUAL_ID, &visual);
    return {XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR,
            nullptr,
            display,
            static_cast<std::uint32_t>(visual),
            config,
            glXGetCurrentDrawable(),
            context};
}

} // namespace

struct GraphicsBinding::Structures {
    XrGraphicsBindingEGLMNDX egl{};
    XrGraphicsBindingOpenGLXlibKHR glx{};
    input::XrGraphics graphics = input::XrGraphics::egl;
};

GraphicsBinding::GraphicsBinding() : structures_(std::make_unique<Structures>()) {
    if (EGLContext egl = eglGetCurrentContext(); egl != EGL_NO_CONTEXT) {
        structures_->egl = egl_binding(egl);
        return;
    }
    if (GLXContext glx = glXGetCurrentContext(); glx != nullptr) {
        structures_->glx = glx_binding(glx);
        structures_->graphics = input::XrGraphics::glx;
        return;
    }
    throw input::XrFailure(input::XrFailure::Cause::unsuited, "the window's OpenGL is neither GLX nor EGL");
}

GraphicsBinding::~GraphicsBinding() = default;

input::XrGraphics GraphicsBinding::graphics() const {
    return structures_->graphics;
}

const void* GraphicsBinding::structure() const {
    return structures_->graphics == input::XrGraphics::egl ? static_cast<const void*>(&structures_->egl)
                                                           : static_cast<const void*>(&structures_->glx);
}

} // namespace engine
