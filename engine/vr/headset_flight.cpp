#include "engine/vr/headset_flight.h"

#include "content/flight_script.h"
#include "engine/fixed_step.h"
#include "engine/flight_file.h"
#include "engine/fly/flight_cockpit.h"
#include "engine/fly/flight_summary.h"
#include "engine/fly/hud_reading.h"
#include "engine/fly/loaded_scene.h"
#include "engine/fly/recorded_flight.h"
#include "engine/trace/interruption.h"
#include "engine/vr/headset_ticks.h"
#include "input/device_pilot.h"
#include "input/script_pilot.h"
#include "render/gl/egl_context.h"

#include <cstdio>
#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <thread>
#include <utility>

namespace engine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float screens_scale = 1.5F; ///< pixels per point on the cockpit's screens

/// A flight in a headset and nothing else: no window, no keyboard.
class HeadsetFlight {
  public:
    HeadsetFlight(const content::Scenario& scenario, const FlyOptions& options)
        : scenario_(scenario), options_(options),
          headset_(options.stage ? input::XrBase::stage : input::XrBase::local, options.eye_size),
          renderer_(loaded_scene(scenario), {options.method}),
          recorded_(scenario, options.recording.empty() ? new_flight_file(scenario.name) : options.recording),
          hands_(scenario.vehicle), clock_(scenario.vehicle.tick_rate), picture_(starting_picture(scenario)),
          cockpit_(options.comfort, options.cockpit, screens_scale), navigation_(scenario) {
        clock_.set_pace(scenario.pace);
        hands_.set_seconds_per_tick(seconds_per_tick());
        hands_.set_metres_per_light_unit(recorded_.flight().metres_per_light_unit());
        if (!options.script.empty()) {
            script_ = std::make_unique<input::ScriptPilot>(content::load_flight_script(options.script),
                                                           scenario.vehicle.tick_rate);
        }
    }

    void run() {
        const Interruption interruption;
        while (!Interruption::wanted() && !headset_.over() && recorded_.flight().stop().empty() &&
               !(options_.seconds && flown_seconds_ >= *options_.seconds)) {
            const std::optional<HeadsetFrame> frame = headset_.begin_frame();
            tell_notes();
            if (frame) {
                fly(*frame);
            } else {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }
        headset_.close();
        tell_notes();
        finish();
    }

  private:
    double seconds_per_tick() const { return 1.0 / (clock_.pace() * scenario_.vehicle.tick_rate); }

    void fly(const HeadsetFrame& frame) {
        input::DeviceState devices;
        devices.gamepad = frame.controllers.gamepad;
        hands_.sample(devices, {}, frame.elapsed_seconds);
        flown_seconds_ += frame.elapsed_seconds;
        const FixedStep::Steps steps = clock_.advance(frame.elapsed_seconds);
        Flight& flight = recorded_.flight();
        const input::RoomScale scale{flight.metres_per_light_unit(), clock_.pace()};
        HeadsetTicks ticks(headset_, scale, steps, seconds_per_tick());
        for (sim::Tick i = 0; i < steps.ticks && flight.stop().empty(); ++i) {
            if (script_ && !ticks.tick(flight, *script_) && flight.stop().empty()) {
                script_.reset();
            }
            if (!script_) {
                ticks.tick(flight, hands_);
            }
        }
        note_frame(flight, frame, scale, steps.fraction);
        headset_.shake(thrust_felt(flight));
        show(frame, flight.between(steps.fraction), scale);
        ++pictures_;
    }

    void show(const HeadsetFrame& frame, const sim::VehicleState& ship, const input::RoomScale& scale) {
        cockpit_.advance(ship, glm::length(ship.angular_velocity) * clock_.pace(), frame.elapsed_seconds);
        hands_.set_vehicle_from_seat(cockpit_.vehicle_from_seat());
        headset_.set_vehicle_from_seat(cockpit_.vehicle_from_seat());
        const Flight& flight = recorded_.flight();
        const input::XrPlace& pointer = frame.pointer.place;
        const PointerRay hand{pointer.position, pointer.orientation * glm::dvec3(0.0, 0.0, -1.0)};
        if (cockpit_.shown()) {
            const HudModel model =
                read_instruments(scenario_, flight, ship, frame.head.place.orientation, picture_, navigation_);
            cockpit_.draw_panel(model, picture_, frame.pointer.tracked ? std::optional(hand) : std::nullopt,
                                frame.controllers.select > 0.5, false, frame.elapsed_seconds);
        }
        hands_.set_snap_turn(glm::radians(static_cast<double>(cockpit_.comfort().snap_degrees)),
                             cockpit_.comfort().snap_turn);
        picture_.display.brightest = cockpit_.comfort().brightest;
        bool lit = false;
        const EyeOverlay overlay = [&](const render::CabinView& eye, const render::RenderFrame& eye_frame, double stops,
                                       unsigned framebuffer, const render::Viewport& viewport) {
            if (!std::exchange(lit, true)) { // one light for both eyes
                cockpit_.light(renderer_, eye_frame, ship, stops);
            }
            cockpit_.draw_over(eye, eye_frame, stops, 0.0F, framebuffer, viewport);
        };
        headset_.end_frame(renderer_, flight, ship, picture_, scale, cockpit_.draws_over(0.0F) ? overlay : EyeOverlay(),
                           frame.elapsed_seconds);
    }

    void tell_notes() {
        for (const std::string& note : headset_.take_notes()) {
            fmt::print("{}\n", note);
            std::fflush(stdout);
        }
    }

    void finish() {
        print_flight(scenario_, recorded_.flight());
        if (!recorded_.flight().stop().empty()) {
            fmt::print("{}\n", recorded_.flight().stop());
        }
        if (flown_seconds_ > 0.0) {
            fmt::print("{} frames in the headset, {:.1f} a second\n", pictures_, pictures_ / flown_seconds_);
        }
        const std::string trouble = recorded_.close();
        fmt::print("{}\n", trouble.empty() ? fmt::format("recording: {}", recorded_.file().string()) : trouble);
    }

    content::Scenario scenario_;
    FlyOptions options_;
    render::EglContext context_;
    Headset headset_;
    render::Renderer renderer_;
    RecordedFlight recorded_;
    input::DevicePilot hands_;
    std::unique_ptr<input::Pilot> script_; ///< flies first
    FixedStep clock_;
    PictureSettings picture_;
    FlightCockpit cockpit_;
    Navigation navigation_;
    double flown_seconds_ = 0.0; ///< of the pilot's time
    int pictures_ = 0;
};

} // namespace

void fly_in_headset(const content::Scenario& scenario, const FlyOptions& options) {
    HeadsetFlight(scenario, options).run();
}

} // namespace engine
