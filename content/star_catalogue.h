#pragma once

#include "content/scene_desc.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Stars as points, and the project's own file of them, *.rstars.
///
/// World axes from the catalogues' ICRS: +x towards right ascension 0h on the equator, +y the north celestial pole, -z
/// right ascension 6h on the equator (Orion), right-handed. Positions in light-years from the Sun.
///
/// The file, little-endian: the eight bytes "RAPSTARS"; u32 version (1); u32 number of stars n; u32 length of the
/// packed data; u32 CRC-32 of the unpacked data; then the data packed by zlib, 16 n bytes in five columns:
///   u32 right ascension and i32 declination in millionths of a degree (error 0.0018 arc seconds at most),
///   f32 distance in light-years (6e-8 relative), 0 where it is not known,
///   i16 visual magnitude in thousandths (error 0.0005 at most), u16 temperature in kelvin (error 0.5 at most).
namespace content {

/// Where stars of unknown distance are placed, light-years; a catalogue's distance beyond it counts as unknown.
inline constexpr double far_shell_light_years = 10000.0;

/// Light-years in a parsec: 648000/pi astronomical units in Julian light-years.
inline constexpr double light_years_per_parsec = 3.261563777167433;

/// A unit vector, world axes. Angles in degrees, ICRS.
glm::dvec3 world_direction(double right_ascension, double declination);

/// Temperature in kelvin of a black body with the colour index B-V of a star: F. J. Ballesteros, "New insights into
/// black bodies", EPL 97 (2012) 34008. B-V is clamped to [-0.4, 2.0] (21,700 K to 3,170 K): beyond 2 molecular
/// bands and dust, not temperature, make the colour.
float temperature_from_colour_index(double b_minus_v);

/// The stars as the bytes of a *.rstars file.
std::vector<std::uint8_t> star_catalogue_bytes(const std::vector<Star>& stars);

/// Reads such bytes; `source` names them in messages. Throws sim::BadInput when they are no such file, of another
/// version, truncated or damaged.
std::vector<Star> parse_star_catalogue(std::span<const std::uint8_t> bytes, const std::string& source);

/// The same from a file.
std::vector<Star> load_star_catalogue(const std::filesystem::path& file);

/// Reads a table with the columns right_ascension_deg, declination_deg, parallax_mas, v_mag and b_minus_v (an empty
/// parallax is not known, an empty B-V counts as the Sun's 0.65). A parallax that is not positive, or too small for the
/// far shell, leaves the distance unknown. Throws sim::BadInput with line and column.
std::vector<Star> import_star_table(const std::filesystem::path& csv_file);

} // namespace content
