#include "content/panorama.h"

#include "content/data_folders.h"
#include "content/file_bytes.h"
#include "content/image_file.h"
#include "content/openexr_panorama.h"
#include "content/radiance_file.h"
#include "content/srgb.h"
#include "sim/bad_input.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <span>
#include <string>

namespace content {
namespace {

constexpr std::string_view studiolight_prefix = "studiolight:";
constexpr float largest_half = 65504.0f;

Panorama read_display_image(std::span<const std::uint8_t> bytes, const std::string& source) {
    const Image image = decode_image(bytes, source, "");
    check_panorama_size(image.width, image.height, source);
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) {
        linear[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
    }
    Panorama panorama;
    panorama.width = image.width;
    panorama.height = image.height;
    panorama.radiance.resize(image.rgba.size() / 4);
    for (std::size_t i = 0; i < panorama.radiance.size(); ++i) {
        const std::uint8_t* pixel = image.rgba.data() + 4 * i;
        panorama.radiance[i] = {linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]};
    }
    return panorama;
}

void put_right(LoadedPanorama& loaded, const std::string& source) {
    std::size_t replaced = 0;
    for (glm::vec3& pixel : loaded.panorama.radiance) {
        bool good = true;
        for (int c = 0; c < 3; ++c) {
            const float component = pixel[c];
            if (!(component >= 0.0f)) {
                pixel[c] = 0.0f; // negative or not a number
                good = false;
            } else if (std::isinf(component)) {
                pixel[c] = largest_half;
                good = false;
            }
        }
        replaced += good ? 0 : 1;
    }
    if (replaced > 0) {
        loaded.notes.push_back(
            fmt::format("{}: {} pixels were negative or not finite and were replaced", source, replaced));
    }
    if (loaded.panorama.width != 2 * loaded.panorama.height) {
        loaded.notes.push_back(fmt::format("{}: {} x {} pixels are not 2 to 1; it is stretched over the whole sky",
                                           source, loaded.panorama.width, loaded.panorama.height));
    }
}

bool starts_with(std::span<const std::uint8_t> bytes, std::string_view start) {
    return bytes.size() >= start.size() && std::memcmp(bytes.data(), start.data(), start.size()) == 0;
}

} // namespace

void check_panorama_size(long long width, long long height, const std::string& source) {
    constexpr long long most_pixels = 1LL << 27;
    if (width < 1 || height < 1 || width > maximum_image_side || height > maximum_image_side ||
        width * height > most_pixels) {
        throw sim::BadInput(
            source, "size", fmt::format("{} x {} pixels", width, height),
            fmt::format("each side must be in 1 to {}, and {} pixels in all at most", maximum_image_side, most_pixels));
    }
}

LoadedPanorama load_panorama(const std::filesystem::path& file) {
    const std::string source = file.string();
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    LoadedPanorama loaded;
    if (starts_with(bytes, "\x76\x2F\x31\x01")) {
        loaded.panorama = read_openexr(file, loaded.notes);
    } else if (starts_with(bytes, "#?")) {
        loaded.panorama = read_radiance(bytes, source);
    } else {
        loaded.panorama = read_display_image(bytes, source);
    }
    loaded.panorama.name = file.filename().string();
    put_right(loaded, source);
    return loaded;
}

void turn_and_scale(Panorama& panorama, double radians, float scale) {
    // Longitude grows from -z towards +x, the other way round than the angle about +y.
    const double turns = radians / glm::two_pi<double>();
    const auto columns =
        static_cast<std::ptrdiff_t>(std::lround((turns - std::floor(turns)) * panorama.width)) % panorama.width;
    for (int row = 0; row < panorama.height; ++row) {
        const auto begin = panorama.radiance.begin() + static_cast<std::ptrdiff_t>(row) * panorama.width;
        std::rotate(begin, begin + columns, begin + panorama.width);
    }
    for (glm::vec3& pixel : panorama.radiance) {
        pixel *= scale;
    }
}

bool is_studiolight(std::string_view name) {
    return name.starts_with(studiolight_prefix);
}

std::filesystem::path studiolight_file(std::string_view name) {
    return cache_folder() / "studiolights" / "world" / name.substr(studiolight_prefix.size());
}

} // namespace content
