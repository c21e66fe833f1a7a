#pragma once

#include <cstddef>
#include <cstdint>

#include <openxr/openxr.h>

/// What OpenXR's loader, its layers and runtimes agree on (OpenXR loader specification, 'Loader Design'); the headers
/// of OpenXR 1.0 leave it out. Version 1 of everything.
namespace xr_loader {

enum class Structure : std::uint32_t {
    none,
    loader_info,
    layer_request,
    runtime_request,
    layer_create_info,
    next_info
};

struct LoaderInfo {
    Structure type;
    std::uint32_t version;
    std::size_t size;
    std::uint32_t least_interface;
    std::uint32_t most_interface;
    XrVersion least_api;
    XrVersion most_api;
};

struct NextInfo {
    Structure type;
    std::uint32_t version;
    std::size_t size;
    char layer_name[XR_MAX_API_LAYER_NAME_SIZE];
    PFN_xrGetInstanceProcAddr get_instance_proc_addr;
    XrResult(XRAPI_PTR* create_api_layer_instance)(const XrInstanceCreateInfo*, const struct CreateInfo*, XrInstance*);
    NextInfo* next;
};

struct CreateInfo {
    Structure type;
    std::uint32_t version;
    std::size_t size;
    void* loader_instance;
    char settings_file[512];
    NextInfo* next_info;
};

using CreateLayerInstance = XrResult(XRAPI_PTR*)(const XrInstanceCreateInfo*, const CreateInfo*, XrInstance*);

struct LayerRequest {
    Structure type;
    std::uint32_t version;
    std::size_t size;
    std::uint32_t interface_version;
    XrVersion api_version;
    PFN_xrGetInstanceProcAddr get_instance_proc_addr;
    CreateLayerInstance create_instance;
};

struct RuntimeRequest {
    Structure type;
    std::uint32_t version;
    std::size_t size;
    std::uint32_t interface_version;
    XrVersion api_version;
    PFN_xrGetInstanceProcAddr get_instance_proc_addr;
};

} // namespace xr_loader
