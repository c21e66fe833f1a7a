#include "content/image_file.h"

#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <stb_image.h>
#include <string_view>

namespace content {
namespace {

bool starts_with(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

// The decoder pads what is missing at the end of a JPEG with grey and says nothing, so that the end marker is looked
// for here. FF DA opens a scan and cannot occur within its data, so the end belongs to the last one.
bool is_complete_jpeg(std::string_view text) {
    const std::size_t last_scan = text.rfind("\xFF\xDA");
    return last_scan != std::string_view::npos && text.find("\xFF\xD9", last_scan) != std::string_view::npos;
}

} // namespace

Image decode_image(std::span<const std::uint8_t> bytes, const std::string& source, const std::string& field) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const bool is_png = starts_with(text, "\x89PNG\r\n\x1A\n");
    const bool is_jpeg = starts_with(text, "\xFF\xD8\xFF");
    if (!is_png && !is_jpeg) {
        throw sim::BadInput(source, field, "", "neither a PNG nor a JPEG");
    }
    if (is_png ? text.find("IEND") == std::string_view::npos : !is_complete_jpeg(text)) {
        throw sim::BadInput(source, field, "", "the image is truncated");
    }
    int width = 0;
    int height = 0;
    int channels = 0;
    const auto length = static_cast<int>(bytes.size());
    if (stbi_info_from_memory(bytes.data(), length, &width, &height, &channels) == 0) {
        throw sim::BadInput(source, field, "", "the image's header is broken");
    }
    if (width < 1 || height < 1 || width > maximum_image_side || height > maximum_image_side) {
        throw sim::BadInput(source, field, fmt::format("{} x {} pixels", width, height),
                            fmt::format("each side must be in 1 to {}", maximum_image_side));
    }
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(bytes.data(), length, &width, &height, &channels, 4), &stbi_image_free);
    if (!pixels) {
        throw sim::BadInput(source, field, "", "the image's data are broken");
    }
    Image image;
    image.width = width;
    image.height = height;
    const std::size_t count = std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.rgba.assign(pixels.get(), pixels.get() + count);
    return image;
}

} // namespace content
