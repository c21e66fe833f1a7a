#pragma once

#include <memory>
#include <string>

#include <openxr/openxr.h>

namespace input {

/// The OpenXR loader, opened while the program runs: without it everything but the headset works.
class XrLibrary {
  public:
    /// `file`: as the dynamic linker finds it. Throws XrFailure (no_loader).
    explicit XrLibrary(const std::string& file = "libopenxr_loader.so.1");

    /// A function of an instance, XR_NULL_HANDLE for those that need none. Throws XrFailure when there is no such.
    template <class Function>
    Function function(XrInstance instance, const char* name) const {
        return reinterpret_cast<Function>(find(instance, name));
    }

  private:
    struct Close {
        void operator()(void* library) const;
    };

    PFN_xrVoidFunction find(XrInstance instance, const char* name) const;

    std::unique_ptr<void, Close> library_;
    PFN_xrGetInstanceProcAddr get_ = nullptr;
};

} // namespace input
