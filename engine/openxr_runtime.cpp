#include "engine/openxr_runtime.h"

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace engine {
namespace {

std::string environment(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::filesystem::path first_existing(const std::vector<std::filesystem::path>& candidates) {
    std::error_code ignored;
    for (const std::filesystem::path& candidate : candidates) {
        if (std::filesystem::exists(candidate, ignored)) {
            return candidate;
        }
    }
    return {};
}

std::filesystem::path find_manifest() {
    if (const std::string chosen = environment("XR_RUNTIME_JSON"); !chosen.empty()) {
        return chosen;
    }
    const std::filesystem::path manifest = "openxr/1/active_runtime.json";
    std::vector<std::filesystem::path> candidates;
    if (const std::string user = environment("XDG_CONFIG_HOME"); !user.empty()) {
        candidates.push_back(user / manifest);
    } else if (const std::string home = environment("HOME"); !home.empty()) {
        candidates.push_back(std::filesystem::path(home) / ".config" / manifest);
    }
    candidates.push_back("/etc/xdg" / manifest);
    candidates.push_back("/usr/local/etc" / manifest);
    candidates.push_back("/etc" / manifest);
    return first_existing(candidates);
}

std::filesystem::path find_loader() {
    constexpr std::array folders{"/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu", "/usr/lib64", "/usr/lib",
                                 "/usr/local/lib"};
    std::vector<std::filesystem::path> candidates;
    candidates.reserve(folders.size());
    for (const char* folder : folders) {
        candidates.push_back(std::filesystem::path(folder) / "libopenxr_loader.so.1");
    }
    return first_existing(candidates);
}

} // namespace

OpenXrRuntime find_openxr_runtime() {
    return {find_loader(), find_manifest()};
}

} // namespace engine
