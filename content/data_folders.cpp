#include "content/data_folders.h"

#include <cstdlib>

namespace content {
namespace {

std::filesystem::path folder_from_environment(const char* variable, std::filesystem::path otherwise) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0' ? std::filesystem::absolute(value) : std::move(otherwise);
}

} // namespace

std::filesystem::path content_folder() {
    return folder_from_environment("RAPIDITY_CONTENT_DIR", RAPIDITY_CONTENT_SOURCE_DIR);
}

std::filesystem::path cache_folder() {
    return folder_from_environment("RAPIDITY_CACHE_DIR",
                                   std::filesystem::path(RAPIDITY_CONTENT_SOURCE_DIR).parent_path() / "cache");
}

} // namespace content
