#pragma once

#include "engine/cockpit/cockpit.h"
#include "engine/cockpit/comfort.h"

#include <optional>

namespace engine {

/// The cockpit of a flight, on a desktop or in a headset, and what eases its pictures. Needs an OpenGL 4.5 context, as
/// Cockpit.
class FlightCockpit {
  public:
    /// `scale`: pixels per point of text on the screens.
    FlightCockpit(const ComfortSettings& comfort, bool shown, float scale);

    ComfortSettings& comfort() { return comfort_; }
    bool shown() const { return cockpit_.has_value(); }
    void show(bool shown);

    /// Time passes in a ship at that state: `turn_rate`, radians in a second of the pilot's time. The seat follows the
    /// horizon where that is wanted.
    void advance(const sim::VehicleState& ship, double turn_rate, double elapsed_seconds);
    /// How the seat, and the cabin with it, is turned in the ship: a roll, or nothing.
    const glm::dquat& vehicle_from_seat() const { return vehicle_from_seat_; }

    /// Draws the screens. `hand`: who points at them, vehicle frame; a press that began elsewhere is none.
    void draw_panel(const HudModel& model, PictureSettings& picture, const std::optional<PointerRay>& hand,
                    bool pressed, bool locked, double elapsed_seconds);
    /// A widget on a screen was under the pointer.
    bool hears_pointer() const { return cockpit_ && cockpit_->panel().hears_pointer(); }

    /// Whether draw_over with that fade would change anything.
    bool draws_over(float fade) const { return cockpit_ || narrowing_ > 0.0F || fade > 0.0F; }
    /// Lights the cabin, once a frame. Arguments as of Cockpit::light.
    void light(render::Renderer& renderer, const render::RenderFrame& frame, const sim::VehicleState& ship,
               double exposure_stops);
    /// Over an eye's finished picture: narrows the view while the ship turns, then draws the cabin, then `fade` dims
    /// all of it.
    void draw_over(const render::CabinView& eye_in_vehicle, const render::RenderFrame& frame, double exposure_stops,
                   float fade, unsigned framebuffer, const render::Viewport& viewport);

  private:
    ComfortSettings comfort_;
    float scale_;
    std::optional<Cockpit> cockpit_;
    render::ComfortPass comfort_pass_;
    TurnVignette vignette_;
    float narrowing_ = 0.0F;
    glm::dquat vehicle_from_seat_{1.0, 0.0, 0.0, 0.0};
    bool was_pressed_ = false;
    bool touching_ = false; ///< the press began on a screen
};

} // namespace engine
