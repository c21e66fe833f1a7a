#include "render/star_sheet.h"

#include "render/eye_ray.h"
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/parallel_for.h>

namespace render {
namespace star_shader {
using glm::abs;
using glm::dot;
using glm::max;
using glm::normalize;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "render/shaders/shared/star.glsl"
} // namespace star_shader

StarSheet::Shares::Shares(float centre) : first(static_cast<int>(std::floor(centre - 0.5f)) - footprint / 2 + 1) {
    for (int i = 0; i < footprint; ++i) {
        values[static_cast<std::size_t>(i)] = star_shader::spline_weight(static_cast<float>(first + i) + 0.5f - centre);
    }
}

StarSheet::StarSheet(const content::SceneDesc& scene, const DopplerColour& colour) : colour_(colour) {
    stars_.reserve(scene.stars.size());
    for (const content::Star& star : scene.stars) {
        stars_.push_back({star.position, star_source(colour, star)});
    }
}

std::vector<StarSheet::Spot> StarSheet::spots(const RenderFrame& frame, double scale, double faintest) const {
    const glm::dvec3 eye = frame.eye.position / frame.metres_per_light_year;
    const auto axes = sim::tetrad(frame.eye.world_from_head);
    const double focal_pixels = focal_length_pixels(frame.eye);
    const glm::dvec2 axis = axis_pixel(frame.eye);
    const glm::dvec2 middle(0.5 * frame.eye.width, 0.5 * frame.eye.height);
    const auto largest_share = static_cast<double>(star_shader::star_share(glm::vec2(0.0f)));

    // By portions of fixed size, so that the sum over stars is the same on any number of threads.
    constexpr std::size_t portion = 4096;
    std::vector<std::vector<Spot>> found((stars_.size() + portion - 1) / portion);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t chunk) {
        std::vector<Spot>& mine = found[chunk];
        for (std::size_t i = chunk * portion; i < std::min((chunk + 1) * portion, stars_.size()); ++i) {
            const glm::dvec3 offset = stars_[i].position - eye;
            const double distance = glm::length(offset);
            // The photon's momentum, of frequency 1 in the world, in components of the head's frame.
            const sim::FourVector<sim::World> photon{1.0, -offset / distance};
            const double frequency = -sim::dot(axes[0], photon);
            const double ahead = sim::dot(axes[3], photon); // seen towards -z: the photon flies along +z
            if (ahead <= 0.0) {
                continue;
            }
            const glm::dvec2 tangents(-sim::dot(axes[1], photon) / ahead, sim::dot(axes[2], photon) / ahead);
            const glm::dvec2 centre = axis + focal_pixels * tangents;
            if (glm::any(glm::greaterThan(glm::abs(centre - middle), middle + 0.5 * footprint))) {
                continue;
            }
            const double cosine = ahead / frequency;
            const double solid_angle = cosine * cosine * cosine / (focal_pixels * focal_pixels);
            const glm::dvec3 light =
                scale / solid_angle * star_light(colour_, stars_[i].source, frame.mode, distance, 1.0 / frequency);
            if (std::max({light.r, light.g, light.b}) * largest_share > faintest) {
                mine.push_back({glm::vec2(centre), glm::vec3(light)});
            }
        }
    });
    std::vector<Spot> all;
    for (const std::vector<Spot>& mine : found) {
        all.insert(all.end(), mine.begin(), mine.end());
    }
    return all;
}

void StarSheet::draw(const RenderFrame& frame, double scale, double faintest, std::vector<glm::vec4>& pixels) const {
    const int width = frame.eye.width;
    const int height = frame.eye.height;
    pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), glm::vec4(0.0f));
    for_each_share(frame, scale, faintest, [&](int column, int row, const glm::vec3& light) {
        pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)] +=
            glm::vec4(light, 0.0f);
    });
}

} // namespace render
