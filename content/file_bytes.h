#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace content {

/// The largest file that is read: 1 GiB. No scene of this program's kind comes near it.
inline constexpr std::uintmax_t maximum_file_bytes = std::uintmax_t{1} << 30U;

/// A whole file. Throws sim::BadInput when it is missing, no regular file, empty, unreadable or larger than
/// maximum_file_bytes.
std::vector<std::uint8_t> read_file_bytes(const std::filesystem::path& file);

} // namespace content
