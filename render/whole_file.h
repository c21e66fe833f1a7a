#pragma once

#include <filesystem>
#include <string_view>

namespace render {

/// Writes a file beside its place under another name and moves it there when it is whole, so that whoever finds it
/// finds all of it. Throws sim::BadInput naming the file; nothing is left of it then.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

} // namespace render
