#pragma once

#include <filesystem>

namespace engine {

/// What there is of OpenXR on this machine, found by its files.
struct OpenXrRuntime {
    std::filesystem::path loader;   ///< the shared library; "" when not installed
    std::filesystem::path manifest; ///< of the runtime that the loader would choose; "" when there is none
};

/// Looks where the OpenXR loader looks: $XR_RUNTIME_JSON, then openxr/1/active_runtime.json in the user's and the
/// system's configuration folders.
OpenXrRuntime find_openxr_runtime();

} // namespace engine
