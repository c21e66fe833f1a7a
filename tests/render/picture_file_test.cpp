#include "content/scene_desc.h"
#include "render/picture_file.h"
#include "sim/bad_input.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

/// A folder of its own, gone afterwards.
class TemporaryFolder {
  public:
    TemporaryFolder() { std::filesystem::create_directories(path_); }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("rapidity_picture_file_test_" + std::to_string(::getpid()));
};

/// No file may grow beyond `bytes` while this lives: what a full disk does to a writer.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int);
};

render::Picture ramp(int channels) {
    render::Picture picture;
    picture.width = 3;
    picture.height = 2;
    picture.channels = channels;
    for (int i = 0; i < 6 * channels; ++i) {
        picture.values.push_back(1e-7f + 1e7f * static_cast<float>(i));
    }
    picture.values[1] = std::numeric_limits<float>::infinity();
    return picture;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("an EXR keeps every float and what was said about the picture") {
    const TemporaryFolder folder;
    for (const int channels : {1, 3}) {
        const render::Picture before = ramp(channels);
        render::write_exr(folder / "a.exr", before,
                          {{"scenario", "street"}, {"beta", 0.9}, {"heading", glm::dvec3(0.0, 0.6, -0.8)}});
        const render::Picture after = render::read_exr(folder / "a.exr");
        CHECK(after.width == 3);
        CHECK(after.height == 2);
        CHECK(after.channels == channels);
        CHECK(after.values == before.values);
        const render::PictureMetadata metadata = render::read_exr_metadata(folder / "a.exr");
        CHECK(std::get<std::string>(metadata.at("scenario")) == "street");
        CHECK(std::get<double>(metadata.at("beta")) == 0.9);
        CHECK(std::get<glm::dvec3>(metadata.at("heading")) == glm::dvec3(0.0, 0.6, -0.8));
    }
}

TEST_CASE("a picture that cannot be written is refused before it is made") {
    const TemporaryFolder folder;
    CHECK_THROWS_MATCHES(render::picture_format(folder / "a.jpg"), sim::BadInput,
                         MessageMatches(ContainsSubstring("a.jpg") && ContainsSubstring(".png or .exr")));
    CHECK_THROWS_MATCHES(render::picture_format(folder / "missing/a.png"), sim::BadInput,
                         MessageMatches(ContainsSubstring("missing") && ContainsSubstring("does not exist")));
    std::filesystem::create_directory(folder / "b.png");
    CHECK_THROWS_AS(render::picture_format(folder / "b.png"), sim::BadInput);
    CHECK(render::picture_format(folder / "A.PNG") == render::PictureFormat::png);
    CHECK(render::picture_format("a.exr") == render::PictureFormat::exr);
}

TEST_CASE("a disk that fills up leaves the picture that was there and no remains") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.exr") << "before";
    {
        const FileSizeLimit limit(100);
        CHECK_THROWS_MATCHES(render::write_exr(folder / "a.exr", ramp(3), {}), sim::BadInput,
                             MessageMatches(ContainsSubstring("a.exr") && ContainsSubstring("cannot be written")));
    }
    CHECK(text_of(folder / "a.exr") == "before");
    CHECK_FALSE(std::filesystem::exists(folder / "a.exr.part"));
}

TEST_CASE("what is no OpenEXR picture is named") {
    const TemporaryFolder folder;
    CHECK_THROWS_MATCHES(render::read_exr(folder / "none.exr"), sim::BadInput,
                         MessageMatches(ContainsSubstring("none.exr")));
    std::ofstream(folder / "text.exr") << "hello";
    CHECK_THROWS_MATCHES(render::read_exr(folder / "text.exr"), sim::BadInput,
                         MessageMatches(ContainsSubstring("text.exr")));
}
