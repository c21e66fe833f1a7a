#include "content/openexr_panorama.h"

#include "content/panorama.h"
#include "sim/bad_input.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>

#include <array>
#include <cstddef>
#include <exception>

namespace content {
namespace {

std::array<const char*, 3> channel_names(const Imf::ChannelList& channels, const std::string& source) {
    std::array<const char*, 3> names = {"R", "G", "B"};
    if (channels.findChannel("R") == nullptr && channels.findChannel("Y") != nullptr) {
        names = {"Y", "Y", "Y"};
    }
    for (const char* name : names) {
        const Imf::Channel* channel = channels.findChannel(name);
        if (channel == nullptr) {
            throw sim::BadInput(source, "channels", "", std::string("there is no channel ") + name);
        }
        if (channel->xSampling != 1 || channel->ySampling != 1) {
            throw sim::BadInput(source, std::string("channels.") + name, "", "is subsampled");
        }
    }
    return names;
}

bool are_bt709(const Imf::Chromaticities& found) {
    constexpr float rounding = 0.01f; // files round the primaries to two or three digits
    const Imf::Chromaticities bt709;
    return found.red.equalWithAbsError(bt709.red, rounding) && found.green.equalWithAbsError(bt709.green, rounding) &&
           found.blue.equalWithAbsError(bt709.blue, rounding) && found.white.equalWithAbsError(bt709.white, rounding);
}

Panorama read_pixels(Imf::InputFile& input, const std::string& source, std::vector<std::string>& notes) {
    const Imath::Box2i window = input.header().dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    check_panorama_size(width, height, source);
    const auto names = channel_names(input.header().channels(), source);
    if (Imf::hasChromaticities(input.header()) && !are_bt709(Imf::chromaticities(input.header()))) {
        notes.push_back(source + ": its primaries are not BT.709; its colours are shown as if they were");
    }
    Panorama panorama;
    panorama.width = static_cast<int>(width);
    panorama.height = static_cast<int>(height);
    panorama.radiance.resize(static_cast<std::size_t>(width * height));
    // A frame buffer counts from the pixel (0, 0), which the window need not hold.
    const std::size_t row_bytes = static_cast<std::size_t>(width) * sizeof(glm::vec3);
    char* const first = reinterpret_cast<char*>(panorama.radiance.data());
    char* const origin =
        first - (static_cast<std::ptrdiff_t>(window.min.y) * static_cast<std::ptrdiff_t>(row_bytes) +
                 static_cast<std::ptrdiff_t>(window.min.x) * static_cast<std::ptrdiff_t>(sizeof(glm::vec3)));
    const bool grey = names[0] == names[1];
    Imf::FrameBuffer target;
    for (std::size_t c = 0; c < (grey ? 1U : 3U); ++c) {
        target.insert(names[c], Imf::Slice(Imf::FLOAT, origin + c * sizeof(float), sizeof(glm::vec3), row_bytes));
    }
    input.setFrameBuffer(target);
    input.readPixels(window.min.y, window.max.y);
    if (grey) {
        for (glm::vec3& pixel : panorama.radiance) {
            pixel = glm::vec3(pixel.r);
        }
    }
    return panorama;
}

} // namespace

Panorama read_openexr(const std::filesystem::path& file, std::vector<std::string>& notes) {
    const std::string source = file.string();
    try {
        Imf::InputFile input(source.c_str());
        return read_pixels(input, source, notes);
    } catch (const sim::BadInput&) {
        throw;
    } catch (const std::exception&) {
        throw sim::BadInput(source, "", "", "the OpenEXR file is truncated or broken, or of a kind that is not read");
    }
}

} // namespace content
