#include "content/file_bytes.h"
#include "content/image_file.h"
#include "engine/picture_request.h"
#include "sim/bad_input.h"
#include "tests/engine/command.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;

namespace {

std::filesystem::path temporary_file(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("rapidity_picture_" + std::to_string(::getpid()) + name);
}

engine::PictureOptions lattice_options() {
    engine::PictureOptions options;
    options.scenario = "lattice";
    options.output = temporary_file(".png").string();
    return options;
}

using tests::rapidity;

} // namespace

TEST_CASE("each option that cannot be is refused by its name") {
    using Member = std::optional<std::string> engine::PictureOptions::*;
    struct Case {
        Member member;
        std::string name;
        std::string text;
    };
    using Options = engine::PictureOptions;
    const std::vector<Case> cases{
        {&Options::beta, "--beta", "1"},
        {&Options::beta, "--beta", "-0.1"},
        {&Options::beta, "--beta", "nan"},
        {&Options::beta, "--beta", "fast"},
        {&Options::rapidity, "--rapidity", "-1"},
        {&Options::rapidity, "--rapidity", "31"},
        {&Options::rapidity, "--rapidity", "inf"},
        {&Options::heading, "--heading", "0,0,0"},
        {&Options::heading, "--heading", "1,2"},
        {&Options::look, "--look", "1,2,3,4"},
        {&Options::look, "--look", "1,nan,0"},
        {&Options::at, "--at", "1,2,3"},
        {&Options::at, "--at", "0,0,0,inf"},
        {&Options::field_of_view, "--fov", "0"},
        {&Options::field_of_view, "--fov", "180"},
        {&Options::size, "--size", "0x720"},
        {&Options::size, "--size", "1280x16385"},
        {&Options::size, "--size", "1280"},
        {&Options::size, "--size", "12.5x10"},
        {&Options::mode, "--mode", "colour"},
        {&Options::layer, "--layer", "depth"},
        {&Options::layer, "--layer", "doppler"}, // a .png cannot hold it
        {&Options::method, "--method", "magic"},
        {&Options::samples, "--samples", "0"},
        {&Options::exposure, "--exposure", "big"},
        {&Options::curve, "--curve", "s"},
        {&Options::view, "--view", "heat"},
        {&Options::bloom, "--bloom", "1"},
        {&Options::bloom, "--bloom", "-0.1"},
        {&Options::split, "--split", "full"},
        {&Options::split, "--split", "full,full,full,full,full"},
        {&Options::primaries, "--primaries", "p3"},
    };
    for (const Case& refused : cases) {
        engine::PictureOptions options = lattice_options();
        options.method = "reference";
        options.*refused.member = refused.text;
        CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput,
                             MessageMatches(ContainsSubstring(refused.name) && ContainsSubstring(refused.text)));
    }
}

TEST_CASE("a pane of unknown name is refused by that name") {
    engine::PictureOptions options = lattice_options();
    options.split = "full,heat";
    CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput,
                         MessageMatches(ContainsSubstring("--split") && ContainsSubstring("heat")));
}

TEST_CASE("a pane may be any mode or view: D's false colours go by D, for doppler is a mode") {
    engine::PictureOptions options = lattice_options();
    options.mode = "searchlight";
    options.split = "doppler,D,rings,luminance";
    const std::vector<engine::Pane> panes = engine::picture_request(options).panes;
    REQUIRE(panes.size() == 4);
    CHECK(panes[0].mode == render::Mode::doppler);
    CHECK(panes[0].view == render::View::natural);
    CHECK(panes[1].mode == render::Mode::searchlight);
    CHECK(panes[1].view == render::View::doppler);
    CHECK(panes[2].view == render::View::rings);
    CHECK(panes[3].view == render::View::luminance);
}

TEST_CASE("the microwave background is the scenario's unless an option says otherwise") {
    engine::PictureOptions options = lattice_options();
    CHECK_FALSE(engine::picture_request(options).scenario.microwave_background);
    options.microwave_background = true;
    CHECK(engine::picture_request(options).scenario.microwave_background);
    options.scenario = "stars";
    options.microwave_background.reset();
    CHECK(engine::picture_request(options).scenario.microwave_background);
    options.microwave_background = false;
    CHECK_FALSE(engine::picture_request(options).scenario.microwave_background);
}

TEST_CASE("two speeds at once, or an exposure for radiance, are refused") {
    engine::PictureOptions options = lattice_options();
    options.beta = "0.5";
    options.rapidity = "0.5";
    CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput,
                         MessageMatches(ContainsSubstring("--beta or --rapidity")));
    options = lattice_options();
    options.output = temporary_file(".exr").string();
    options.exposure = "2";
    CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput,
                         MessageMatches(ContainsSubstring("--exposure")));
}

TEST_CASE("what only a display wants is refused for radiance, by its name") {
    using Change = void (*)(engine::PictureOptions&);
    for (const auto& [name, change] : {std::pair<std::string, Change>{"--view", [](auto& o) { o.view = "rings"; }},
                                       {"--split", [](auto& o) { o.split = "geometry,full"; }},
                                       {"--bloom", [](auto& o) { o.bloom = "0.1"; }},
                                       {"--iso-lines", [](auto& o) { o.iso_lines = true; }},
                                       {"--no-dither", [](auto& o) { o.no_dither = true; }},
                                       {"--no-legend", [](auto& o) { o.no_legend = true; }}}) {
        engine::PictureOptions options = lattice_options();
        options.output = temporary_file(".exr").string();
        change(options);
        CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput, MessageMatches(ContainsSubstring(name)));
    }
}

TEST_CASE("a plain picture of a moving eye is refused") {
    engine::PictureOptions options = lattice_options();
    options.method = "plain";
    options.beta = "0.5";
    CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput,
                         MessageMatches(ContainsSubstring("--method = plain")));
    options.beta = "0";
    CHECK(engine::picture_request(options).method == engine::PictureMethod::plain);
}

TEST_CASE("a scenario that is not there is named with its nearest neighbour") {
    engine::PictureOptions options = lattice_options();
    options.scenario = "latice";
    CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput,
                         MessageMatches(ContainsSubstring("latice") && ContainsSubstring("lattice")));
}

TEST_CASE("options become the eye's event, motion and screen") {
    engine::PictureOptions options = lattice_options();
    options.beta = "0.6";
    options.heading = "0,3,0";
    options.look = "2,0,0";
    options.at = "7,1,2,3";
    options.field_of_view = "60";
    options.size = "64x32";
    const engine::PictureRequest request = engine::picture_request(options);
    const render::EyeView& eye = request.frame.eye;
    CHECK(request.time == 7.0);
    CHECK(eye.position == glm::dvec3(1.0, 2.0, 3.0));
    CHECK(eye.width == 64);
    CHECK(eye.height == 32);
    const sim::FourVector<sim::World> velocity = sim::four_velocity(eye.world_from_head);
    CHECK_THAT(velocity.t, WithinAbs(1.25, 1e-15)); // gamma(0.6), two roundings
    CHECK_THAT(velocity.space.y, WithinAbs(0.75, 1e-15));
    // Looking across the motion: what is ahead of the eye comes from cos(angle) = beta in the world.
    const sim::SeenLight seen = sim::see(eye.world_from_head, {{0.0, 0.0, -1.0}});
    CHECK_THAT(seen.world_direction.y, WithinAbs(-0.6, 1e-15));
    CHECK_THAT(seen.world_direction.x, WithinAbs(0.8, 1e-15));
}

TEST_CASE("render writes a picture, and bad usage leaves it as it was") {
    const std::filesystem::path file = temporary_file("_render.png");
    REQUIRE(rapidity({"render", "lattice", "-o", file.string(), "--size", "32x18", "--method", "reference", "--samples",
                      "1", "--look", "-1,0,0"}) == 0);
    const std::vector<std::uint8_t> written = content::read_file_bytes(file);
    const content::Image image = content::decode_image(written, file.string(), "");
    CHECK(image.width == 32);
    CHECK(image.height == 18);
    CHECK(rapidity({"render", "lattice", "-o", file.string(), "--beta", "2"}) == 2);
    CHECK(rapidity({"render", "lattice"}) == 2);
    CHECK(rapidity({"render", "no-such-scenario", "-o", file.string()}) == 2);
    CHECK(content::read_file_bytes(file) == written);
    std::filesystem::remove(file);
}

TEST_CASE("an OpenEXR picture says how it was made") {
    const std::filesystem::path file = temporary_file("_render.exr");
    REQUIRE(rapidity({"render", "lattice", "-o", file.string(), "--size", "16x9", "--method", "reference", "--layer",
                      "doppler", "--rapidity", "1", "--heading", "0,0,-1", "--look", "0,0,-1", "--fov", "1"}) == 0);
    const render::Picture picture = render::read_exr(file);
    const render::PictureMetadata metadata = render::read_exr_metadata(file);
    std::filesystem::remove(file);
    REQUIRE(picture.channels == 1);
    CHECK_THAT(picture.values[16 * 4 + 8], WithinAbs(std::exp(-1.0), 1e-4)); // D ahead; the picture is 1 degree wide
    CHECK(std::get<std::string>(metadata.at("scenario")) == "lattice");
    CHECK(std::get<std::string>(metadata.at("layer")) == "doppler");
    CHECK(std::get<double>(metadata.at("rapidity")) == 1.0);
    CHECK(std::get<glm::dvec3>(metadata.at("heading")) == glm::dvec3(0.0, 0.0, -1.0));
}
