#include "engine/fly/window_flight.h"
#include "input/xr_failure.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <utility>

namespace engine {
namespace {

/// The part of an eye's picture that a window shows: around the eye's axis, as large as fits, of the window's shape.
struct MirrorArea {
    int left = 0; ///< pixels of the eye's picture, from its lower left corner
    int bottom = 0;
    int width = 1;
    int height = 1;
};

MirrorArea mirror_area(const EyeScreen& eye, const Window::Size& window) {
    const double half_width = std::min(eye.axis.x, eye.width - eye.axis.x);
    const double half_height = std::min(eye.axis.y, eye.height - eye.axis.y);
    const double shape = static_cast<double>(window.width) / window.height;
    const int half_columns = std::max(1, static_cast<int>(std::min(half_width, half_height * shape)));
    const int half_rows = std::max(1, static_cast<int>(std::min(half_height, half_width / shape)));
    return {eye.axis.x - half_columns, eye.axis.y - half_rows, 2 * half_columns, 2 * half_rows};
}

} // namespace

void WindowFlight::find_headset() {
    try {
        headset_.emplace(options_.stage ? input::XrBase::stage : input::XrBase::local, options_.eye_size);
        picture_.other_panes.clear(); // eyes are not split
        show_headset_notes();
    } catch (const input::XrFailure& failure) {
        fmt::print("no headset here ({}): flying in the window\n", failure.what());
    }
}

bool WindowFlight::begin_headset_frame() {
    headset_frame_ = headset_ ? headset_->begin_frame() : std::nullopt;
    if (headset_) {
        window_.set_vertical_sync(!headset_frame_); // the headset says when the next frame is due
        show_headset_notes();
        if (headset_->over()) {
            window_.close();
        }
    }
    return headset_frame_.has_value();
}

void WindowFlight::hear_headset(input::DeviceState& devices) {
    if (headset_frame_->controllers.gamepad) {
        devices.gamepad = headset_frame_->controllers.gamepad;
    }
    if (headset_frame_->controllers.menu && !options_.demo) {
        show_panel_ = !show_panel_;
    }
}

void WindowFlight::show_headset_notes() {
    for (const std::string& note : headset_->take_notes()) {
        fmt::print("{}\n", note);
        notices_.show(note, 4.0);
    }
}

void WindowFlight::show_in_headset(double elapsed_seconds) {
    Flight& flight = recorded_->flight();
    note_frame(flight, *headset_frame_, room_scale(), fraction_);
    headset_->shake(clock_.paused() ? 0.0 : thrust_felt(flight));
    const sim::VehicleState ship = flight.between(fraction_);
    const input::XrPlace& pointer = headset_frame_->pointer.place;
    if (headset_frame_->pointer.tracked) {
        draw_screens(ship, headset_frame_->head.place.orientation,
                     PointerRay{pointer.position, pointer.orientation * glm::dvec3(0.0, 0.0, -1.0)},
                     headset_frame_->controllers.select > 0.5, elapsed_seconds);
    } else {
        draw_screens(ship, headset_frame_->head.place.orientation, {}, false, elapsed_seconds);
    }
    bool lit = false;
    const EyeOverlay overlay = [&](const render::CabinView& eye, const render::RenderFrame& frame, double stops,
                                   unsigned framebuffer, const render::Viewport& viewport) {
        if (!std::exchange(lit, true)) { // one light for both eyes
            cockpit_.light(renderer_, frame, ship, stops);
        }
        cockpit_.draw_over(eye, frame, stops, demo_fade(), framebuffer, viewport);
    };
    headset_->end_frame(renderer_, flight, ship, picture_, room_scale(),
                        cockpit_.draws_over(demo_fade()) ? overlay : EyeOverlay(), elapsed_seconds);
}

input::RoomScale WindowFlight::room_scale() const {
    return {recorded_->flight().metres_per_light_unit(), clock_.pace()};
}

bool WindowFlight::is_mirror() const {
    return headset_frame_ && headset_frame_->shown && headset_->present();
}

render::RenderFrame WindowFlight::draw_mirror(const render::RenderFrame& whole, const Window::Size& size) {
    const EyePictures& pictures = headset_->pictures();
    const MirrorArea area = mirror_area(pictures.screen(0), size);
    glBlitNamedFramebuffer(pictures.picture(0).framebuffer(), 0, area.left, area.bottom, area.left + area.width,
                           area.bottom + area.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    exposures_used_ = {pictures.statistics(0).exposure_stops};
    // What the window shows is a picture of its own, for the instruments, the probe and the screenshot's text.
    render::RenderFrame mirror = whole;
    mirror.eye.position = pictures.view(0).position;
    mirror.eye.world_from_head = pictures.view(0).world_from_head;
    mirror.eye.width = picture_.width = area.width;
    mirror.eye.height = picture_.height = area.height;
    mirror.eye.horizontal_field_of_view = picture_.horizontal_field_of_view =
        2.0 * std::atan(0.5 * area.width / pictures.screen(0).focal_pixels);
    return mirror;
}

} // namespace engine
