#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace content {

/// The text in a gzip file. Throws sim::BadInput when it is truncated or damaged, or longer than maximum_file_bytes.
std::string text_from_gzip(std::span<const std::uint8_t> bytes, const std::string& source);

} // namespace content
