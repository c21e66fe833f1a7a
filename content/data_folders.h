#pragma once

#include <filesystem>

namespace content {

/// Where the program's own data are: $RAPIDITY_CONTENT_DIR, else the content/ folder of the sources it was built from.
std::filesystem::path content_folder();

/// Where fetched data are that are not part of the sources: $RAPIDITY_CACHE_DIR, else cache/ beside content/.
std::filesystem::path cache_folder();

} // namespace content
