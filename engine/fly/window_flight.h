#pragma once

#include "content/scenario.h"
#include "engine/cameras/cameras.h"
#include "engine/dynamic_resolution.h"
#include "engine/fixed_step.h"
#include "engine/fly/flight_cockpit.h"
#include "engine/fly/fly_options.h"
#include "engine/fly/idle_watch.h"
#include "engine/fly/live_probe.h"
#include "engine/fly/recorded_flight.h"
#include "engine/frame_builder.h"
#include "engine/hud/imgui_layer.h"
#include "engine/hud/notices.h"
#include "engine/hud/panel.h"
#include "engine/hud/timeline_strip.h"
#include "engine/hud/voyage_panel.h"
#include "engine/navigation.h"
#include "engine/replay_deck.h"
#include "engine/vr/headset_ticks.h"
#include "engine/window.h"
#include "input/device_pilot.h"
#include "input/press_detector.h"
#include "render/gl/renderer.h"

#include <memory>
#include <optional>
#include <vector>

namespace engine {

/// A flight in a window: the loop of devices, ticks, picture and instruments.
class WindowFlight {
  public:
    /// Throws NoDisplay where no window can be opened, sim::BadInput for what cannot be loaded.
    WindowFlight(const content::Scenario& scenario, const FlyOptions& options);

    /// Flies until the pilot quits, then prints where the recording is.
    void run();

  private:
    bool is_replay() const { return deck_.has_value(); }
    void begin_flight(const std::filesystem::path& recording);
    void end_flight();
    void handle(input::Action action);
    void handle_time(input::Action action);
    void handle_voyage(input::Action action);
    void handle_camera(input::Action action);
    void move_camera(double elapsed_seconds);
    glm::dquat look() const;
    void change_pace(double factor);
    void print_pictures(double seconds) const;
    void hear_autopilot();
    void draw_voyage_panel();
    void begin_replay();
    void handle_replay(input::Action action);
    void keep_mark();
    void take_over();
    void play(double elapsed_seconds);
    void draw_timeline();
    void find_headset();
    bool begin_headset_frame();
    void hear_headset(input::DeviceState& devices);
    void show_headset_notes();
    void show_in_headset(double elapsed_seconds);
    bool is_mirror() const;
    input::RoomScale room_scale() const;
    render::RenderFrame draw_mirror(const render::RenderFrame& whole, const Window::Size& size);
    void fly(double elapsed_seconds);
    void draw(double elapsed_seconds);
    void draw_panes(const render::RenderFrame& whole, const Window::Size& size);
    void draw_hud(const sim::VehicleState& moment, const glm::dquat& head, const render::RenderFrame& whole,
                  double elapsed_seconds);
    void draw_panel();
    void attend(const input::DeviceState& devices, double elapsed_seconds);
    void sit(const sim::VehicleState& moment, double elapsed_seconds);
    void recentre();
    std::optional<PointerRay> hand(const glm::dquat& head, const render::EyeView& eye) const;
    void draw_screens(const sim::VehicleState& moment, const glm::dquat& head, const std::optional<PointerRay>& hand,
                      bool pressed, double elapsed_seconds);
    bool seen_from_the_seat() const;
    void draw_cockpit(const sim::VehicleState& moment, const glm::dquat& head, const render::RenderFrame& whole,
                      const Window::Size& size);
    void say_demo(HudModel& model) const;
    float demo_fade() const;
    void return_to_start();
    void switch_probe();
    void save_screenshot(const sim::VehicleState& moment, const render::RenderFrame& whole);

    content::Scenario scenario_;
    FlyOptions options_;
    Window window_;
    ImguiLayer imgui_;
    render::Renderer renderer_;
    Navigation navigation_;
    Cameras cameras_;

    std::optional<RecordedFlight> recorded_;
    std::unique_ptr<input::Pilot> script_; ///< flies first; none, or at its end: the pilot's hands fly
    std::optional<ReplayDeck> deck_;       ///< a replay: what is shown
    std::optional<TimelineStrip> timeline_;
    input::DevicePilot hands_;
    input::PressDetector presses_;
    FixedStep clock_;
    double fraction_ = 0.0; ///< where the picture stands between the last two ticks

    std::optional<Headset> headset_; ///< none: not asked for, or none when the flight began
    std::optional<HeadsetFrame> headset_frame_;

    double left_out_seconds_ = 0.0; ///< of the pilot's time, in this flight

    PictureSettings picture_;
    std::vector<double> exposures_used_; ///< stops, by pane
    std::optional<LiveProbe> probe_;
    FlightCockpit cockpit_;
    std::optional<IdleWatch> idle_; ///< of a demonstration
    bool touched_ = false;          ///< in this flight, by whoever tries the demonstration
    Window::Point last_cursor_;
    double screens_age_ = 1.0; ///< seconds since the cockpit's screens were drawn
    DynamicResolution resolution_;
    double frame_seconds_ = 0.0; ///< smoothed time between frames
    int pictures_ = 0;
    double resolution_scales_ = 0.0; ///< sum over the pictures
    bool show_instruments_ = true;
    bool show_help_ = false;
    bool show_panel_ = false;
    bool screenshot_wanted_ = false;
    int screenshots_ = 0;
    int bookmarks_ = 0;
    Panel panel_;
    VoyagePanel voyage_panel_;
    Notices notices_;
};

} // namespace engine
