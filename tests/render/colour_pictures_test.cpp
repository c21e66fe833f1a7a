#include "content/scenario.h"
#include "render/offline/compare.h"
#include "render/offline/reference.h"
#include "sim/look.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

render::RenderFrame frame_of(const content::Scenario& scenario, const glm::dvec3& look) {
    render::RenderFrame frame;
    frame.eye.position = scenario.start_position;
    // D from 1/20 ahead to 20 behind.
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(std::log(20.0)), scenario.start_heading, look);
    frame.eye.width = 48;
    frame.eye.height = 27;
    frame.metres_per_light_year = scenario.speed_of_light * 31557600.0;
    return frame;
}

} // namespace

// Both pictures are shaded on the same rays, one through each pixel's centre, so that only colours differ: one sums
// 471 wavelengths at every ray, the other asks the real-time methods' tables.
TEST_CASE("pictures by tables look as pictures by whole spectra in every scenario, D from 1/20 to 20") {
    for (const content::Scenario& scenario : content::built_in_scenarios()) {
        const content::SceneDesc scene = content::load_scene(scenario);
        const render::ReferenceRenderer reference(scene);
        std::vector<double> all;
        for (const glm::dvec3& look : {glm::dvec3(scenario.start_heading), glm::dvec3(1.0, 0.0, 0.0)}) {
            const render::RenderFrame frame = frame_of(scenario, look);
            const auto found = render::colour_differences(reference.render(frame, 1, render::SpectralSums::tables),
                                                          reference.render(frame, 1, render::SpectralSums::each_ray));
            all.insert(all.end(), found.begin(), found.end());
        }
        std::sort(all.begin(), all.end());
        double sum = 0.0;
        for (const double difference : all) {
            sum += difference;
        }
        INFO(scenario.name);
        CHECK(sum / static_cast<double>(all.size()) < 0.5); // half of what an eye can tell side by side
        CHECK(all[all.size() * 99 / 100] < 2.0);
    }
}

TEST_CASE("joined sums of a picture are sums at every ray") {
    content::SceneDesc scene;
    scene.materials.emplace_back();
    scene.gradient_sky = {{0.2f, 0.4f, 0.9f}, {0.8f, 0.7f, 0.5f}, {0.1f, 0.1f, 0.1f}};
    const render::ReferenceRenderer reference(scene);
    render::RenderFrame frame;
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(1.0), glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.3, 0.1, -1.0));
    frame.eye.width = 16;
    frame.eye.height = 9;
    const render::Picture joined = reference.render(frame, 1, render::SpectralSums::joined);
    const render::Picture each = reference.render(frame, 1, render::SpectralSums::each_ray);
    for (std::size_t i = 0; i < each.values.size(); ++i) {
        const double expected = static_cast<double>(each.values[i]);
        // Cubics over steps of 1e-3 in ln D.
        CHECK(std::abs(static_cast<double>(joined.values[i]) - expected) < 1e-5 * (1.0 + std::abs(expected)));
    }
}
