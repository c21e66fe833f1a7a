#include "content/gzip.h"

#include "content/file_bytes.h"
#include "sim/bad_input.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <zlib.h>

namespace content {

std::string text_from_gzip(std::span<const std::uint8_t> bytes, const std::string& source) {
    z_stream stream{};
    constexpr int gzip_format = 16 + MAX_WBITS;
    if (inflateInit2(&stream, gzip_format) != Z_OK) {
        throw std::runtime_error("the gzip file cannot be unpacked: memory is short");
    }
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> closer(&stream, &inflateEnd);
    // zlib promises not to write here, but its type does not say so.
    stream.next_in = const_cast<Bytef*>(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    std::array<char, 65536> block{};
    int result = Z_OK;
    while (result == Z_OK) {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        result = inflate(&stream, Z_NO_FLUSH);
        text.append(block.data(), block.size() - stream.avail_out);
        if (text.size() > maximum_file_bytes) {
            throw sim::BadInput(source, "size", "", "unpacked, it is larger than 1 GiB");
        }
    }
    if (result != Z_STREAM_END) {
        throw sim::BadInput(source, "", "", "the gzip file is truncated or damaged");
    }
    return text;
}

} // namespace content
