#include "content/panorama_name.h"

#include "content/data_folders.h"

namespace content {
namespace {

constexpr std::string_view prefix = "studiolight:";

} // namespace

bool is_studiolight(std::string_view name) {
    return name.starts_with(prefix);
}

std::filesystem::path studiolight_file(std::string_view name) {
    return cache_folder() / "studiolights" / "world" / name.substr(prefix.size());
}

} // namespace content
