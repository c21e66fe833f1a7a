#include "render/cabin/surroundings.h"

#include "sim/look.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace render {
namespace {

/// Enough for rapidity 10; beyond, the light ahead is one spot however fine it is sampled.
constexpr int most_nested = 14;

/// D for an angle from straight ahead whose half-angle tangent is t: e^-xi cos^2 + e^xi sin^2.
double wavelength_ratio(double rapidity, double half_angle_tangent) {
    const double t2 = half_angle_tangent * half_angle_tangent;
    return (std::exp(-rapidity) + std::exp(rapidity) * t2) / (1.0 + t2);
}

bool brightens(Mode mode) {
    return mode == Mode::searchlight || mode == Mode::full;
}

double searchlight(double rapidity, double half_angle_tangent) {
    return std::pow(wavelength_ratio(rapidity, half_angle_tangent), -4.0);
}

} // namespace

double stops_at_rest(double stops, const sim::BoostAndRotation& eye, Mode mode) {
    const glm::dvec3 look = eye.boosted_from_head * glm::dvec3(0.0, 0.0, -1.0);
    const double cosine = glm::dot(look, eye.along);
    const double half_angle_tangent = std::sqrt(std::max(1.0 - cosine, 0.0) / std::max(1.0 + cosine, 1e-12));
    return brightens(mode) ? stops + std::log2(searchlight(eye.xi.value, half_angle_tangent)) : stops;
}

std::vector<SurroundingsView> surroundings_views(const sim::BoostAndRotation& eye, Mode mode) {
    const glm::dmat3 axes = sim::camera_axes(eye.along); // right, up, back of who looks ahead
    const glm::dvec3& right = axes[0];
    const glm::dvec3& up = axes[1];
    const glm::dvec3& back = axes[2];
    const auto brightest = [&](double half_angle_tangent) {
        return brightens(mode) ? searchlight(eye.xi.value, half_angle_tangent) : 1.0;
    };
    // Nearest to straight ahead: of the side faces the middle of an edge, 45 degrees; of the one behind, 135.
    const double beside = brightest(std::tan(0.125 * std::numbers::pi));
    const double behind = brightest(std::tan(0.375 * std::numbers::pi));
    const double ahead = brightest(0.0);
    std::vector<SurroundingsView> views{{axes, 1.0, 0.0, ahead}};
    views.push_back({{-back, up, right}, 1.0, 0.0, beside}); // to the left
    views.push_back({{back, up, -right}, 1.0, 0.0, beside}); // to the right
    views.push_back({{right, back, -up}, 1.0, 0.0, beside}); // upwards
    views.push_back({{right, -back, up}, 1.0, 0.0, beside}); // downwards
    views.push_back({{-right, up, -back}, 1.0, 0.0, behind});
    const int nested = std::clamp(static_cast<int>(std::ceil(eye.xi.value / std::numbers::ln2)), 0, most_nested);
    for (int i = 0; i < nested; ++i) {
        SurroundingsView inner = views[i == 0 ? 0 : views.size() - 1];
        SurroundingsView& outer = views[i == 0 ? 0 : views.size() - 1];
        inner.half_width = 0.5 * outer.half_width;
        outer.left_out_to = inner.half_width;
        outer.brightness_to = brightest(std::tan(0.5 * std::atan(inner.half_width)));
        views.push_back(inner);
    }
    return views;
}

RenderFrame surroundings_frame(const RenderFrame& frame, const sim::BoostAndRotation& eye, const SurroundingsView& view,
                               double stops_at_rest) {
    RenderFrame small = frame;
    small.eye = {};
    small.eye.position = frame.eye.position;
    small.eye.world_from_head = sim::boost<sim::World, sim::Boosted>(eye.xi, eye.along) *
                                sim::rotation_to<sim::Boosted, sim::Head>(view.boosted_from_view);
    small.eye.horizontal_field_of_view = 2.0 * std::atan(view.half_width);
    small.eye.width = surroundings_side;
    small.eye.height = surroundings_side;
    small.layer = Layer::light;
    small.exposure = {false, static_cast<float>(stops_at_rest - std::log2(view.brightness_to)), true};
    small.sharpness = 0.5;
    return small;
}

void add_samples(const SurroundingsView& view, const Picture& picture, double exposure_stops,
                 std::vector<SeenLightSample>& samples) {
    const double radiance_from_exposed = std::exp2(-exposure_stops);
    const double pixel = 2.0 * view.half_width / picture.width;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const double x = (column + 0.5) * pixel - view.half_width;
            const double y = view.half_width - (row + 0.5) * pixel;
            if (std::max(std::abs(x), std::abs(y)) < view.left_out_to) {
                continue;
            }
            const double distance2 = 1.0 + x * x + y * y;
            const double solid_angle = pixel * pixel / (distance2 * std::sqrt(distance2));
            const auto at = static_cast<std::size_t>(row * picture.width + column) * 3;
            const glm::dvec3 light(picture.values[at], picture.values[at + 1], picture.values[at + 2]);
            samples.push_back({glm::vec3(view.boosted_from_view * (glm::dvec3(x, y, -1.0) / std::sqrt(distance2))),
                               glm::vec3(light * (radiance_from_exposed * solid_angle))});
        }
    }
}

glm::dvec3 irradiance(const std::vector<SeenLightSample>& samples, const glm::dvec3& normal) {
    glm::dvec3 sum(0.0);
    for (const SeenLightSample& sample : samples) {
        sum += std::max(glm::dot(normal, glm::dvec3(sample.direction)), 0.0) * glm::dvec3(sample.power);
    }
    return sum;
}

} // namespace render
