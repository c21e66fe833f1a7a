#include "engine/fly/flight_cockpit.h"

#include "sim/level.h"

namespace engine {

FlightCockpit::FlightCockpit(const ComfortSettings& comfort, bool shown, float scale)
    : comfort_(comfort), scale_(scale) {
    show(shown);
}

void FlightCockpit::show(bool shown) {
    if (shown && !cockpit_) {
        cockpit_.emplace(scale_);
    } else if (!shown) {
        cockpit_.reset();
    }
}

void FlightCockpit::advance(const sim::VehicleState& ship, double turn_rate, double elapsed_seconds) {
    narrowing_ = vignette_.advance(turn_rate, comfort_.vignette, elapsed_seconds);
    vehicle_from_seat_ =
        comfort_.steady_horizon ? sim::level_roll(ship.world_from_vehicle) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

void FlightCockpit::draw_panel(const HudModel& model, PictureSettings& picture, const std::optional<PointerRay>& hand,
                               bool pressed, bool locked, double elapsed_seconds) {
    if (!cockpit_) {
        return;
    }
    PanelTouch touch;
    if (hand) {
        const glm::dquat seat_from_vehicle = glm::conjugate(vehicle_from_seat_);
        touch.place = panel_place(cockpit_->cabin().screens,
                                  {seat_from_vehicle * hand->origin, seat_from_vehicle * hand->direction});
    }
    if (pressed && !was_pressed_) {
        touching_ = touch.place.has_value();
    }
    was_pressed_ = pressed;
    touch.pressed = pressed && touching_;
    cockpit_->panel().draw(model, picture, comfort_, touch, locked, elapsed_seconds);
}

void FlightCockpit::light(render::Renderer& renderer, const render::RenderFrame& frame, const sim::VehicleState& ship,
                          double exposure_stops) {
    if (cockpit_) {
        cockpit_->light(renderer, frame, ship.world_from_vehicle, vehicle_from_seat_, exposure_stops);
    }
}

void FlightCockpit::draw_over(const render::CabinView& eye_in_vehicle, const render::RenderFrame& frame,
                              double exposure_stops, float fade, unsigned framebuffer,
                              const render::Viewport& viewport) {
    comfort_pass_.draw(eye_in_vehicle.tangents, {narrowing_, 0.0F}, framebuffer, viewport);
    if (cockpit_) {
        render::CabinView in_cabin = eye_in_vehicle;
        const glm::dquat seat_from_vehicle = glm::conjugate(vehicle_from_seat_);
        in_cabin.eye = seat_from_vehicle * eye_in_vehicle.eye;
        in_cabin.cabin_from_eye = seat_from_vehicle * eye_in_vehicle.cabin_from_eye;
        cockpit_->draw(in_cabin, {exposure_stops, frame.exposure.linear_curve, frame.display.brightest}, framebuffer,
                       viewport);
    }
    comfort_pass_.draw(eye_in_vehicle.tangents, {0.0F, fade}, framebuffer, viewport);
}

} // namespace engine
