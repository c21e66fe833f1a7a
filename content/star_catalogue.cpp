#include "content/star_catalogue.h"

#include "content/file_bytes.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <zlib.h>

namespace content {
namespace {

static_assert(std::endian::native == std::endian::little, "the columns are copied as they lie in memory");

constexpr std::array<char, 8> magic = {'R', 'A', 'P', 'S', 'T', 'A', 'R', 'S'};
constexpr std::uint32_t version = 1;
constexpr std::size_t header_bytes = 24;
constexpr std::size_t star_bytes = 16;
constexpr std::uint32_t most_stars = 1U << 24U;
constexpr double units_per_degree = 1e6;
constexpr double units_per_magnitude = 1e3;

template <class Number>
void append(std::vector<std::uint8_t>& bytes, Number number) {
    const std::size_t offset = bytes.size();
    bytes.resize(offset + sizeof(number));
    std::memcpy(bytes.data() + offset, &number, sizeof(number));
}

template <class Number>
Number number_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
    Number number{};
    std::memcpy(&number, bytes.data() + offset, sizeof(number));
    return number;
}

template <class Integer>
Integer rounded(double value) {
    return static_cast<Integer>(std::clamp(std::round(value), static_cast<double>(std::numeric_limits<Integer>::min()),
                                           static_cast<double>(std::numeric_limits<Integer>::max())));
}

struct Angles {
    double right_ascension = 0.0; // degrees, in [0, 360)
    double declination = 0.0;     // degrees
};

Angles angles_of(const glm::dvec3& position) {
    const double equatorial = std::hypot(position.x, position.z);
    const double right_ascension = glm::degrees(std::atan2(-position.z, position.x));
    return {right_ascension < 0.0 ? right_ascension + 360.0 : right_ascension,
            glm::degrees(std::atan2(position.y, equatorial))};
}

std::vector<std::uint8_t> columns_of(const std::vector<Star>& stars) {
    std::vector<std::uint8_t> columns;
    columns.reserve(stars.size() * star_bytes);
    for (const Star& star : stars) {
        append(columns, rounded<std::uint32_t>(units_per_degree * angles_of(star.position).right_ascension));
    }
    for (const Star& star : stars) {
        append(columns, rounded<std::int32_t>(units_per_degree * angles_of(star.position).declination));
    }
    for (const Star& star : stars) {
        append(columns, star.distance_known ? static_cast<float>(glm::length(star.position)) : 0.0f);
    }
    for (const Star& star : stars) {
        append(columns, rounded<std::int16_t>(units_per_magnitude * static_cast<double>(star.visual_magnitude)));
    }
    for (const Star& star : stars) {
        append(columns, rounded<std::uint16_t>(static_cast<double>(star.temperature)));
    }
    return columns;
}

std::vector<std::uint8_t> unpacked(std::span<const std::uint8_t> packed, std::size_t size, const std::string& source) {
    std::vector<std::uint8_t> columns(size);
    uLongf length = size;
    const int result = uncompress(columns.data(), &length, packed.data(), packed.size());
    if (result != Z_OK || length != size) {
        throw sim::BadInput(source, "data", "", "the packed stars are damaged");
    }
    return columns;
}

Star star_at(std::span<const std::uint8_t> columns, std::size_t count, std::size_t index, const std::string& source) {
    const double right_ascension = number_at<std::uint32_t>(columns, 4 * index) / units_per_degree;
    const double declination = number_at<std::int32_t>(columns, 4 * count + 4 * index) / units_per_degree;
    const auto distance = number_at<float>(columns, 8 * count + 4 * index);
    const auto magnitude = number_at<std::int16_t>(columns, 12 * count + 2 * index);
    const auto temperature = number_at<std::uint16_t>(columns, 14 * count + 2 * index);
    if (right_ascension > 360.0 || std::abs(declination) > 90.0 || !(distance >= 0.0f) || !std::isfinite(distance) ||
        temperature == 0) {
        throw sim::BadInput(source, fmt::format("star {}", index), "", "its numbers are out of range");
    }
    Star star;
    star.distance_known = distance > 0.0f;
    star.position = (star.distance_known ? static_cast<double>(distance) : far_shell_light_years) *
                    world_direction(right_ascension, declination);
    star.visual_magnitude = static_cast<float>(magnitude / units_per_magnitude);
    star.temperature = temperature;
    return star;
}

} // namespace

glm::dvec3 world_direction(double right_ascension, double declination) {
    const double alpha = glm::radians(right_ascension);
    const double delta = glm::radians(declination);
    return {std::cos(delta) * std::cos(alpha), std::sin(delta), -std::cos(delta) * std::sin(alpha)};
}

float temperature_from_colour_index(double b_minus_v) {
    const double index = 0.92 * std::clamp(b_minus_v, -0.4, 2.0);
    return static_cast<float>(4600.0 * (1.0 / (index + 1.7) + 1.0 / (index + 0.62)));
}

std::vector<std::uint8_t> star_catalogue_bytes(const std::vector<Star>& stars) {
    const std::vector<std::uint8_t> columns = columns_of(stars);
    uLongf packed_length = compressBound(columns.size());
    std::vector<std::uint8_t> packed(packed_length);
    if (compress2(packed.data(), &packed_length, columns.data(), columns.size(), Z_BEST_COMPRESSION) != Z_OK) {
        throw std::runtime_error("the stars cannot be packed: memory is short");
    }
    packed.resize(packed_length);
    std::vector<std::uint8_t> bytes;
    append(bytes, magic);
    append(bytes, version);
    append(bytes, static_cast<std::uint32_t>(stars.size()));
    append(bytes, static_cast<std::uint32_t>(packed.size()));
    append(bytes, static_cast<std::uint32_t>(crc32(0, columns.data(), static_cast<uInt>(columns.size()))));
    bytes.insert(bytes.end(), packed.begin(), packed.end());
    return bytes;
}

std::vector<Star> parse_star_catalogue(std::span<const std::uint8_t> bytes, const std::string& source) {
    if (bytes.size() < magic.size() || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) {
        throw sim::BadInput(source, "", "", "not a star catalogue of this program");
    }
    if (bytes.size() < header_bytes) {
        throw sim::BadInput(source, "header", "", "the catalogue is truncated");
    }
    const auto found_version = number_at<std::uint32_t>(bytes, 8);
    if (found_version != version) {
        throw sim::BadInput(source, "version", std::to_string(found_version),
                            fmt::format("this program reads version {}; import the catalogue again", version));
    }
    const auto count = number_at<std::uint32_t>(bytes, 12);
    if (count > most_stars) {
        throw sim::BadInput(source, "count", std::to_string(count), fmt::format("more than {} stars", most_stars));
    }
    const auto packed_length = number_at<std::uint32_t>(bytes, 16);
    if (packed_length != bytes.size() - header_bytes) {
        throw sim::BadInput(
            source, "length", std::to_string(packed_length),
            fmt::format("the catalogue is truncated: {} bytes follow the header", bytes.size() - header_bytes));
    }
    const std::vector<std::uint8_t> columns = unpacked(bytes.subspan(header_bytes), star_bytes * count, source);
    if (crc32(0, columns.data(), static_cast<uInt>(columns.size())) != number_at<std::uint32_t>(bytes, 20)) {
        throw sim::BadInput(source, "checksum", "", "the catalogue is damaged");
    }
    std::vector<Star> stars;
    stars.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        stars.push_back(star_at(columns, count, i, source));
    }
    return stars;
}

std::vector<Star> load_star_catalogue(const std::filesystem::path& file) {
    return parse_star_catalogue(read_file_bytes(file), file.string());
}

} // namespace content
