#include "content/toml_file.h"

#include "content/file_bytes.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <string_view>
#include <system_error>

namespace content {

toml::table read_toml(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    try {
        return toml::parse(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), file.string());
    } catch (const toml::parse_error& error) {
        const auto& begin = error.source().begin;
        throw sim::BadInput(file.string(), fmt::format("line {}, column {}", begin.line, begin.column), "",
                            "the TOML is broken here");
    }
}

std::vector<std::filesystem::path> toml_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->path().extension() == ".toml") {
            files.push_back(entry->path());
        }
    }
    if (error) {
        throw sim::BadInput(folder.string(), "", "",
                            "the built-in scenarios cannot be listed; RAPIDITY_CONTENT_DIR may name their folder");
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace content
