#pragma once

#include "content/scene_desc.h"
#include "render/colour/colour_space.h"
#include "render/render_frame.h"

#include <glm/vec3.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace render {

/// What a picture file says about its making, by name: scenario, speed, which effects are exact. OpenEXR keeps each as
/// an attribute of its own type.
using PictureMetadata = std::map<std::string, std::variant<std::string, double, glm::dvec3>>;

enum class PictureFormat : std::uint8_t { png, exr };

/// The format that a picture file's extension names, once it is known that the file can be created there. To be asked
/// before the work of making the picture. Throws sim::BadInput: unknown extension, missing folder, a folder itself.
PictureFormat picture_format(const std::filesystem::path& file);

/// Writes an 8-bit picture as PNG, without its alpha, with what it says about its making as text ("rapidity:name"
/// keywords) and the display's primaries: sRGB, or Rec. 2020 with sRGB's transfer function (cICP). All or nothing: a
/// file of that name stays as it was until the new one is complete. Throws sim::BadInput with the file and the system's
/// reason.
void write_png(const std::filesystem::path& file, const content::Image& image, const PictureMetadata& metadata = {},
               Primaries primaries = Primaries::srgb);

/// Writes 32-bit floats, losslessly compressed: one channel as Y, three as R, G, B. Light's primaries are written as
/// chromaticities; none: the channels are no colours. All or nothing, as write_png.
void write_exr(const std::filesystem::path& file, const Picture& picture, const PictureMetadata& metadata,
               std::optional<Primaries> primaries = {});

/// Writes any number of named channels, `names.size()` floats a pixel, as 32-bit floats. All or nothing, as write_png.
void write_exr_channels(const std::filesystem::path& file, const Picture& picture,
                        std::span<const std::string_view> names, const PictureMetadata& metadata);

/// Reads the channels Y or R, G, B of an OpenEXR picture. Throws sim::BadInput.
Picture read_exr(const std::filesystem::path& file);

/// The attributes of an OpenEXR picture that PictureMetadata can hold; chromaticities are not among them. Throws
/// sim::BadInput.
PictureMetadata read_exr_metadata(const std::filesystem::path& file);

/// The chromaticities that an OpenEXR picture gives; none where it gives none. Throws sim::BadInput.
std::optional<Chromaticities> read_exr_chromaticities(const std::filesystem::path& file);

} // namespace render
