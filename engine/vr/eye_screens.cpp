#include "engine/vr/eye_screens.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace engine {
namespace {

/// Displays that are turned against each other by less look the same way.
constexpr double unseen_pixels = 0.05;
constexpr int step = 4; ///< pixels: rays are cast in packets of 4 x 4

/// Pixels from the axis to an edge, outwards to a multiple of the step.
int pixels_to(double tangent, double focal_pixels) {
    // A ten-thousandth of a pixel less: what is on a border but for rounding stays there.
    return step * static_cast<int>(std::ceil((tangent * focal_pixels - 1e-4) / step));
}

void show_on(const EyeScreen& screen, render::EyeView& view) {
    view.horizontal_field_of_view = 2.0 * std::atan(0.5 * screen.width / screen.focal_pixels);
    view.width = screen.width;
    view.height = screen.height;
    view.axis_from_middle = glm::dvec2(screen.axis) - 0.5 * glm::dvec2(screen.width, screen.height);
}

} // namespace

std::array<EyeScreen, 2> eye_screens(const input::XrEyes& eyes, int width, int height) {
    // Going outwards to multiples of the step adds less than one step at each edge.
    double focal_pixels = 1e9;
    for (const input::XrEye& eye : eyes) {
        focal_pixels = std::min({focal_pixels, std::max(width - 2 * step, step) / (eye.right - eye.left),
                                 std::max(height - 2 * step, step) / (eye.up - eye.down)});
    }
    std::array<EyeScreen, 2> screens;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const input::XrEye& eye = eyes.at(i);
        EyeScreen& screen = screens.at(i);
        screen.focal_pixels = focal_pixels;
        screen.axis = {pixels_to(-eye.left, focal_pixels), pixels_to(-eye.down, focal_pixels)};
        screen.width = screen.axis.x + pixels_to(eye.right, focal_pixels);
        screen.height = screen.axis.y + pixels_to(eye.up, focal_pixels);
    }
    return screens;
}

std::array<render::EyeView, 2> eye_views(const sim::VehicleState& ship, const sim::ControlFrame& demand,
                                         double metres_per_light_unit, const input::XrEyes& eyes,
                                         const std::array<EyeScreen, 2>& screens) {
    const sim::Event head = sim::head_event(ship, demand.head_position);
    const auto world_from_head =
        sim::world_from_head(ship.world_from_vehicle, demand.vehicle_from_head, demand.head_velocity);
    std::array<render::EyeView, 2> views;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const input::XrPlace& place = eyes.at(i).head_from_eye;
        const EyeScreen& screen = screens.at(i);
        const sim::FourVector<sim::Head> eye{0.0, place.position / metres_per_light_unit};
        render::EyeView& view = views.at(i);
        view.position = (head.space + (world_from_head * eye).space) * metres_per_light_unit;
        view.world_from_head = sim::world_from_head(ship.world_from_vehicle,
                                                    demand.vehicle_from_head * place.orientation, demand.head_velocity);
        show_on(screen, view);
    }
    return views;
}

std::optional<render::EyeView> whole_view(const input::XrEyes& eyes, const render::EyeView& left,
                                          const std::array<EyeScreen, 2>& screens) {
    const glm::dquat between = glm::conjugate(eyes[0].head_from_eye.orientation) * eyes[1].head_from_eye.orientation;
    const double angle = 2.0 * glm::length(glm::dvec3(between.x, between.y, between.z));
    if (angle * screens[0].focal_pixels > unseen_pixels) {
        return std::nullopt;
    }
    EyeScreen both = screens[0];
    both.axis = glm::max(screens[0].axis, screens[1].axis);
    both.width = both.axis.x + std::max(screens[0].width - screens[0].axis.x, screens[1].width - screens[1].axis.x);
    both.height = both.axis.y + std::max(screens[0].height - screens[0].axis.y, screens[1].height - screens[1].axis.y);
    render::EyeView whole = left;
    show_on(both, whole);
    return whole;
}

} // namespace engine
