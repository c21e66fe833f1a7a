#include "engine/replay_film.h"

#include "engine/commands/film_options.h"
#include "engine/film.h"
#include "recorded_flight.h"
#include "render/picture_file.h"
#include "sim/bad_input.h"
#include "sim/look.h"
#include "tests/engine/command.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

using Catch::Matchers::WithinAbs;

namespace {

/// A second and a half of flight in an empty place under a gradient sky, with its scenario's file.
struct Flown {
    Flown() {
        std::ofstream(folder / "place.toml") << "title = \"A place\"\n";
        const content::Scenario place = content::load_scenario((folder / "place.toml").string());
        engine::Recorder recorder(folder / "a.rapidity", engine::describe_flight(place),
                                  recorded_flight::start(recorded_flight::scenario()));
        recorded_flight::Flight flight(recorder, recorded_flight::start(recorded_flight::scenario()));
        flight.fly(360);
        recorder.close();
        replay = engine::load_replay(folder / "a.rapidity");
    }

    /// Small and quick: the ray method, one sample.
    engine::FilmRequest request(const std::string& frames) const {
        engine::FilmRequest request;
        request.frames = folder / frames;
        request.size = {32, 16};
        request.frames_per_second = 4.0;
        request.method = engine::PictureMethod::ray;
        request.samples_per_side = 1;
        return request;
    }

    recorded_flight::Folder folder;
    engine::Replay replay;
};

void make(const engine::Replay& replay, const engine::FilmRequest& request) {
    engine::make_film(replay.scenario, engine::replay_reel(replay, request), request);
}

/// What a replay's eye is, in a picture of this size.
render::RenderFrame frame_at(const Flown& flown, double position, int width, int height) {
    engine::FilmRequest request = flown.request("");
    request.size = {width, height};
    request.frames_per_second = 240.0; // a frame is a tick
    return engine::replay_reel(flown.replay, request).shot(static_cast<std::size_t>(position)).frame;
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

} // namespace

TEST_CASE("a film's frames are even in the ship's time, or in the world's") {
    const Flown flown;
    engine::ReplayDeck deck(flown.replay.recording);
    engine::FilmRequest request = flown.request("f");
    CHECK(engine::frame_positions(deck, request) == std::vector<double>{0.0, 60.0, 120.0, 180.0, 240.0, 300.0});
    request.speed = 0.5;
    CHECK(engine::frame_positions(deck, request).size() == 12);
    request.clock = engine::FilmClock::world;
    const std::vector<double> positions = engine::frame_positions(deck, request);
    CHECK(positions.size() > 12); // the world's clock runs faster
    for (std::size_t i = 0; i < positions.size(); ++i) {
        deck.seek(positions[i]);
        // The bisection ends at a double's last digits of the position, some 1e-13 of a tick of 1/240.
        CHECK_THAT(deck.state().event.t, WithinAbs(0.125 * static_cast<double>(i), 1e-13));
    }
}

TEST_CASE("an interrupted film goes on to the same bytes, and never into another film's folder") {
    const Flown flown;
    const engine::FilmRequest request = flown.request("frames");
    make(flown.replay, request);
    const auto frame = [&](const char* folder, int i) {
        return flown.folder / folder / ("frame-00000" + std::to_string(i) + ".png");
    };
    const std::string second = bytes_of(frame("frames", 2));
    CHECK_FALSE(second.empty());
    CHECK(std::filesystem::exists(frame("frames", 6)));
    CHECK_FALSE(std::filesystem::exists(frame("frames", 7)));
    const auto first_written = std::filesystem::last_write_time(frame("frames", 1));
    std::filesystem::remove(frame("frames", 2));
    make(flown.replay, request);
    CHECK(bytes_of(frame("frames", 2)) == second);
    CHECK(std::filesystem::last_write_time(frame("frames", 1)) == first_written);

    engine::FilmRequest other = request;
    other.mode = render::Mode::geometry;
    CHECK_THROWS_AS(make(flown.replay, other), sim::BadInput);
    other.frames = flown.folder.path(); // holds a recording
    CHECK_THROWS_AS(make(flown.replay, other), sim::BadInput);
}

TEST_CASE("a film all around agrees with perspective pictures of its parts") {
    const Flown flown;
    content::SceneDesc scene;
    scene.gradient_sky.zenith = {1.0f, 0.2f, 0.1f};
    engine::FrameMaker maker(scene, engine::PictureMethod::ray, 1);
    const render::RenderFrame frame = frame_at(flown, 200.0, 256, 128);
    const render::Picture around = engine::film_picture(maker, frame, {engine::FilmProjection::equirectangular, 0.0});
    REQUIRE(around.values.size() == 3u * 256u * 128u);
    for (const int row : {5, 40, 64, 100, 122}) {
        for (int column = 8; column < 256; column += 16) {
            const glm::dvec3 look = engine::equirectangular_direction(column, row, 256, 128);
            CHECK_THAT(glm::length(look), WithinAbs(1.0, 1e-15));
            render::RenderFrame one = frame;
            one.eye.width = one.eye.height = 1;
            one.eye.horizontal_field_of_view = 0.001;
            one.eye.world_from_head =
                frame.eye.world_from_head *
                sim::Lorentz<sim::Head, sim::Head>{
                    sim::world_from_looking<sim::Head>(sim::Rapidity(0.0), {0.0, 0.0, -1.0}, look).spin};
            const render::Picture pixel = engine::film_picture(maker, one, {});
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const float seen =
                    around
                        .values[3 * (static_cast<std::size_t>(row) * 256 + static_cast<std::size_t>(column)) + channel];
                // The sky's bends, at the horizon, are a pixel wide: interpolation rounds them by some hundredths.
                CHECK_THAT(seen, WithinAbs(pixel.values[channel], 0.05 * pixel.values[channel] + 0.01));
            }
        }
    }
}

TEST_CASE("two eyes see the sky alike and side by side") {
    const Flown flown;
    const content::SceneDesc scene;
    engine::FrameMaker maker(scene, engine::PictureMethod::ray, 1);
    const render::Picture both =
        engine::film_picture(maker, frame_at(flown, 0.0, 64, 16), {engine::FilmProjection::perspective, 0.065});
    REQUIRE(both.width == 64);
    for (std::size_t row = 0; row < 16; ++row) {
        for (std::size_t i = 0; i < 96; ++i) { // the sky is infinitely far
            CHECK(both.values[192 * row + i] == both.values[192 * row + 96 + i]);
        }
    }
}

TEST_CASE("a video has the frames it was made of") {
    if (engine::program_on_path("ffmpeg").empty() || engine::program_on_path("ffprobe").empty()) {
        FAIL("needs ffmpeg, which ./check installs");
    }
    const Flown flown;
    engine::FilmRequest request = flown.request("");
    request.frames.clear();
    request.size = {64, 32};
    std::string first;
    for (const char* name : {"a.mp4", "a.webm", "a.mov"}) {
        request.video = flown.folder / name;
        make(flown.replay, request);
        CHECK_FALSE(std::filesystem::exists(request.video.string() + ".frames"));
        const std::string probe = "ffprobe -v error -count_frames -show_entries "
                                  "stream=width,height,nb_read_frames:format_tags -of csv '" +
                                  request.video.string() + "' > '" + (flown.folder / "probe").string() + "'";
        REQUIRE(std::system(probe.c_str()) == 0);
        const std::string said = bytes_of(flown.folder / "probe");
        INFO(name << ": " << said);
        CHECK(said.find("stream,64,32,6") != std::string::npos);
        CHECK(said.find("recording ") != std::string::npos); // its description
    }
    const std::string once = bytes_of(flown.folder / "a.mp4");
    request.video = flown.folder / "b.mp4";
    make(flown.replay, request);
    CHECK(bytes_of(flown.folder / "b.mp4") == once);

    // A decoded frame is the still it was made of, but for the codec: 4:2:0 colour at crf 16.
    const std::string decode = "ffmpeg -v error -i '" + (flown.folder / "a.mp4").string() + "' -frames:v 1 '" +
                               (flown.folder / "decoded.ppm").string() + "'";
    REQUIRE(std::system(decode.c_str()) == 0);
    request.video.clear();
    request.frames = flown.folder / "stills";
    make(flown.replay, request);
    const std::string still = "ffmpeg -v error -i '" + (flown.folder / "stills/frame-000001.png").string() + "' '" +
                              (flown.folder / "still.ppm").string() + "'";
    REQUIRE(std::system(still.c_str()) == 0);
    const std::string a = bytes_of(flown.folder / "decoded.ppm");
    const std::string b = bytes_of(flown.folder / "still.ppm");
    REQUIRE(a.size() == b.size());
    double squares = 0.0;
    for (std::size_t i = a.size() - 3 * 64 * 32; i < a.size(); ++i) {
        const double difference = static_cast<double>(static_cast<unsigned char>(a[i])) -
                                  static_cast<double>(static_cast<unsigned char>(b[i]));
        squares += difference * difference;
    }
    CHECK(std::sqrt(squares / (3 * 64 * 32)) < 4.0); // of 255
}

TEST_CASE("a film's options are checked before any work") {
    const auto refused = [](auto change) {
        engine::FilmOptions options;
        options.video = "a.mp4";
        change(options);
        CHECK_THROWS_AS(engine::film_request(options, ""), sim::BadInput);
    };
    refused([](engine::FilmOptions& o) { o.video = "a.gif"; });
    refused([](engine::FilmOptions& o) { o.size = "101x100"; });
    refused([](engine::FilmOptions& o) { o.frames_per_second = "0"; });
    refused([](engine::FilmOptions& o) { o.clock = "moon"; });
    refused([](engine::FilmOptions& o) { o.speed = "-1"; });
    refused([](engine::FilmOptions& o) { o.samples = "0"; });
    refused([](engine::FilmOptions& o) {
        o.projection = "equirectangular";
        o.stereo = "0.065";
    });
    CHECK_THROWS_AS(engine::film_request({}, "plain"), sim::BadInput);
    CHECK(engine::film_request({}, "reference").method == engine::PictureMethod::reference);
}

TEST_CASE("a film that flies for itself goes on after an interruption, whenever that is") {
    const recorded_flight::Folder folder;
    std::ofstream(folder / "place.toml") << "title = \"A place\"\n";
    std::ofstream(folder / "script.csv") << "duration,ax,ay,az,wx,wy,wz\n1,0,0,-0.5,0,0.2,0\n";
    const auto film = [&folder] {
        return tests::rapidity({"film", (folder / "place.toml").string(), "--script", (folder / "script.csv").string(),
                                "--frames", (folder / "frames").string(), "--size", "32x16", "--samples", "1", "--fps",
                                "3", "--method", "ray"});
    };
    REQUIRE(film() == 0);
    const std::filesystem::path last = folder / "frames/frame-000003.png";
    const std::string bytes = bytes_of(last);
    REQUIRE_FALSE(bytes.empty());
    std::filesystem::remove(last);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // recordings note the second they begin in
    REQUIRE(film() == 0);
    CHECK(bytes_of(last) == bytes);
}
