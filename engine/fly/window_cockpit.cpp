#include "engine/fly/hud_reading.h"
#include "engine/fly/window_flight.h"
#include "engine/panes.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <numbers>

namespace engine {
namespace {

/// How often the screens are drawn anew while nobody points at them: figures that change faster are not read.
constexpr double screens_seconds = 1.0 / 15.0;

constexpr double fade_seconds = 0.7; ///< before a demonstration returns to its start
constexpr double warning_seconds = 10.0;

constexpr double radians = std::numbers::pi / 180.0;

} // namespace

void WindowFlight::sit(const sim::VehicleState& moment, double elapsed_seconds) {
    cockpit_.advance(moment, glm::length(moment.angular_velocity) * clock_.pace(), elapsed_seconds);
    const ComfortSettings& comfort = cockpit_.comfort();
    hands_.set_snap_turn(static_cast<double>(comfort.snap_degrees) * radians, comfort.snap_turn);
    // A replay's head was recorded as the seat was turned then.
    hands_.set_vehicle_from_seat(is_replay() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : cockpit_.vehicle_from_seat());
    picture_.display.brightest = comfort.brightest;
    if (headset_) {
        headset_->set_vehicle_from_seat(cockpit_.vehicle_from_seat());
    }
}

void WindowFlight::recentre() {
    hands_.recentre();
    if (headset_) {
        headset_->recentre();
    }
}

std::optional<PointerRay> WindowFlight::hand(const glm::dquat& head, const render::EyeView& eye) const {
    if (imgui_.wants_mouse()) {
        return std::nullopt;
    }
    const Window::Point cursor = window_.cursor();
    const Window::Size size = window_.framebuffer_size();
    const glm::dvec2 place(2.0 * cursor.x / size.width - 1.0, 1.0 - 2.0 * cursor.y / size.height);
    const double across = std::tan(0.5 * eye.horizontal_field_of_view);
    const glm::dvec3 in_head(place.x * across, place.y * across * size.height / size.width, -1.0);
    const Flight& flight = recorded_->flight();
    return PointerRay{flight.control().head_position * flight.metres_per_light_unit(), head * in_head};
}

void WindowFlight::draw_screens(const sim::VehicleState& moment, const glm::dquat& head,
                                const std::optional<PointerRay>& hand, bool pressed, double elapsed_seconds) {
    screens_age_ += elapsed_seconds;
    if (!cockpit_.shown() || (screens_age_ < screens_seconds && !cockpit_.hears_pointer() && !pressed)) {
        return;
    }
    HudModel model = read_instruments(scenario_, recorded_->flight(), moment, head, picture_, navigation_);
    model.paused = !is_replay() && clock_.paused();
    cockpit_.draw_panel(model, picture_, hand, pressed, options_.demo.has_value(), screens_age_);
    screens_age_ = 0.0;
}

bool WindowFlight::seen_from_the_seat() const {
    return panes_of(picture_).size() == 1 && cameras_.is_pilots(); // panes are for comparing, not for flying
}

void WindowFlight::draw_cockpit(const sim::VehicleState& moment, const glm::dquat& head,
                                const render::RenderFrame& whole, const Window::Size& size) {
    if (!seen_from_the_seat()) {
        return;
    }
    draw_screens(moment, head, hand(head, whole.eye), window_.presses_left_button(), whole.seconds_since_last_frame);
    cockpit_.light(renderer_, whole, moment, exposures_used_.front());
    const Flight& flight = recorded_->flight();
    cockpit_.draw_over(cabin_view(whole.eye, flight.control().head_position * flight.metres_per_light_unit(), head),
                       whole, exposures_used_.front(), demo_fade(), 0, {0, 0, size.width, size.height});
}

void WindowFlight::attend(const input::DeviceState& devices, double elapsed_seconds) {
    if (!idle_) {
        return;
    }
    const Window::Point cursor = window_.cursor();
    const bool cursor_moved = cursor.x != last_cursor_.x || cursor.y != last_cursor_.y;
    last_cursor_ = cursor;
    constexpr double moving_head = 0.1; // metres a second: a headset that lies on a table does not
    const bool head_moves = headset_frame_ && glm::length(headset_frame_->head.velocity) > moving_head;
    const bool touched = is_touched(devices, cursor_moved) || head_moves;
    touched_ = touched_ || touched;
    idle_->advance(elapsed_seconds, touched || script_ != nullptr);
    if (idle_->over()) {
        return_to_start();
    }
}

void WindowFlight::return_to_start() {
    idle_->begin();
    const bool moved = recorded_->flight().state().event.space != starting_state(scenario_).event.space;
    if (!touched_ && !moved) {
        return; // nothing has happened: no further recording of nothing
    }
    touched_ = false;
    end_flight();
    picture_ = starting_picture(scenario_);
    cockpit_.comfort() = options_.comfort;
    cockpit_.show(options_.cockpit);
    show_help_ = false;
    show_instruments_ = true;
    probe_.reset();
    hands_ = input::DevicePilot(scenario_.vehicle);
    clock_.set_paused(false);
    clock_.set_pace(scenario_.pace);
    hands_.set_seconds_per_tick(1.0 / (clock_.pace() * scenario_.vehicle.tick_rate));
    begin_flight({});
    cameras_.choose(options_.camera.kind, recorded_->flight().state());
    notices_.show("a new flight from the start");
}

float WindowFlight::demo_fade() const {
    return idle_ ? static_cast<float>(std::clamp(1.0 - idle_->seconds_left() / fade_seconds, 0.0, 1.0)) : 0.0F;
}

void WindowFlight::say_demo(HudModel& model) const {
    if (!idle_) {
        return;
    }
    const double left = idle_->seconds_left();
    model.notices.insert(
        model.notices.begin(),
        left < warning_seconds
            ? fmt::format("back to the start in {:.0f} s: touch anything to go on", std::ceil(left))
            : fmt::format("demonstration: back to the start after {:g} s without a touch", idle_->limit()));
}

} // namespace engine
