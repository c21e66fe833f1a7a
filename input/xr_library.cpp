#include "input/xr_library.h"

#include "input/xr_failure.h"

#include <cstdlib>
#include <dlfcn.h>
#include <fmt/core.h>

namespace input {

void XrLibrary::Close::operator()(void* library) const {
    dlclose(library);
}

XrLibrary::XrLibrary(const std::string& file) {
    // The loader complains in many lines; what it cannot do is said here, in one. Who wants its lines sets this.
    setenv("XR_LOADER_DEBUG", "none", 0);
    library_.reset(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL));
    if (!library_) {
        const char* const reason = dlerror();
        throw XrFailure(XrFailure::Cause::no_loader,
                        fmt::format("the OpenXR loader cannot be opened ({}; Debian: libopenxr-loader1)",
                                    reason != nullptr ? reason : file));
    }
    get_ = reinterpret_cast<PFN_xrGetInstanceProcAddr>(dlsym(library_.get(), "xrGetInstanceProcAddr"));
    if (get_ == nullptr) {
        throw XrFailure(XrFailure::Cause::no_loader, file + " is no OpenXR loader");
    }
}

PFN_xrVoidFunction XrLibrary::find(XrInstance instance, const char* name) const {
    PFN_xrVoidFunction found = nullptr;
    if (XR_FAILED(get_(instance, name, &found)) || found == nullptr) {
        throw XrFailure(XrFailure::Cause::unsuited, fmt::format("the OpenXR runtime has no {}", name));
    }
    return found;
}

} // namespace input
