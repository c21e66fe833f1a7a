#include "render/colour/colour_difference.h"
#include "render/colour/colour_space.h"
#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "render/offline/reference.h"
#include "render/shown_picture.h"
#include "tests/render/scene_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace scene_kit;

namespace {

content::Material special(int i) {
    content::Material material = matte({0.12f, 0.4f, 0.08f});
    if (i == 0) {
        material.vegetation = true;
    } else if (i == 1) {
        material.invisible_reflectance.infrared = 1.0f;
    } else if (i == 2) {
        material.reflectance_spectrum = content::Spectrum(content::SampledSpectrum{
            {400.0, 500.0, 600.0, 700.0, 1000.0}, {0.1, 0.5, 0.2, 0.6, 0.3}, content::TabulatedSpectrum::Beyond::held});
    } else if (i == 3) {
        material.emission = glm::vec3(0.5f);
        material.emission_temperature = 2200.0f;
    } else if (i == 4) {
        material.emission = {0.2f, 0.1f, 0.4f};
        material.invisible_emission = {0.5f, 0.7f};
    } else {
        material.unlit = true;
    }
    return material;
}

/// A wall of coloured squares and special materials in the light of the sun, of an incandescent lamp and of another
/// whose light is the scene's; a slab before it throws both lamps' shadows.
content::SceneDesc chart(content::ReflectanceModel model) {
    content::SceneDesc scene;
    scene.reflectance_model = model;
    scene.sun = content::Sun{glm::normalize(glm::vec3(0.3f, 0.4f, 1.0f)), glm::vec3(2.0f, 1.8f, 1.5f)};
    scene.ambient = {0.1f, 0.12f, 0.16f};
    scene.lamps.push_back(
        {"warm", {-2.5f, 1.0f, -2.5f}, glm::vec3(3.0f), 0.0f, content::Spectrum(content::BlackBody{2700.0})});
    scene.lamps.push_back({"plain", {2.5f, 1.0f, -2.0f}, {2.0f, 2.5f, 3.0f}, 0.0f});
    constexpr int columns = 6;
    constexpr int rows = 5;
    for (int i = 0; i < columns * rows; ++i) {
        const glm::vec3 centre(-2.5f + static_cast<float>(i % columns), 2.0f - static_cast<float>(i / columns), -4.0f);
        const float x = static_cast<float>(i % 3) / 2.0f;
        const float y = static_cast<float>(i / 3 % 3) / 2.0f;
        const float z = static_cast<float>(i / 9 % 3) / 2.0f;
        add(scene, rectangle(centre, {0.5f, 0, 0}, {0, 0.5f, 0}),
            i < 24 ? matte(glm::vec3(0.05f) + 0.9f * glm::vec3(x, y, z)) : special(i - 24));
    }
    content::Material slab = matte(glm::vec3(0.5f));
    slab.double_sided = true;
    add(scene, rectangle({0.2f, 0.3f, -3.2f}, {0.35f, 0, 0}, {0, 0.3f, 0}), slab);
    return scene;
}

/// Pixels well inside of one object and away from a shadow's edge, where two methods see the same point of the scene.
bool inside(const render::Picture& objects, const render::Picture& truth, int column, int row) {
    if (column < 2 || row < 2 || column >= objects.width - 2 || row >= objects.height - 2) {
        return false;
    }
    const double luminance = content::luminance_of(colour_at(truth, column, row));
    for (int y = row - 2; y <= row + 2; ++y) {
        for (int x = column - 2; x <= column + 2; ++x) {
            const double other = content::luminance_of(colour_at(truth, x, y));
            if (value_at(objects, x, y) != value_at(objects, column, row) || std::abs(other / luminance - 1.0) > 0.08) {
                return false;
            }
        }
    }
    return true;
}

void check_method(render::Method method, content::ReflectanceModel model, render::Mode mode) {
    const content::SceneDesc scene = chart(model);
    const render::ReferenceRenderer reference(scene);
    render::RendererSettings settings;
    settings.method = method;
    settings.shadow_map_size = 1024;
    render::Renderer renderer(scene, settings);
    for (const double rapidity : {0.4, 0.9}) {
        for (const double turn : {1.0, -1.0}) { // towards the chart and away from it
            render::RenderFrame view = frame(rapidity, {0.2, 0.0, -turn}, {0.0, 0.0, -1.0}, 240, 180);
            view.mode = mode;
            const render::Picture truth = reference.render(view, 1);
            render::RenderFrame object_view = view;
            object_view.layer = render::Layer::object;
            const render::Picture objects = reference.render(object_view, 1);
            view.exposure.stops = static_cast<float>(render::exposure_stops(truth, {true, 0.0f, true}));
            const double exposure = std::exp2(static_cast<double>(view.exposure.stops));
            const render::Picture shown = renderer.picture(view);
            const glm::dmat3 xyz_from_rgb = glm::inverse(render::srgb_from_xyz());
            std::vector<double> found;
            for (int row = 0; row < truth.height; ++row) {
                for (int column = 0; column < truth.width; ++column) {
                    if (!inside(objects, truth, column, row)) {
                        continue;
                    }
                    const glm::dvec3 wanted = exposure * (xyz_from_rgb * colour_at(truth, column, row));
                    const double scale = 1.0 / std::max(1.0, wanted.y);
                    found.push_back(
                        render::ciede2000(render::lab_from_xyz(scale * (xyz_from_rgb * colour_at(shown, column, row))),
                                          render::lab_from_xyz(scale * wanted)));
                }
            }
            REQUIRE(found.size() > 2000);
            std::sort(found.begin(), found.end());
            double sum = 0.0;
            for (const double difference : found) {
                sum += difference;
            }
            INFO("rapidity " << rapidity << ", turn " << turn);
            CHECK(sum / static_cast<double>(found.size()) < 0.5); // half of what an eye can tell side by side
            CHECK(found[found.size() * 99 / 100] < 2.0);
        }
    }
}

} // namespace

TEST_CASE("the texture method's colours are the reference's, whatever reflects and shines") {
    const render::EglContext context;
    check_method(render::Method::texture, content::ReflectanceModel::five_terms, render::Mode::full);
    check_method(render::Method::texture, content::ReflectanceModel::five_terms, render::Mode::geometry);
}

TEST_CASE("the texture method knows the other models of reflectance") {
    const render::EglContext context;
    check_method(render::Method::texture, content::ReflectanceModel::three_primaries, render::Mode::doppler);
    check_method(render::Method::texture, content::ReflectanceModel::dominant_wavelength, render::Mode::full);
}

TEST_CASE("the ray method's colours are the reference's, whatever reflects and shines") {
    const render::EglContext context;
    check_method(render::Method::ray, content::ReflectanceModel::five_terms, render::Mode::full);
    check_method(render::Method::ray, content::ReflectanceModel::five_terms, render::Mode::geometry);
    check_method(render::Method::ray, content::ReflectanceModel::dominant_wavelength, render::Mode::doppler);
}
