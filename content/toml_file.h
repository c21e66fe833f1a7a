#pragma once

#include <filesystem>
#include <toml++/toml.h>
#include <vector>

namespace content {

/// A TOML file as a table. Throws sim::BadInput with file, line and column where it cannot be read or is broken.
toml::table read_toml(const std::filesystem::path& file);

/// The *.toml files of a folder of built-in scenarios, in order of their names. Throws sim::BadInput when it cannot be
/// listed.
std::vector<std::filesystem::path> toml_files(const std::filesystem::path& folder);

} // namespace content
