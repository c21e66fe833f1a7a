// An OpenXR runtime that offers nothing but to be asked: no OpenGL.

#include "tests/xr/loader_interface.h"

#include <cstring>

namespace {

XRAPI_ATTR XrResult XRAPI_CALL enumerate_extensions(const char* /*layer*/, std::uint32_t capacity, std::uint32_t* count,
                                                    XrExtensionProperties* properties) {
    *count = 1;
    if (capacity > 0) {
        std::strcpy(properties[0].extensionName, "XR_MND_headless");
        properties[0].extensionVersion = 1;
    }
    return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL get_instance_proc_addr(XrInstance /*instance*/, const char* name,
                                                      PFN_xrVoidFunction* function) {
    *function = std::strcmp(name, "xrEnumerateInstanceExtensionProperties") == 0
                    ? reinterpret_cast<PFN_xrVoidFunction>(&enumerate_extensions)
                    : nullptr;
    return *function != nullptr ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED;
}

} // namespace

extern "C" __attribute__((visibility("default"))) XrResult
xrNegotiateLoaderRuntimeInterface(const xr_loader::LoaderInfo* /*loader*/, xr_loader::RuntimeRequest* request) {
    request->interface_version = 1;
    request->api_version = XR_MAKE_VERSION(1, 0, 0);
    request->get_instance_proc_addr = &get_instance_proc_addr;
    return XR_SUCCESS;
}
