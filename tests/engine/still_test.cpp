#include "engine/still.h"

#include "content/file_bytes.h"
#include "engine/fly/picture_keys.h"
#include "engine/hud/legend.h"
#include "render/colour/false_colour_scale.h"
#include "render/png_chunks.h"
#include "tests/engine/command.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

engine::PictureOptions lattice(const std::string& size) {
    engine::PictureOptions options;
    options.scenario = "lattice";
    options.method = "ray"; // needs no OpenGL
    options.beta = "0.7";
    options.size = size;
    options.no_legend = true;
    return options;
}

content::Image still(const engine::PictureOptions& options) {
    const engine::PictureRequest request = engine::picture_request(options);
    return engine::make_still(content::load_scene(request.scenario), request);
}

content::Image cut(const content::Image& image, const engine::PaneArea& area) {
    content::Image part;
    part.width = area.width;
    part.height = area.height;
    for (int y = area.top; y < area.top + area.height; ++y) {
        const auto from = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + area.left);
        part.rgba.insert(part.rgba.end(), from, from + 4 * static_cast<std::ptrdiff_t>(area.width));
    }
    return part;
}

std::filesystem::path temporary_file(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("rapidity_still_" + std::to_string(::getpid()) + name);
}

using tests::rapidity;

} // namespace

TEST_CASE("panes fill the picture without a gap or an overlap") {
    for (std::size_t count = 1; count <= engine::most_panes; ++count) {
        std::vector<int> covered(std::size_t{101} * 37, 0);
        for (const engine::PaneArea& area : engine::pane_areas(count, 101, 37)) {
            for (int y = area.top; y < area.top + area.height; ++y) {
                for (int x = area.left; x < area.left + area.width; ++x) {
                    ++covered[static_cast<std::size_t>(101 * y + x)];
                }
            }
        }
        CHECK(std::all_of(covered.begin(), covered.end(), [](int times) { return times == 1; }));
    }
}

TEST_CASE("each pane of a split picture is the single picture of its size, byte for byte") {
    engine::PictureOptions options = lattice("97x40"); // an odd width: the panes differ in theirs
    options.split = "geometry,rings";
    const content::Image split = still(options);
    const std::vector<engine::PaneArea> areas = engine::pane_areas(2, 97, 40);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        engine::PictureOptions single = lattice(std::to_string(areas[i].width) + "x40");
        // As high as the whole: the view is narrower by the pane's share of the width.
        const double whole = engine::picture_request(lattice("97x40")).frame.eye.horizontal_field_of_view;
        const double half = std::tan(0.5 * whole) * areas[i].width / 97.0;
        single.field_of_view = std::to_string(2.0 * std::atan(half) * 57.29577951308232);
        (i == 0 ? single.mode : single.view) = i == 0 ? "geometry" : "rings";
        const content::Image alone = still(single);
        const content::Image part = cut(split, areas[i]);
        REQUIRE(part.rgba.size() == alone.rgba.size());
        int different = 0;
        for (std::size_t at = 0; at < part.rgba.size(); ++at) {
            different += std::abs(part.rgba[at] - alone.rgba[at]) > 1 ? 1 : 0;
        }
        CHECK(different <= 4); // six decimals of the angle may move an edge across a pixel's centre
    }
}

TEST_CASE("four panes show the whole picture's view, each at half its size") {
    engine::PictureOptions options = lattice("64x36");
    options.split = "geometry,doppler,searchlight,full";
    const content::Image split = still(options);
    const std::vector<engine::PaneArea> areas = engine::pane_areas(4, 64, 36);
    constexpr const char* modes[] = {"geometry", "doppler", "searchlight", "full"};
    for (std::size_t i = 0; i < 4; ++i) {
        engine::PictureOptions single = lattice("32x18");
        single.mode = modes[i];
        CHECK(cut(split, areas[i]).rgba == still(single).rgba);
    }
}

TEST_CASE("a PNG made by render says how, and an EXR which primaries its numbers are of") {
    const std::filesystem::path png = temporary_file(".png");
    REQUIRE(rapidity({"render", "lattice", "-o", png.string(), "--size", "48x27", "--method", "ray", "--beta", "0.5",
                      "--view", "doppler", "--iso-lines", "--primaries", "rec2020", "--bloom", "0.2"}) == 0);
    const std::vector<std::uint8_t> bytes = content::read_file_bytes(png);
    std::filesystem::remove(png);
    std::string said;
    for (const render::PngChunk& chunk : render::png_chunks(std::string(bytes.begin(), bytes.end()))) {
        said += chunk.type + " " + std::string(chunk.data.c_str()) + "=" +
                (chunk.type == "iTXt" ? chunk.data.substr(chunk.data.find('\0') + 5) : "") + "\n";
    }
    for (const char* const wanted :
         {"iTXt rapidity:scenario=lattice", "iTXt rapidity:mode=full", "iTXt rapidity:method=ray",
          "iTXt rapidity:view=doppler", "iTXt rapidity:primaries=rec2020", "cICP"}) {
        CAPTURE(said);
        CHECK(said.find(wanted) != std::string::npos);
    }
    CHECK(said.find("iTXt rapidity:beta=0.") != std::string::npos);

    const std::filesystem::path wide = temporary_file("_wide.exr");
    const std::filesystem::path usual = temporary_file("_usual.exr");
    REQUIRE(rapidity({"render", "lattice", "-o", wide.string(), "--size", "16x9", "--method", "ray", "--primaries",
                      "rec2020"}) == 0);
    REQUIRE(rapidity({"render", "lattice", "-o", usual.string(), "--size", "16x9", "--method", "ray"}) == 0);
    const render::Picture wide_light = render::read_exr(wide);
    const render::Picture usual_light = render::read_exr(usual);
    CHECK_THAT(render::read_exr_chromaticities(wide)->green.y, WithinAbs(0.797, 1e-6)); // floats in the file
    CHECK_THAT(render::read_exr_chromaticities(usual)->green.y, WithinAbs(0.6, 1e-6));
    for (std::size_t i = 0; i < usual_light.values.size(); i += 3) {
        // The same colour: its luminance by each space's own weights (BT.709, BT.2020).
        const auto y = [i](const render::Picture& p, double r, double g, double b) {
            return r * static_cast<double>(p.values[i]) + g * static_cast<double>(p.values[i + 1]) +
                   b * static_cast<double>(p.values[i + 2]);
        };
        CHECK_THAT(y(wide_light, 0.2627, 0.6780, 0.0593), WithinRel(y(usual_light, 0.2126, 0.7152, 0.0722), 1e-3));
    }
    std::filesystem::remove(wide);
    std::filesystem::remove(usual);
}

TEST_CASE("a legend marks D and luminance where the picture's colours have them") {
    render::Display display;
    CHECK_FALSE(engine::legend_of(display, sim::Rapidity(1.0), 0.0));
    display.view = render::View::doppler;
    const auto shift = engine::legend_of(display, sim::Rapidity(1.4722), 0.0);
    REQUIRE(shift);
    const render::ShiftScale scale = render::shift_scale(sim::Rapidity(1.4722));
    bool one = false;
    for (const engine::Legend::Mark& mark : shift->marks) {
        if (!mark.label.empty()) {
            const double level = scale.range * (2.0 * mark.place - 1.0);
            CHECK_THAT(std::stod(mark.label), WithinRel(std::exp2(level), 6e-3)); // three figures
            one = one || (mark.place == 0.5 && std::stod(mark.label) == 1.0);
        }
    }
    CHECK(one);
    display.view = render::View::luminance;
    const auto brightness = engine::legend_of(display, sim::Rapidity(0.0), 3.0);
    REQUIRE(brightness);
    // Ten stops below middle grey, of a picture exposed three stops up.
    CHECK_THAT(std::stod(brightness->marks.front().label), WithinRel(0.18 / 1024.0 / 8.0, 0.05)); // two figures
}

TEST_CASE("the probe prints a spectrum, writes it as a table, and refuses a point outside of the picture") {
    const std::filesystem::path csv = temporary_file(".csv");
    CHECK(rapidity({"probe", "lattice", "--beta", "0.5", "--pixel", "640,360"}) == 0);
    CHECK(rapidity({"probe", "lattice", "--pixel", "10,20", "--csv", csv.string()}) == 0);
    std::ifstream in(csv);
    std::string header;
    std::getline(in, header);
    CHECK(header == "wavelength_nm,emitted_relative,received_relative,visible");
    std::filesystem::remove(csv);
    CHECK(rapidity({"probe", "lattice", "--pixel", "1281,20"}) == 2);
    CHECK(rapidity({"probe", "lattice", "--pixel", "here"}) == 2);
    CHECK(rapidity({"probe", "lattice"}) == 2);
}

TEST_CASE("the picture's keys go round its views and panes") {
    engine::PictureSettings picture;
    for (const std::size_t panes : {2u, 4u, 1u}) {
        engine::change_picture(input::Action::split, picture);
        CHECK(engine::panes_of(picture).size() == panes);
    }
    engine::change_picture(input::Action::split, picture);
    engine::change_picture(input::Action::split, picture);
    std::vector<bool> modes(4, false);
    for (const engine::Pane& pane : engine::panes_of(picture)) {
        modes[static_cast<std::size_t>(pane.mode)] = true;
    }
    CHECK(std::count(modes.begin(), modes.end(), true) == 4); // every mode once
    for (int i = 0; i < 4; ++i) {
        CHECK(static_cast<int>(picture.display.view) == i);
        engine::change_picture(input::Action::view_next, picture);
    }
    CHECK(picture.display.view == render::View::natural);
    engine::change_picture(input::Action::bloom, picture);
    CHECK(picture.display.bloom > 0.0F);
    engine::change_picture(input::Action::bloom, picture);
    CHECK(picture.display.bloom == 0.0F);
}
