#include "render/offline/compare.h"
#include "render/offline/reference.h"
#include "render/raycast/ray_caster.h"
#include "render/shown_picture.h"
#include "tests/render/outline_check.h"
#include "tests/render/scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace scene_kit;

namespace {

constexpr glm::dvec3 ahead{0.0, 0.0, -1.0};
constexpr double single_precision = 2e-6; // a dozen roundings

render::Picture picture(const content::SceneDesc& scene, const render::RenderFrame& frame, int samples_per_side = 1) {
    const render::SceneColour colour(scene);
    return render::RayCaster(scene, colour).picture(frame, samples_per_side);
}

/// Black and white stripes along u, `period` texels from one to the next.
content::Image stripes(int width, int period) {
    content::Image image;
    image.width = width;
    image.height = 8;
    for (int i = 0; i < 8 * width; ++i) {
        const std::uint8_t value = i % period < period / 2 ? 0 : 255;
        image.rgba.insert(image.rgba.end(), {value, value, value, 255});
    }
    return image;
}

/// A wall 10 m ahead, 20 m wide, with stripes of 4 of its 1024 texels.
content::SceneDesc striped_wall() {
    content::SceneDesc scene = empty_scene();
    scene.images.push_back(stripes(1024, 4));
    content::Material material = unlit(glm::vec3(1.0f));
    material.base_colour_image = 0;
    add(scene, rectangle({0, 0, -10}, {10, 0, 0}, {0, 10, 0}), material);
    return scene;
}

/// Largest difference between neighbours in the middle row.
double contrast(const render::Picture& light) {
    double largest = 0.0;
    for (int x = light.width / 4; x < 3 * light.width / 4; ++x) {
        largest = std::max(
            largest, std::abs(colour_at(light, x + 1, light.height / 2).g - colour_at(light, x, light.height / 2).g));
    }
    return largest;
}

/// A room with something of everything: texture, cut-outs, smooth normals, colours, sun, lamps, emission.
content::SceneDesc furnished_scene() {
    content::SceneDesc scene;
    scene.images.push_back(stripes(64, 8));
    scene.images.back().name = "stripes";
    content::Image holes = stripes(16, 8);
    for (std::size_t i = 0; i < holes.rgba.size(); i += 4) {
        holes.rgba[i + 3] = holes.rgba[i];
    }
    scene.images.push_back(holes);
    content::Material ground = matte({0.8f, 0.7f, 0.6f});
    ground.base_colour_image = 0;
    add(scene, rectangle({0, -2, 0}, {20, 0, 0}, {0, 0, -20}), ground);
    content::Mesh ball = sphere({-2, 0, -6}, 1.5f, 64);
    for (content::Vertex& vertex : ball.vertices) {
        vertex.colour = glm::vec4(0.5f + 0.5f * vertex.normal, 1.0f);
    }
    add(scene, ball, matte(glm::vec3(0.9f)));
    content::Material fence = matte({0.2f, 0.6f, 0.3f});
    fence.base_colour_image = 1;
    fence.alpha_mode = content::AlphaMode::mask;
    fence.double_sided = true;
    add(scene, rectangle({2.5f, 0, -5}, {1.5f, 0, 0.5f}, {0, 2, 0}), fence);
    content::Material glow = matte(glm::vec3(0.1f));
    glow.emission = {2.0f, 1.0f, 0.5f};
    add(scene, sphere({4, 2, -12}, 0.7f, 32), glow);
    scene.sun = content::Sun{glm::normalize(glm::vec3(0.4f, 0.8f, 0.3f)), glm::vec3(2.5f, 2.4f, 2.0f)};
    scene.ambient = glm::vec3(0.1f, 0.12f, 0.15f);
    content::Lamp lamp;
    lamp.position = {-4, 1, -8};
    lamp.intensity = {6.0f, 4.0f, 2.0f};
    lamp.range = 9.0f;
    scene.lamps.push_back(lamp);
    return scene;
}

} // namespace

TEST_CASE("the ray method sees a sphere's outline as the circle of sphere_outline.csv") {
    check_sphere_outlines(
        [](const content::SceneDesc& scene, const render::RenderFrame& view) { return picture(scene, view); });
}

TEST_CASE("the ray method's layers are sim's in double precision") {
    content::SceneDesc scene = empty_scene();
    add(scene, rectangle({0, 0, -10}, {7, 0, 0}, {0, 5, 0}), unlit(glm::vec3(1.0f)));
    for (const double rapidity : {0.0, 0.5493, 1.4722, 2.6467, 4.0}) {
        for (const glm::dvec3& heading : {ahead, -ahead, glm::normalize(glm::dvec3(1.0, 0.3, -0.2))}) {
            render::RenderFrame view = frame(rapidity, heading, ahead, 67, 38); // no multiple of a packet's side
            CAPTURE(rapidity, heading.x, heading.z);
            const auto layer = [&](render::Layer which) {
                view.layer = which;
                return picture(scene, view);
            };
            const render::Picture doppler = layer(render::Layer::doppler);
            const render::Picture direction = layer(render::Layer::direction);
            const render::Picture distance = layer(render::Layer::distance);
            const render::Picture object = layer(render::Layer::object);
            double worst_ratio = 0.0;
            double worst_direction = 0.0;
            double worst_distance = 0.0;
            int wrong = 0;
            for (int y = 0; y < 38; ++y) {
                for (int x = 0; x < 67; ++x) {
                    const sim::SeenLight seen = sim::see(view.eye.world_from_head,
                                                         render::head_direction_from_pixel(view.eye, x + 0.5, y + 0.5));
                    const glm::dvec3& n = seen.world_direction;
                    worst_ratio =
                        std::max(worst_ratio, std::abs(value_at(doppler, x, y) / seen.wavelength_ratio - 1.0));
                    // The eye ray's rounding is 1/D as large in the world.
                    worst_direction = std::max(worst_direction, glm::distance(colour_at(direction, x, y), n) /
                                                                    (1.0 + 0.5 / seen.wavelength_ratio));
                    const bool hit = n.z < 0.0 && std::abs(n.x / n.z) < 0.7 && std::abs(n.y / n.z) < 0.5;
                    const bool edge = n.z < 0.0 && (std::abs(std::abs(n.x / n.z) - 0.7) < 1e-5 ||
                                                    std::abs(std::abs(n.y / n.z) - 0.5) < 1e-5);
                    wrong += !edge && (value_at(object, x, y) == 0.0) != hit ? 1 : 0;
                    wrong += std::isfinite(value_at(distance, x, y)) != (value_at(object, x, y) == 0.0) ? 1 : 0;
                    if (hit && !edge) {
                        worst_distance =
                            std::max(worst_distance, std::abs(value_at(distance, x, y) * -n.z / 10.0 - 1.0));
                    }
                }
            }
            CHECK(worst_ratio < single_precision);
            CHECK(worst_direction < single_precision);
            CHECK(worst_distance < 3.0 * single_precision); // and Embree's own dozen
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("a mip level is picked by what a pixel covers: distance, screen and D") {
    const content::SceneDesc scene = striped_wall();
    // A texel of the wall is 20 m / 1024 wide, two of a stripe of four. 90 degrees over 1024 pixels show 20 m of it:
    // a pixel a texel. Then level 0 shows black and white; levels 2 and up are grey.
    render::RenderFrame sharp = frame(0.0, ahead, ahead, 1024, 8);
    CHECK(contrast(picture(scene, sharp)) > 0.9);
    render::RenderFrame coarse = frame(0.0, ahead, ahead, 128, 8); // eight texels a pixel, level 3 less half a level
    CHECK(contrast(picture(scene, coarse)) < 0.01);
    // Flying away from it the wall is magnified D times: at rapidity 2 D is 7.4, and a pixel is about a texel again.
    render::RenderFrame behind = frame(2.0, -ahead, ahead, 128, 8);
    CHECK(contrast(picture(scene, behind)) > 0.5);
    // Flying towards it, 7.4 times smaller: grey even at the first screen's 512 pixels a radian. Half of the screen's
    // 4 degrees to either side show 15 of the wall's 45.
    render::RenderFrame towards = frame(2.0, ahead, ahead, 77, 8);
    towards.eye.horizontal_field_of_view = 0.15;
    CHECK(contrast(picture(scene, towards)) < 0.01);
}

TEST_CASE("a ray picture is the reference's to single precision, textures and edges apart") {
    content::SceneDesc scene = furnished_scene();
    const render::ReferenceRenderer reference(scene);
    for (const double rapidity : {0.0, 1.4722}) {
        for (const render::Mode mode : {render::Mode::geometry, render::Mode::full}) {
            render::RenderFrame view = frame(rapidity, ahead, ahead, 160, 90);
            view.mode = mode;
            const render::Picture cast = picture(scene, view);
            const render::Picture truth = reference.render(view, 1);
            int different = 0;
            for (int y = 0; y < 90; ++y) {
                for (int x = 0; x < 160; ++x) {
                    const glm::dvec3 expected = colour_at(truth, x, y);
                    const double error = glm::distance(colour_at(cast, x, y), expected);
                    different += error > 2e-3 * (glm::length(expected) + 0.01) ? 1 : 0;
                }
            }
            CAPTURE(rapidity, mode);
            // Where the floor's stripes are filtered they differ, and on edges that single precision moves: the floor
            // is less than half of the picture, its stripes' edges a part of that.
            CHECK(different < 160 * 90 / 4);
            render::Exposure exposure;
            exposure.automatic = true;
            exposure.stops = static_cast<float>(render::exposure_stops(truth, exposure));
            exposure.automatic = false;
            // One sample against the same one sample: what filtering changes, nothing else.
            CHECK(render::peak_signal_to_noise(render::shown_picture(cast, exposure),
                                               render::shown_picture(truth, exposure)) > 25.0);
        }
    }
    for (content::Material& material : scene.materials) {
        if (material.alpha_mode == content::AlphaMode::opaque) {
            material.base_colour_image.reset();
        }
    }
    const render::RenderFrame view = frame(1.0, ahead, ahead, 160, 90);
    const render::Picture cast = picture(scene, view);
    const render::Picture truth = render::ReferenceRenderer(scene).render(view, 1);
    int different = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 160; ++x) {
            const glm::dvec3 expected = colour_at(truth, x, y);
            different += glm::distance(colour_at(cast, x, y), expected) > 1e-4 * (glm::length(expected) + 0.01) ? 1 : 0;
        }
    }
    CHECK(different < 160 * 90 / 500); // a few pixels on edges and on the fence's filtered colour
}

TEST_CASE("samples give an edge the share of the pixel that it covers, above and below, left and right") {
    content::SceneDesc scene = empty_scene();
    // The edges lie at tangents 0.0625: a quarter into the pixels right of and above the middle of 8 x 8.
    add(scene, rectangle({50.0625f, 0, -1}, {50, 0, 0}, {0, 50, 0}), unlit(glm::vec3(1.0f)));
    const render::Picture right = picture(scene, frame(0.0, ahead, ahead, 8, 8), 8);
    CHECK_THAT(colour_at(right, 4, 4).r, WithinAbs(0.75, single_precision));
    CHECK_THAT(colour_at(right, 3, 4).r, WithinAbs(0.0, single_precision));
    scene = empty_scene();
    add(scene, rectangle({0, 50.0625f, -1}, {50, 0, 0}, {0, 50, 0}), unlit(glm::vec3(1.0f)));
    const render::Picture above = picture(scene, frame(0.0, ahead, ahead, 8, 8), 8);
    CHECK_THAT(colour_at(above, 4, 3).r, WithinAbs(0.75, single_precision));
    CHECK_THAT(colour_at(above, 4, 4).r, WithinAbs(0.0, single_precision));
    // Moving, the mean is the reference's over the same grid, but for what single precision moves.
    scene = furnished_scene();
    const render::RenderFrame view = frame(0.9, ahead, ahead, 96, 54);
    const render::Picture cast = picture(scene, view, 4);
    const render::Picture truth = render::ReferenceRenderer(scene).render(view, 4);
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        sum += std::abs(static_cast<double>(cast.values[i] - truth.values[i]));
    }
    CHECK(sum / static_cast<double>(truth.values.size()) < 0.003); // filtered stripes far away: a hundredth of 0.3
}

TEST_CASE("no ray slips out of a closed room between its triangles") {
    content::SceneDesc scene = empty_scene();
    add(scene, sphere({0.3f, 0.1f, -0.2f}, 5.0f, 96), unlit(glm::vec3(1.0f)));
    const render::SceneColour colour(scene);
    const render::RayCaster caster(scene, colour);
    std::ptrdiff_t missed = 0;
    for (const double rapidity : {0.0, 1.0, 2.6467}) {
        for (const glm::dvec3& look : {ahead, -ahead, glm::dvec3(1, 0, 0)}) {
            render::RenderFrame view = frame(rapidity, ahead, look, 480, 270);
            view.layer = render::Layer::object;
            const render::Picture objects = caster.picture(view);
            missed += std::count(objects.values.begin(), objects.values.end(), -1.0f);
        }
    }
    CHECK(missed == 0); // of 1.2 million rays, a quarter of which pass within a pixel of an edge
}

TEST_CASE("ray pictures are finite along the axes up to rapidity 10, in every mode") {
    const content::SceneDesc scene = furnished_scene();
    const render::SceneColour colour(scene);
    const render::RayCaster caster(scene, colour);
    for (const double rapidity : {0.0, 5e-5, 0.9, 2.6467, 5.0, 10.0}) {
        for (const glm::dvec3& heading : {ahead, -ahead, glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
            for (const render::Mode mode :
                 {render::Mode::geometry, render::Mode::doppler, render::Mode::searchlight, render::Mode::full}) {
                render::RenderFrame view = frame(rapidity, heading, ahead, 45, 27);
                view.mode = mode;
                const render::Picture light = caster.picture(view);
                const bool finite = std::all_of(light.values.begin(), light.values.end(),
                                                [](float value) { return std::isfinite(value); });
                CAPTURE(rapidity, heading.x, heading.y, heading.z);
                CHECK(finite);
            }
        }
    }
}

TEST_CASE("light for OpenGL is the same picture upside down in half floats") {
    const content::SceneDesc scene = furnished_scene();
    const render::SceneColour colour(scene);
    const render::RayCaster caster(scene, colour);
    const render::RenderFrame view = frame(0.8, ahead, ahead, 50, 21);
    std::vector<glm::vec4> floats(std::size_t{50} * 21);
    std::vector<render::HalfPixel> halves(floats.size());
    caster.light(view, 2.0, std::span(floats));
    render::LightPackets packets;
    caster.light(view, 2.0, packets);
    render::write_halves(packets, halves);
    double worst = 0.0;
    for (std::size_t row = 0; row < 21; ++row) {
        for (std::size_t column = 0; column < 50; ++column) {
            const glm::vec4& exact = floats[row * 50 + column];
            const render::HalfPixel& half = halves[(20 - row) * 50 + column];
            for (int i = 0; i < 4; ++i) {
                const float value = glm::unpackHalf1x16(half[static_cast<std::size_t>(i)]);
                // Half of a last place, the denormals' at the least.
                const float place = std::max(std::abs(exact[i]) * 0x1p-11f, 0x1p-25f);
                worst = std::max(worst, static_cast<double>(std::abs(value - exact[i]) / place));
            }
        }
    }
    CHECK(worst <= 1.0);
}

TEST_CASE("an empty scene is sky, and stars shine only where nothing stands before them") {
    content::SceneDesc scene;
    const render::RenderFrame view = frame(0.5, ahead, {0.0, 1.0, 0.0}, 16, 16);
    CHECK(colour_at(picture(scene, view), 8, 8).b > 0.1);
    scene = empty_scene();
    content::Star star;
    star.position = {0.0, 0.0, -10.0};
    star.visual_magnitude = -20.0f;
    scene.stars.push_back(star);
    const render::RenderFrame at_star = frame(0.0, ahead, ahead, 17, 17);
    const double bright = colour_at(picture(scene, at_star), 8, 8).g;
    CHECK(bright > 0.0);
    // Straight ahead both begin with the same doubles, and round them to floats twice.
    CHECK_THAT(bright, WithinRel(colour_at(render::ReferenceRenderer(scene).render(at_star, 1), 8, 8).g, 0x1p-22));
    add(scene, rectangle({0, 0, -5}, {1, 0, 0}, {0, 1, 0}), unlit(glm::vec3(0.0f)));
    CHECK(colour_at(picture(scene, at_star), 8, 8).g == 0.0);
}
