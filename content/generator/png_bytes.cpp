#include "content/generator/png_bytes.h"

#include <stdexcept>

#include <stb_image_write.h>

namespace content::generator {

std::vector<std::uint8_t> png_bytes(const Image& image) {
    std::vector<std::uint8_t> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& target = *static_cast<std::vector<std::uint8_t>*>(context);
        const auto* first = static_cast<const std::uint8_t*>(data);
        target.insert(target.end(), first, first + size);
    };
    constexpr int channels = 4;
    if (stbi_write_png_to_func(append, &bytes, image.width, image.height, channels, image.rgba.data(),
                               image.width * channels) == 0) {
        throw std::runtime_error("the image \"" + image.name + "\" cannot be written as PNG");
    }
    return bytes;
}

} // namespace content::generator
