#include "engine/fly/window_flight.h"

#include "content/flight_script.h"
#include "engine/flight_file.h"
#include "engine/fly/flight_metadata.h"
#include "engine/fly/flight_summary.h"
#include "engine/fly/hud_reading.h"
#include "engine/fly/loaded_scene.h"
#include "engine/fly/picture_keys.h"
#include "engine/hud/instruments.h"
#include "engine/offscreen.h"
#include "engine/panes.h"
#include "input/script_pilot.h"
#include "render/picture_file.h"
#include "sim/bad_input.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/core.h>
#include <thread>

namespace engine {
namespace {

using Clock = std::chrono::steady_clock;

/// Dynamic resolution aims at 30 frames a second with a little to spare for the window system.
constexpr double frame_budget_seconds = 0.030;

/// Faster than this nobody sees; a window without vertical sync would burn a processor for it.
constexpr std::chrono::duration<double> shortest_frame{1.0 / 60.0};

constexpr double largest_relative_pace = 64.0;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

/// Pixels per point on the cockpit's screens: half as many again as on the window, so that they stay crisp from near.
float cockpit_scale(const Window& window) {
    return 1.5F * window.content_scale();
}

std::unique_ptr<input::Pilot> script_pilot(const content::Scenario& scenario, const FlyOptions& options) {
    if (options.script.empty()) {
        return nullptr;
    }
    return std::make_unique<input::ScriptPilot>(content::load_flight_script(options.script),
                                                scenario.vehicle.tick_rate);
}

} // namespace

WindowFlight::WindowFlight(const content::Scenario& scenario, const FlyOptions& options)
    : scenario_(scenario), options_(options),
      window_("Rapidity: " + scenario.title, options.size.width, options.size.height),
      imgui_(window_.handle(), window_.content_scale()), renderer_(loaded_scene(scenario), {options.method}),
      navigation_(scenario), cameras_(scenario, options.camera, other_ships(scenario, options.ghosts)),
      hands_(scenario.vehicle), clock_(scenario.vehicle.tick_rate), picture_(starting_picture(scenario)),
      cockpit_(options.comfort, options.cockpit, cockpit_scale(window_)), resolution_(frame_budget_seconds) {
    clock_.set_pace(scenario.pace);
    hands_.set_seconds_per_tick(1.0 / (scenario.pace * scenario.vehicle.tick_rate));
    begin_flight(options.recording);
    if (options.demo) {
        idle_.emplace(*options.demo);
    }
    if (options.vr) {
        find_headset();
    }
    notices_.show("F1 or H: help", 8.0);
}

void WindowFlight::begin_flight(const std::filesystem::path& recording) {
    if (!options_.replay.empty()) {
        begin_replay();
    } else {
        recorded_.emplace(scenario_, recording.empty() ? new_flight_file(scenario_.name) : recording);
        recorded_->flight().keep_world_line();
        script_ = script_pilot(scenario_, options_);
    }
    Flight& flight = recorded_->flight();
    navigation_ = Navigation(scenario_);
    if (!options_.to.empty() && !is_replay()) {
        const content::Destination there = content::find_destination(navigation_.destinations(), "--to", options_.to);
        flight.set_target(there.object, there.name);
        hands_.switch_on(sim::ControlFrame::autopilot);
    }
    hands_.set_vehicle(flight.vehicle());
    hands_.set_metres_per_light_unit(flight.metres_per_light_unit());
    fraction_ = 0.0;
    left_out_seconds_ = 0.0;
    screenshots_ = 0;
    bookmarks_ = 0;
}

void WindowFlight::end_flight() {
    if (is_replay()) {
        return;
    }
    print_flight(scenario_, recorded_->flight());
    if (const std::string& stop = recorded_->flight().stop(); !stop.empty()) {
        fmt::print("{}\n", stop);
    }
    if (left_out_seconds_ > 0.0) {
        fmt::print("slow frames left out {:.1f} s of the pilot's time\n", left_out_seconds_);
    }
    const std::string trouble = recorded_->close();
    fmt::print("{}\n", trouble.empty() ? fmt::format("recording: {}", recorded_->file().string()) : trouble);
}

void WindowFlight::run() {
    const Clock::time_point start = Clock::now();
    Clock::time_point last = start;
    while (!window_.closing()) {
        const Clock::time_point now = Clock::now();
        double elapsed = seconds_between(last, now);
        last = now;
        window_.poll(imgui_.wants_keyboard(), imgui_.wants_mouse() || cockpit_.hears_pointer());
        input::DeviceState devices = window_.devices();
        if (begin_headset_frame()) {
            elapsed = headset_frame_->elapsed_seconds;
            hear_headset(devices);
        }
        attend(devices, elapsed);
        const std::vector<input::Action> presses = presses_.presses(devices);
        for (const input::Action action : presses) {
            handle(action);
        }
        const double zoom = std::exp(-0.08 * devices.mouse.wheel);
        picture_.horizontal_field_of_view = std::clamp(picture_.horizontal_field_of_view * zoom, 0.17, 2.6);
        hands_.sample(devices, presses, elapsed);
        fly(elapsed);
        move_camera(elapsed);
        frame_seconds_ = frame_seconds_ == 0.0 ? elapsed : 0.9 * frame_seconds_ + 0.1 * elapsed;
        if (headset_frame_) {
            show_in_headset(elapsed);
        }
        draw(elapsed);
        if (options_.seconds && seconds_between(start, Clock::now()) >= *options_.seconds) {
            window_.close();
        }
        if (!headset_frame_) {
            std::this_thread::sleep_until(now + std::chrono::duration_cast<Clock::duration>(shortest_frame));
        }
    }
    if (headset_) {
        headset_->close();
    }
    print_pictures(seconds_between(start, Clock::now()));
    end_flight();
}

void WindowFlight::print_pictures(double seconds) const {
    if (pictures_ > 0) {
        fmt::print("{} pictures, {:.1f} a second, drawn at {:.0f} % of the window's width on average\n", pictures_,
                   pictures_ / seconds, 100.0 * resolution_scales_ / pictures_);
    }
}

void WindowFlight::fly(double elapsed_seconds) {
    if (is_replay()) {
        play(elapsed_seconds);
        return;
    }
    const FixedStep::Steps steps = clock_.advance(elapsed_seconds);
    if (steps.dropped_seconds > 0.0 && !clock_.paused()) {
        left_out_seconds_ += steps.dropped_seconds;
        notices_.show("slow frames: time is left out of the flight");
    }
    Flight& flight = recorded_->flight();
    std::optional<HeadsetTicks> headset;
    if (headset_frame_) {
        headset.emplace(*headset_, room_scale(), steps, 1.0 / (clock_.pace() * flight.vehicle().tick_rate));
    }
    const auto tick = [&](input::Pilot& pilot) { return headset ? headset->tick(flight, pilot) : flight.tick(pilot); };
    for (sim::Tick i = 0; i < steps.ticks && flight.stop().empty(); ++i) {
        if (script_ && !tick(*script_) && flight.stop().empty()) {
            script_.reset();
            notices_.show("the script has ended: you fly");
        }
        if (!script_) {
            tick(hands_);
        }
    }
    if (!flight.stop().empty()) {
        notices_.show(flight.stop() + "; Backspace: a new flight");
    }
    fraction_ = steps.fraction;
    hear_autopilot();
}

void WindowFlight::handle(input::Action action) {
    if (options_.demo && is_locked_in_demo(action)) {
        notices_.show("a demonstration: menus are locked");
        return;
    }
    switch (action) {
    case input::Action::help:
        show_help_ = !show_help_;
        break;
    case input::Action::panel:
        show_panel_ = !show_panel_;
        break;
    case input::Action::hud:
        show_instruments_ = !show_instruments_;
        break;
    case input::Action::cockpit:
        cockpit_.show(!cockpit_.shown());
        break;
    case input::Action::steady_horizon:
        cockpit_.comfort().steady_horizon = !cockpit_.comfort().steady_horizon;
        break;
    case input::Action::recentre:
        recentre();
        break;
    case input::Action::screenshot:
        screenshot_wanted_ = true;
        break;
    case input::Action::probe:
        switch_probe();
        break;
    case input::Action::full_screen:
        window_.toggle_full_screen();
        break;
    case input::Action::quit:
        window_.close();
        break;
    default:
        change_picture(action, picture_);
        if (is_replay()) {
            handle_replay(action);
        } else {
            handle_time(action);
        }
        handle_voyage(action);
        handle_camera(action);
    }
}

void WindowFlight::handle_time(input::Action action) {
    switch (action) {
    case input::Action::pause:
        clock_.set_paused(!clock_.paused());
        break;
    case input::Action::single_tick:
        clock_.request_single_tick();
        break;
    case input::Action::slower:
        change_pace(0.5);
        break;
    case input::Action::faster:
        change_pace(2.0);
        break;
    case input::Action::reset:
        end_flight();
        begin_flight({});
        notices_.show("a new flight");
        break;
    case input::Action::bookmark:
        recorded_->flight().bookmark(fmt::format("{}", ++bookmarks_));
        notices_.show(fmt::format("bookmark {}", bookmarks_));
        break;
    default:
        break;
    }
}

void WindowFlight::change_pace(double factor) {
    const double relative =
        std::clamp(clock_.pace() / scenario_.pace * factor, 1.0 / largest_relative_pace, largest_relative_pace);
    clock_.set_pace(relative * scenario_.pace);
    hands_.set_seconds_per_tick(1.0 / (clock_.pace() * scenario_.vehicle.tick_rate));
}

void WindowFlight::draw(double elapsed_seconds) {
    const Window::Size size = window_.framebuffer_size();
    if (size.width == 0 || size.height == 0) {
        return;
    }
    const Flight& flight = recorded_->flight();
    const sim::VehicleState moment = flight.between(fraction_);
    sit(moment, elapsed_seconds);
    const glm::dquat head = look();

    const Clock::time_point start = Clock::now();
    const auto scaled = [this](int pixels) {
        return std::max(1, static_cast<int>(std::lround(resolution_.scale() * pixels)));
    };
    picture_.width = scaled(size.width);
    picture_.height = scaled(size.height);
    render::RenderFrame whole = build_frame(flight, moment, head, picture_, elapsed_seconds);
    if (is_mirror()) {
        whole = draw_mirror(whole, size);
    } else {
        cameras_.apply(flight, moment, hands_.vehicle_from_head(), whole);
        draw_panes(whole, size);
        draw_cockpit(moment, head, whole, size);
    }
    imgui_.begin(size.width, size.height, elapsed_seconds);
    draw_hud(moment, head, whole, elapsed_seconds);
    imgui_.end(0, size.width, size.height);
    glFinish(); // what the frame costs, before the wait for the screen
    ++pictures_;
    resolution_scales_ += resolution_.scale();
    resolution_.update(seconds_between(start, Clock::now()));
    if (screenshot_wanted_) {
        save_screenshot(moment, whole);
    }
    window_.swap();
}

void WindowFlight::draw_panes(const render::RenderFrame& whole, const Window::Size& size) {
    const std::vector<Pane> panes = panes_of(picture_);
    const std::vector<PaneArea> sources = pane_areas(panes.size(), picture_.width, picture_.height);
    const std::vector<PaneArea> targets = pane_areas(panes.size(), size.width, size.height);
    exposures_used_.clear();
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const PaneArea& to = targets[i];
        const render::FrameStatistics statistics =
            renderer_.draw(pane_frame(whole, panes[i], i, sources[i]), 0,
                           {to.left, size.height - to.top - to.height, to.width, to.height});
        exposures_used_.push_back(statistics.exposure_stops);
    }
}

void WindowFlight::draw_hud(const sim::VehicleState& moment, const glm::dquat& head, const render::RenderFrame& whole,
                            double elapsed_seconds) {
    notices_.advance(elapsed_seconds);
    if (show_instruments_) {
        HudModel model = read_instruments(scenario_, recorded_->flight(), moment, head, picture_, navigation_);
        for (std::size_t i = 0; i < model.panes.size(); ++i) {
            model.panes[i].exposure_stops_used = exposures_used_[i];
        }
        add_cameras(cameras_, recorded_->flight(), moment, whole, model);
        model.frame_seconds = frame_seconds_;
        model.resolution_scale = resolution_.scale();
        model.relative_pace = is_replay() ? 1.0 : clock_.pace() / scenario_.pace; // the timeline says a replay's
        model.paused = !is_replay() && clock_.paused();
        model.notices = notices_.lines();
        model.cockpit = cockpit_.shown() && seen_from_the_seat();
        say_demo(model);
        if (probe_) {
            const Window::Point at = window_.cursor();
            const Window::Size size = window_.framebuffer_size();
            model.probe = probe_->at(whole, panes_of(picture_), {at.x, at.y}, size.width, size.height);
        }
        model.above_readouts = is_replay() ? TimelineStrip::height : 0.0F;
        draw_instruments(model, imgui_);
        if (is_replay()) {
            draw_timeline();
        }
    }
    if (show_panel_) {
        draw_panel();
        draw_voyage_panel();
    }
    if (show_help_) {
        draw_help(imgui_);
    }
}

void WindowFlight::save_screenshot(const sim::VehicleState& moment, const render::RenderFrame& whole) {
    screenshot_wanted_ = false;
    const Window::Size size = window_.framebuffer_size();
    std::filesystem::path file = recorded_->file();
    file.replace_filename(fmt::format("{}-{}.png", file.stem().string(), ++screenshots_));
    render::PictureMetadata metadata =
        flight_metadata(scenario_, recorded_->flight(), moment, whole, panes_of(picture_), exposures_used_.front());
    metadata["recording"] = recorded_->file().stem().string();
    metadata["method"] = drawn_method_name(renderer_.statistics().method);
    try {
        render::write_png(file, read_pixels(0, size.width, size.height), metadata);
        fmt::print("screenshot: {}\n", file.string());
        notices_.show(fmt::format("screenshot: {}", file.string()));
    } catch (const sim::BadInput& error) {
        notices_.show(error.what(), 8.0);
    }
}

} // namespace engine
