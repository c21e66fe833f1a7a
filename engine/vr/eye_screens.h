#pragma once

#include "engine/flight.h"
#include "input/head_pilot.h"
#include "render/render_frame.h"

#include <array>
#include <optional>

namespace engine {

/// The picture of one eye: square pixels, whose borders meet on the eye's axis.
struct EyeScreen {
    int width = 0;
    int height = 0;
    double focal_pixels = 1.0; ///< pixels a unit tangent
    glm::ivec2 axis{0};        ///< where the eye's axis meets the screen, pixels from the lower left corner

    /// Tangents of the angles from the axis to the edges.
    double left() const { return -axis.x / focal_pixels; }
    double right() const { return (width - axis.x) / focal_pixels; }
    double down() const { return -axis.y / focal_pixels; }
    double up() const { return (height - axis.y) / focal_pixels; }
};

/// Screens of at most `width` x `height` pixels that cover what both eyes' screens cover, and less than 1 % more at a
/// headset's sizes: one pixel size for both eyes, and edges at multiples of four pixels from the axis. So both eyes
/// look through the same grid of rays, and what is infinitely far is the same in both, pixel by pixel.
std::array<EyeScreen, 2> eye_screens(const input::XrEyes& eyes, int width, int height);

/// The views of two eyes of a head in the ship. Each eye is an event of its own, and both are simultaneous in the
/// head's frame: x_eye = x_head + Lambda_world<-head (0, eye), where the head's frame moves in the vehicle's
/// (PHYSICS 3). `demand` holds the head.
std::array<render::EyeView, 2> eye_views(const sim::VehicleState& ship, const sim::ControlFrame& demand,
                                         double metres_per_light_unit, const input::XrEyes& eyes,
                                         const std::array<EyeScreen, 2>& screens);

/// A view that looks as both eyes do and covers what they cover, on their grid of pixels; none where they look
/// different ways: displays at an angle. `left`: the left eye's view.
std::optional<render::EyeView> whole_view(const input::XrEyes& eyes, const render::EyeView& left,
                                          const std::array<EyeScreen, 2>& screens);

} // namespace engine
