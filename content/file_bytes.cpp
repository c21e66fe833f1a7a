#include "content/file_bytes.h"

#include "sim/bad_input.h"

#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace content {

std::vector<std::uint8_t> read_file_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        throw sim::BadInput(file.string(), "", "", "there is no such file");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw sim::BadInput(file.string(), "", "", "not a regular file");
    }
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) {
        throw sim::BadInput(file.string(), "", "", "its size cannot be read");
    }
    if (size == 0) {
        throw sim::BadInput(file.string(), "", "", "the file is empty");
    }
    if (size > maximum_file_bytes) {
        throw sim::BadInput(file.string(), "size", fmt::format("{} bytes", size),
                            fmt::format("larger than {} bytes", maximum_file_bytes));
    }
    std::ifstream stream(file, std::ios::binary);
    std::vector<std::uint8_t> bytes(size);
    if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
        throw sim::BadInput(file.string(), "", "", "cannot be read");
    }
    return bytes;
}

} // namespace content
