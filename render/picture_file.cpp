#include "render/picture_file.h"

#include "render/png_chunks.h"
#include "render/whole_file.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <sstream>
#include <stb_image_write.h>
#include <string_view>
#include <system_error>

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>

namespace render {
namespace {

constexpr std::array<const char*, 1> one_channel{"Y"};
constexpr std::array<const char*, 3> three_channels{"R", "G", "B"};

void append_bytes(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

void insert_metadata(Imf::Header& header, const PictureMetadata& metadata) {
    for (const auto& [name, value] : metadata) {
        if (const auto* text = std::get_if<std::string>(&value)) {
            header.insert(name, Imf::StringAttribute(*text));
        } else if (const auto* number = std::get_if<double>(&value)) {
            header.insert(name, Imf::DoubleAttribute(*number));
        } else {
            const auto& vector = std::get<glm::dvec3>(value);
            header.insert(name, Imf::V3dAttribute(Imath::V3d(vector.x, vector.y, vector.z)));
        }
    }
}

// The file's floats seen as slices of interleaved values; OpenEXR takes the buffer as char*, for reading as for
// writing.
template <class Names>
Imf::FrameBuffer interleaved(const Names& names, char* values, std::size_t width) {
    Imf::FrameBuffer buffer;
    const std::size_t pixel_bytes = names.size() * sizeof(float);
    for (std::size_t i = 0; i < names.size(); ++i) {
        buffer.insert(names[i], Imf::Slice(Imf::FLOAT, values + i * sizeof(float), pixel_bytes, pixel_bytes * width));
    }
    return buffer;
}

Imf::Chromaticities exr_chromaticities(Primaries primaries) {
    const Chromaticities at = chromaticities(primaries);
    const auto point = [](const glm::dvec2& p) { return Imath::V2f(static_cast<float>(p.x), static_cast<float>(p.y)); };
    return {point(at.red), point(at.green), point(at.blue), Imath::V2f(0.3127f, 0.3290f)};
}

template <class Names>
std::string encode_exr(const Picture& picture, const PictureMetadata& metadata, const Names& names,
                       std::optional<Primaries> primaries) {
    Imf::Header header(picture.width, picture.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : names) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    insert_metadata(header, metadata);
    if (primaries) {
        Imf::addChromaticities(header, exr_chromaticities(*primaries));
    }
    Imf::StdOSStream stream;
    {
        std::vector<float> values = picture.values;
        Imf::OutputFile out(stream, header);
        out.setFrameBuffer(
            interleaved(names, reinterpret_cast<char*>(values.data()), static_cast<std::size_t>(picture.width)));
        out.writePixels(picture.height);
    }
    return stream.str();
}

template <class Names>
Picture decode_exr(Imf::InputFile& in, const Names& names) {
    const Imath::Box2i window = in.header().dataWindow();
    Picture picture;
    picture.width = window.max.x - window.min.x + 1;
    picture.height = window.max.y - window.min.y + 1;
    picture.channels = static_cast<int>(names.size());
    const auto width = static_cast<std::size_t>(picture.width);
    picture.values.resize(width * static_cast<std::size_t>(picture.height) * names.size());
    // OpenEXR addresses pixels by their window coordinates, so the buffer starts where pixel (0, 0) would be.
    const auto origin = static_cast<std::ptrdiff_t>(names.size() * sizeof(float)) *
                        (window.min.x + static_cast<std::ptrdiff_t>(window.min.y) * picture.width);
    in.setFrameBuffer(interleaved(names, reinterpret_cast<char*>(picture.values.data()) - origin, width));
    in.readPixels(window.min.y, window.max.y);
    return picture;
}

template <class Work>
auto reading_exr(const std::filesystem::path& file, const Work& work) {
    try {
        Imf::InputFile in(file.string().c_str());
        return work(in);
    } catch (const sim::BadInput&) {
        throw;
    } catch (const std::exception&) {
        throw sim::BadInput(file.string(), "", "", "missing, or no readable OpenEXR picture");
    }
}

} // namespace

PictureFormat picture_format(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension != ".png" && extension != ".exr") {
        throw sim::BadInput(file.string(), "extension", extension, "a picture's name must end in .png or .exr");
    }
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        throw sim::BadInput(file.string(), "", "", "the folder " + folder.string() + " does not exist");
    }
    if (std::filesystem::is_directory(file, ignored)) {
        throw sim::BadInput(file.string(), "", "", "is a folder");
    }
    return extension == ".png" ? PictureFormat::png : PictureFormat::exr;
}

void write_png(const std::filesystem::path& file, const content::Image& image, const PictureMetadata& metadata,
               Primaries primaries) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    }
    std::string bytes;
    if (stbi_write_png_to_func(&append_bytes, &bytes, image.width, image.height, 3, rgb.data(), 3 * image.width) == 0) {
        throw sim::BadInput(file.string(), "", "", "cannot be encoded as PNG: out of memory");
    }
    write_whole_file(file, with_png_chunks(bytes, metadata, primaries));
}

void write_exr(const std::filesystem::path& file, const Picture& picture, const PictureMetadata& metadata,
               std::optional<Primaries> primaries) {
    write_whole_file(file, picture.channels == 1 ? encode_exr(picture, metadata, one_channel, primaries)
                                                 : encode_exr(picture, metadata, three_channels, primaries));
}

void write_exr_channels(const std::filesystem::path& file, const Picture& picture,
                        std::span<const std::string_view> names, const PictureMetadata& metadata) {
    const std::vector<std::string> owned(names.begin(), names.end());
    std::vector<const char*> terminated;
    terminated.reserve(owned.size());
    for (const std::string& name : owned) {
        terminated.push_back(name.c_str());
    }
    write_whole_file(file, encode_exr(picture, metadata, terminated, std::nullopt));
}

Picture read_exr(const std::filesystem::path& file) {
    return reading_exr(file, [&](Imf::InputFile& in) {
        const Imf::ChannelList& channels = in.header().channels();
        if (channels.findChannel("R") != nullptr) {
            return decode_exr(in, three_channels);
        }
        if (channels.findChannel("Y") != nullptr) {
            return decode_exr(in, one_channel);
        }
        throw sim::BadInput(file.string(), "channels", "", "neither Y nor R, G, B");
    });
}

PictureMetadata read_exr_metadata(const std::filesystem::path& file) {
    return reading_exr(file, [](const Imf::InputFile& in) {
        PictureMetadata metadata;
        for (auto it = in.header().begin(); it != in.header().end(); ++it) {
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute())) {
                metadata[it.name()] = text->value();
            } else if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&it.attribute())) {
                metadata[it.name()] = number->value();
            } else if (const auto* vector = dynamic_cast<const Imf::V3dAttribute*>(&it.attribute())) {
                metadata[it.name()] = glm::dvec3(vector->value().x, vector->value().y, vector->value().z);
            }
        }
        return metadata;
    });
}

std::optional<Chromaticities> read_exr_chromaticities(const std::filesystem::path& file) {
    return reading_exr(file, [](const Imf::InputFile& in) -> std::optional<Chromaticities> {
        if (!Imf::hasChromaticities(in.header())) {
            return std::nullopt;
        }
        const Imf::Chromaticities& at = Imf::chromaticities(in.header());
        const auto point = [](const Imath::V2f& p) { return glm::dvec2(p.x, p.y); };
        return Chromaticities{point(at.red), point(at.green), point(at.blue)};
    });
}

} // namespace render
