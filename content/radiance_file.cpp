#include "content/radiance_file.h"

#include "content/panorama.h"
#include "sim/bad_input.h"

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace content {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Reads one file from front to back.
class RadianceReader {
  public:
    RadianceReader(std::span<const std::uint8_t> bytes, const std::string& source) : bytes_(bytes), source_(source) {}

    Panorama read() {
        read_header();
        Panorama panorama;
        read_size(panorama);
        const auto width = static_cast<std::size_t>(panorama.width);
        // Every row takes four bytes at least; a size that is a lie is not made room for.
        if ((bytes_.size() - position_) / 4 < static_cast<std::size_t>(panorama.height)) {
            fail("the Radiance file is truncated");
        }
        panorama.radiance.reserve(width * static_cast<std::size_t>(panorama.height));
        std::vector<Rgbe> row(width);
        for (int y = 0; y < panorama.height; ++y) {
            read_row(row);
            for (const Rgbe& pixel : row) {
                panorama.radiance.push_back(radiance_of(pixel));
            }
        }
        return panorama;
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const { throw sim::BadInput(source_, "", "", reason); }

    std::uint8_t next() {
        if (position_ >= bytes_.size()) {
            fail("the Radiance file is truncated");
        }
        return bytes_[position_++];
    }

    std::string next_line() {
        constexpr std::size_t longest = 4096;
        std::string line;
        for (char c = static_cast<char>(next()); c != '\n'; c = static_cast<char>(next())) {
            line += c;
            if (line.size() > longest) {
                fail("the Radiance header is broken");
            }
        }
        return line;
    }

    void read_header() {
        bool is_rgbe = false;
        for (std::string line = next_line(); !line.empty(); line = next_line()) {
            is_rgbe = is_rgbe || line == "FORMAT=32-bit_rle_rgbe";
        }
        if (!is_rgbe) {
            throw sim::BadInput(source_, "FORMAT", "", "only 32-bit_rle_rgbe is read");
        }
    }

    void read_size(Panorama& panorama) {
        const std::string line = next_line();
        std::istringstream words(line);
        std::string down;
        std::string right;
        long long height = 0;
        long long width = 0;
        if (!(words >> down >> height >> right >> width) || down != "-Y" || right != "+X") {
            throw sim::BadInput(source_, "resolution", line, "must be -Y height +X width");
        }
        check_panorama_size(width, height, source_);
        panorama.width = static_cast<int>(width);
        panorama.height = static_cast<int>(height);
    }

    void read_row(std::vector<Rgbe>& row) {
        const Rgbe first = {next(), next(), next(), next()};
        if (first[0] == 2 && first[1] == 2 && first[2] < 128) {
            if (static_cast<std::size_t>(first[2]) * 256 + first[3] != row.size()) {
                fail("a row of the Radiance file has another width than the picture");
            }
            for (std::size_t channel = 0; channel < 4; ++channel) {
                read_encoded_channel(row, channel);
            }
        } else {
            position_ -= 4;
            read_pixels(row);
        }
    }

    void read_encoded_channel(std::vector<Rgbe>& row, std::size_t channel) {
        for (std::size_t x = 0; x < row.size();) {
            const std::uint8_t code = next();
            const bool run = code > 128;
            const std::size_t count = run ? code - 128U : code;
            if (count == 0 || count > row.size() - x) {
                fail("a row of the Radiance file is broken");
            }
            const std::uint8_t repeated = run ? next() : std::uint8_t{0};
            for (std::size_t i = 0; i < count; ++i, ++x) {
                row[x][channel] = run ? repeated : next();
            }
        }
    }

    // Pixels one by one; in the older encoding (1, 1, 1, n) repeats the one before n times, shifted by 8 bits for each
    // such code that follows another.
    void read_pixels(std::vector<Rgbe>& row) {
        unsigned shift = 0;
        for (std::size_t x = 0; x < row.size();) {
            const Rgbe pixel = {next(), next(), next(), next()};
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                row[x++] = pixel;
                shift = 0;
                continue;
            }
            const std::size_t count = shift < 24 ? static_cast<std::size_t>(pixel[3]) << shift : row.size();
            if (x == 0 || count > row.size() - x) {
                fail("a row of the Radiance file is broken");
            }
            for (std::size_t i = 0; i < count; ++i, ++x) {
                row[x] = row[x - 1];
            }
            shift += 8;
        }
    }

    static glm::vec3 radiance_of(const Rgbe& pixel) {
        if (pixel[3] == 0) {
            return glm::vec3(0.0f);
        }
        const float unit = std::ldexp(1.0f, pixel[3] - (128 + 8));
        return unit * glm::vec3(pixel[0], pixel[1], pixel[2]);
    }

    std::span<const std::uint8_t> bytes_;
    const std::string& source_;
    std::size_t position_ = 0;
};

} // namespace

Panorama read_radiance(std::span<const std::uint8_t> bytes, const std::string& source) {
    return RadianceReader(bytes, source).read();
}

} // namespace content
