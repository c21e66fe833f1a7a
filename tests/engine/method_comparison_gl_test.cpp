#include "content/scenario.h"
#include "engine/method_comparison.h"
#include "engine/picture_request.h"
#include "render/gl/egl_context.h"
#include "render/offline/compare.h"
#include "render/picture_file.h"
#include "sim/look.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <filesystem>
#include <utility>

namespace {

render::RenderFrame small_frame(const content::Scenario& scenario, double beta) {
    render::RenderFrame frame;
    frame.eye.position = scenario.start_position;
    frame.eye.world_from_head = sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)),
                                                                   scenario.start_heading, scenario.start_heading);
    frame.eye.width = 320;
    frame.eye.height = 180;
    frame.mode = render::Mode::geometry;
    frame.exposure.automatic = true;
    frame.exposure.linear_curve = false;
    return frame;
}

/// Leaves both pictures and their difference to be looked at.
std::filesystem::path keep(const engine::ComparedPictures& compared, const engine::TrueView& truth) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "rapidity_failed_pictures";
    std::filesystem::create_directories(folder);
    render::write_png(folder / "shown.png", compared.shown);
    render::write_png(folder / "truth.png", truth.light);
    render::write_png(folder / "difference.png", render::difference_picture(compared.shown, truth.light));
    return folder;
}

} // namespace

TEST_CASE("the lattice ahead at 0.9c is as near to the truth as an ordinary frame at rest, by either method") {
    const content::Scenario scenario = content::load_scenario("lattice");
    const content::SceneDesc scene = content::load_scene(scenario);
    const render::ReferenceRenderer reference(scene);
    const render::EglContext context;
    render::Renderer plain(scene, {render::Method::plain});
    render::Renderer texture(scene, {render::Method::texture});
    render::Renderer ray(scene, {render::Method::ray});
    const engine::ComparedPictures ordinary =
        engine::compare_with_truth(plain, engine::true_view(reference, small_frame(scenario, 0.0), 4));
    render::RenderFrame frame = small_frame(scenario, 0.9);
    frame.sharpness = engine::still_sharpness;
    const engine::TrueView truth = engine::true_view(reference, frame, 4);
    for (const auto& [renderer, name] : {std::pair(&texture, "texture"), std::pair(&ray, "ray")}) {
        const engine::ComparedPictures moving = engine::compare_with_truth(*renderer, truth);
        // The project's aim, at any size: at most 1 dB less than one sample a pixel reaches.
        const bool sharp = moving.signal_to_noise > ordinary.signal_to_noise - 1.0;
        // The aim is 0.5 px in 1280 x 720; a sixteenth of the pixels have edges four times as dense, and distances come
        // in steps of the truth's 0.25 px grid: 0.40, 0.53, 0.64. Rays hit exactly what the truth's centre hits.
        const bool placed = moving.edge_displacement < (renderer == &ray ? 1e-9 : 0.6);
        INFO(name << ": PSNR " << moving.signal_to_noise << " dB, ordinary " << ordinary.signal_to_noise
                  << " dB, edges " << moving.edge_displacement << " px"
                  << (sharp && placed ? "" : "; see " + keep(moving, truth).string()));
        CHECK(sharp);
        CHECK(placed);
    }
}

TEST_CASE("a renderer's numbers are those of the reference: D, direction and distance") {
    const content::Scenario scenario = content::load_scenario("street");
    const content::SceneDesc scene = content::load_scene(scenario);
    const render::ReferenceRenderer reference(scene);
    const render::EglContext context;
    render::Renderer texture(scene, {render::Method::texture});
    render::RenderFrame frame = small_frame(scenario, 0.9);
    frame.sharpness = engine::still_sharpness;
    for (const render::Layer layer : {render::Layer::doppler, render::Layer::direction}) {
        frame.layer = layer;
        const render::Picture shown = texture.picture(frame);
        const render::Picture truth = reference.render(frame, 1);
        REQUIRE(shown.values.size() == truth.values.size());
        double largest = 0.0;
        for (std::size_t i = 0; i < truth.values.size(); ++i) {
            largest = std::max(largest, static_cast<double>(std::abs(shown.values[i] - truth.values[i])));
        }
        CHECK(largest < 1e-5); // single precision, D up to 4.4
    }
    frame.layer = render::Layer::distance;
    const render::Picture shown = texture.picture(frame);
    const render::Picture truth = reference.render(frame, 1);
    std::size_t near = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        near +=
            shown.values[i] == truth.values[i] || std::abs(shown.values[i] / truth.values[i] - 1.0f) < 0.05f ? 1 : 0;
    }
    // The nearest texel lies up to half a pixel away: surfaces seen at a slant differ by per cents, edges by anything.
    CHECK(static_cast<double>(near) > 0.95 * static_cast<double>(truth.values.size()));
}
