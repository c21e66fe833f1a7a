#include "content/panorama.h"
#include "sim/bad_input.h"
#include "tests/content/gltf_samples.h"
#include "tests/content/temporary_folder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

using Pixels = std::vector<glm::vec3>;

void write_exr(const std::filesystem::path& file, int width, int height, const Pixels& pixels,
               Imf::Compression compression, const char* names = "RGB") {
    Imf::Header header(width, height);
    header.compression() = compression;
    // A window that does not begin at the origin, as a cropped picture's.
    header.dataWindow() = {{3, -2}, {3 + width - 1, -2 + height - 1}};
    Imf::FrameBuffer source;
    auto* first = reinterpret_cast<char*>(const_cast<glm::vec3*>(pixels.data()));
    const std::size_t row = sizeof(glm::vec3) * static_cast<std::size_t>(width);
    char* origin = first + 2 * static_cast<std::ptrdiff_t>(row) - 3 * static_cast<std::ptrdiff_t>(sizeof(glm::vec3));
    for (int c = 0; names[c] != '\0'; ++c) {
        const std::string name(1, names[c]);
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        source.insert(
            name, Imf::Slice(Imf::FLOAT, origin + sizeof(float) * static_cast<std::size_t>(c), sizeof(glm::vec3), row));
    }
    Imf::OutputFile output(file.string().c_str(), header);
    output.setFrameBuffer(source);
    output.writePixels(height);
}

Pixels smooth_sky(int width, int height) {
    Pixels pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto u = static_cast<float>(x) / static_cast<float>(width);
            const auto v = static_cast<float>(y) / static_cast<float>(height);
            pixels.emplace_back(0.25f + u, 0.5f + 0.25f * v, 2.0f - u * v);
        }
    }
    return pixels;
}

} // namespace

TEST_CASE("OpenEXR panoramas of every compression") {
    const auto compression = static_cast<Imf::Compression>(
        GENERATE(Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
                 Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION,
                 Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION));
    const samples::TemporaryFolder folder;
    const Pixels sky = smooth_sky(64, 32);
    write_exr(folder.path() / "sky.exr", 64, 32, sky, compression);
    const auto loaded = content::load_panorama(folder.path() / "sky.exr");
    CHECK(loaded.panorama.name == "sky.exr");
    CHECK(loaded.panorama.width == 64);
    CHECK(loaded.panorama.height == 32);
    CHECK(loaded.notes.empty());
    REQUIRE(loaded.panorama.radiance.size() == sky.size());
    float largest = 0.0f;
    for (std::size_t i = 0; i < sky.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            largest = std::max(largest, std::abs(loaded.panorama.radiance[i][c] - sky[i][c]));
        }
    }
    // DWAA and DWAB keep what the eye distinguishes, PXR24 24 bits; the others every bit.
    const bool lossy = compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
    CHECK(largest <= (lossy ? 0.03f : compression == Imf::PXR24_COMPRESSION ? 1e-4f : 0.0f));
}

TEST_CASE("a grey OpenEXR is grey, one without colours refused") {
    const samples::TemporaryFolder folder;
    const Pixels sky = smooth_sky(8, 4);
    write_exr(folder.path() / "grey.exr", 8, 4, sky, Imf::ZIP_COMPRESSION, "Y");
    const auto loaded = content::load_panorama(folder.path() / "grey.exr");
    CHECK(loaded.panorama.radiance[5] == glm::vec3(sky[5].r));
    write_exr(folder.path() / "depth.exr", 8, 4, sky, Imf::ZIP_COMPRESSION, "Z");
    CHECK_THROWS_MATCHES(content::load_panorama(folder.path() / "depth.exr"), sim::BadInput,
                         MessageMatches(ContainsSubstring("channels: there is no channel R")));
}

TEST_CASE("what is no radiance is replaced and counted") {
    const samples::TemporaryFolder folder;
    Pixels sky(12, glm::vec3(1.0f));
    sky[1].g = std::numeric_limits<float>::quiet_NaN();
    sky[2] = glm::vec3(-1.0f, 2.0f, -3.0f);
    sky[3].b = std::numeric_limits<float>::infinity();
    write_exr(folder.path() / "odd.exr", 6, 2, sky, Imf::NO_COMPRESSION);
    const auto loaded = content::load_panorama(folder.path() / "odd.exr");
    CHECK(loaded.panorama.radiance[1] == glm::vec3(1.0f, 0.0f, 1.0f));
    CHECK(loaded.panorama.radiance[2] == glm::vec3(0.0f, 2.0f, 0.0f));
    CHECK(std::isfinite(loaded.panorama.radiance[3].b));
    REQUIRE(loaded.notes.size() == 2);
    CHECK_THAT(loaded.notes[0], ContainsSubstring("3 pixels were negative or not finite"));
    CHECK_THAT(loaded.notes[1], ContainsSubstring("6 x 2 pixels are not 2 to 1"));
}

TEST_CASE("a truncated or damaged OpenEXR is refused") {
    const samples::TemporaryFolder folder;
    const auto file = folder.path() / "sky.exr";
    write_exr(file, 64, 32, smooth_sky(64, 32), Imf::PIZ_COMPRESSION);
    const auto size = std::filesystem::file_size(file);
    const auto kept = GENERATE_COPY(size - 1, size / 2, std::uintmax_t{100}, std::uintmax_t{5});
    std::filesystem::resize_file(file, kept);
    CHECK_THROWS_MATCHES(content::load_panorama(file), sim::BadInput,
                         MessageMatches(ContainsSubstring("the OpenEXR file is truncated or broken")));
}

TEST_CASE("Radiance files, plain and run-length encoded") {
    const samples::TemporaryFolder folder;
    // RGBE: mantissa / 256 * 2^(exponent - 128).
    std::string plain = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    plain += std::string("\x80\x40\x20\x81", 4) + std::string("\xFF\x00\x00\x88", 4);
    auto loaded = content::load_panorama(folder.write("plain.hdr", plain));
    REQUIRE(loaded.panorama.radiance.size() == 2);
    CHECK(loaded.panorama.radiance[0] == glm::vec3(1.0f, 0.5f, 0.25f));
    CHECK(loaded.panorama.radiance[1] == glm::vec3(255.0f, 0.0f, 0.0f));

    std::string encoded = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n";
    encoded += std::string("\x02\x02\x00\x08", 4);
    for (const char channel : {'\x80', '\x40', '\x20', '\x81'}) {
        encoded += std::string("\x88", 1) + std::string(1, channel);
    }
    loaded = content::load_panorama(folder.write("encoded.hdr", encoded));
    CHECK(loaded.panorama.radiance == Pixels(8, glm::vec3(1.0f, 0.5f, 0.25f)));

    std::string repeated = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 4\n";
    repeated += std::string("\x80\x40\x20\x81", 4) + std::string("\x01\x01\x01\x03", 4);
    loaded = content::load_panorama(folder.write("repeated.hdr", repeated));
    CHECK(loaded.panorama.radiance == Pixels(4, glm::vec3(1.0f, 0.5f, 0.25f)));

    for (const std::string& whole : {plain, encoded, repeated}) {
        for (std::size_t kept = 2; kept < whole.size(); ++kept) {
            CHECK_THROWS_AS(content::load_panorama(folder.write("cut.hdr", whole.substr(0, kept))), sim::BadInput);
        }
    }
    // A run of no pixels at all leads nowhere.
    encoded[encoded.size() - 8] = '\0';
    CHECK_THROWS_MATCHES(content::load_panorama(folder.write("stuck.hdr", encoded)), sim::BadInput,
                         MessageMatches(ContainsSubstring("a row of the Radiance file is broken")));
    const std::string huge = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 9000 +X 18000\n";
    CHECK_THROWS_MATCHES(content::load_panorama(folder.write("huge.hdr", huge)), sim::BadInput,
                         MessageMatches(ContainsSubstring("size = 18000 x 9000 pixels")));
}

TEST_CASE("a PNG panorama is decoded to linear radiance") {
    const samples::TemporaryFolder folder;
    const auto loaded = content::load_panorama(folder.write("sky.png", samples::png));
    REQUIRE(loaded.panorama.radiance.size() == 4);
    CHECK(loaded.panorama.radiance[1] == glm::vec3(0.0f, 1.0f, 0.0f));
    // IEC 61966-2-1: ((188/255 + 0.055) / 1.055)^2.4, worked out by hand to six digits.
    CHECK(std::abs(loaded.panorama.radiance[3].r - 0.502886f) < 1e-6f);
}

TEST_CASE("panoramas that are no pictures are refused") {
    const samples::TemporaryFolder folder;
    CHECK_THROWS_MATCHES(content::load_panorama(folder.path() / "none.exr"), sim::BadInput,
                         MessageMatches(ContainsSubstring("none.exr: there is no such file")));
    CHECK_THROWS_MATCHES(content::load_panorama(folder.write("empty.exr", "")), sim::BadInput,
                         MessageMatches(ContainsSubstring("the file is empty")));
    CHECK_THROWS_MATCHES(content::load_panorama(folder.write("text.exr", "hello")), sim::BadInput,
                         MessageMatches(ContainsSubstring("neither a PNG nor a JPEG")));
    const std::vector<std::uint8_t> cut(samples::png.begin(), samples::png.end() - 20);
    CHECK_THROWS_MATCHES(content::load_panorama(folder.write("cut.png", cut)), sim::BadInput,
                         MessageMatches(ContainsSubstring("truncated")));
    CHECK_THROWS_MATCHES(content::load_panorama(folder.path()), sim::BadInput,
                         MessageMatches(ContainsSubstring("not a regular file")));
}

TEST_CASE("a panorama turns about the vertical axis") {
    content::Panorama panorama;
    panorama.width = 8;
    panorama.height = 1;
    panorama.radiance.assign(8, glm::vec3(0.0f));
    panorama.radiance[4] = glm::vec3(1.0f); // just right of -z
    content::turn_and_scale(panorama, glm::half_pi<double>(), 3.0f);
    // A quarter turn about +y carries -z to -x, which is a quarter of the way round to the left.
    CHECK(panorama.radiance[2] == glm::vec3(3.0f));
    content::turn_and_scale(panorama, -glm::half_pi<double>(), 1.0f);
    CHECK(panorama.radiance[4] == glm::vec3(3.0f));
}
