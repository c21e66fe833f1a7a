#include "engine/commands/camera_options.h"
#include "engine/commands/commands.h"
#include "engine/commands/eye_options.h"

#include "content/scenario.h"
#include "engine/flight_file.h"
#include "engine/fly/course.h"
#include "engine/fly/headless.h"
#include "engine/fly/window_flight.h"
#include "engine/vr/headset_flight.h"
#include "input/bindings.h"
#include "input/xr_failure.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <fmt/core.h>
#include <memory>
#include <string>

namespace engine {
namespace {

struct FlyCommand {
    std::string scenario = "street";
    FlyOptions options;
    std::string seconds;
    std::string size;
    std::string eye_size;
    std::string frames_per_second;
    std::string method;
    std::string reflectance;
    std::optional<bool> microwave_background;
    CameraOptions camera;
    bool headless = false;
    bool controls = false;
    bool demo = false;
    std::string demo_idle;
    std::string vignette;
    std::string snap_turn;
    std::string brightest;
};

constexpr int least_eye_pixels = 64;

/// The table of controls in Markdown, for a terminal and for the README alike.
void print_controls() {
    std::string_view group;
    for (const input::Binding& binding : input::bindings()) {
        if (binding.group != group) {
            fmt::print("{}| {} | keyboard and mouse | gamepad |\n| --- | --- | --- |\n", group.empty() ? "" : "\n",
                       binding.group);
            group = binding.group;
        }
        fmt::print("| {} | {} | {} |\n", binding.what, input::desk_controls(binding),
                   input::control_name(binding.gamepad));
    }
}

void check_comfort(FlyCommand& command) {
    ComfortSettings& comfort = command.options.comfort;
    if (!command.vignette.empty()) {
        comfort.vignette = static_cast<float>(number_option("--vignette", command.vignette, 0.0, 1.0));
    }
    if (!command.snap_turn.empty()) {
        comfort.snap_turn = true;
        comfort.snap_degrees =
            static_cast<float>(number_option("--snap-turn", command.snap_turn, double{ComfortSettings::smallest_snap},
                                             double{ComfortSettings::largest_snap}));
    }
    if (!command.brightest.empty()) {
        comfort.brightest = static_cast<float>(
            number_option("--brightest", command.brightest, double{ComfortSettings::darkest_limit}, 1.0));
    }
}

void check_demo(FlyCommand& command) {
    constexpr double usual_idle_seconds = 60.0;
    constexpr double longest_idle_seconds = 86400.0;
    if (!command.demo_idle.empty() && !command.demo) {
        throw sim::BadInput("--demo-idle", "", command.demo_idle, "wants --demo, which it is for");
    }
    if (command.demo && (command.headless || !command.options.demonstration.empty())) {
        throw sim::BadInput("--demo", "", "", "needs a window, where somebody flies; --demonstration makes a film");
    }
    if (command.demo) {
        command.options.demo = command.demo_idle.empty()
                                   ? usual_idle_seconds
                                   : number_option("--demo-idle", command.demo_idle, 1.0, longest_idle_seconds);
    }
}

void check(FlyCommand& command) {
    check_comfort(command);
    check_demo(command);
    check_course(command.options, command.seconds);
    command.options.camera = camera_settings(command.camera);
    command.options.ghosts = command.camera.ghosts;
    if (!command.size.empty()) {
        command.options.size = size_option("--size", command.size);
    }
    if (!command.eye_size.empty()) {
        command.options.eye_size = size_option("--eye-size", command.eye_size);
        if (std::min(command.options.eye_size->width, command.options.eye_size->height) < least_eye_pixels) {
            throw sim::BadInput("--eye-size", "", command.eye_size,
                                fmt::format("an eye's picture has at least {0}x{0} pixels", least_eye_pixels));
        }
    }
    if (!command.method.empty()) {
        command.options.method = named_option("--method", command.method, live_method_names);
    }
    if (!command.frames_per_second.empty()) {
        command.options.frames_per_second = number_option("--fps", command.frames_per_second, 1.0, 240.0);
    }
}

/// False, after saying why, where there is no headset.
bool flown_in_headset(const content::Scenario& scenario, const FlyOptions& options) {
    try {
        fly_in_headset(scenario, options);
        return true;
    } catch (const input::XrFailure& failure) {
        fmt::print("no headset here ({}): flying headless\n", failure.what());
        return false;
    }
}

void fly(FlyCommand command) {
    if (command.controls) {
        print_controls();
        return;
    }
    check(command);
    content::Scenario scenario = content::load_scenario(command.scenario);
    if (!command.reflectance.empty()) {
        scenario.reflectance_model = named_option("--reflectance", command.reflectance, reflectance_names);
    }
    scenario.microwave_background = command.microwave_background.value_or(scenario.microwave_background);
    if (!command.headless && command.options.demonstration.empty()) {
        try {
            WindowFlight(scenario, command.options).run();
            return;
        } catch (const NoDisplay& error) {
            fmt::print("no window here ({}): flying headless\n", error.what());
        }
        if (command.options.script.empty()) {
            command.options.demonstration = flights_folder();
        }
    }
    if (command.options.vr && flown_in_headset(scenario, command.options)) {
        return;
    }
    fly_headless(scenario, command.options);
}

} // namespace

void add_fly_command(CLI::App& application) {
    const auto command = std::make_shared<FlyCommand>();
    FlyOptions& options = command->options;
    CLI::App* fly_command = application.add_subcommand("fly", "fly a scenario, in a window or headless");
    fly_command->group("Fly");
    fly_command->add_option("scenario", command->scenario, "name, .toml or bare .glb/.gltf (default street)");
    fly_command->add_flag("--headless", command->headless, "without a window: a script flies");
    fly_command->add_option("--script", options.script,
                            "flight script (CSV): duration,ax,ay,az,wx,wy,wz; headless default: the demonstration");
    fly_command->add_option("--to", options.to, "the autopilot flies there: a beacon or a star, by name or HIP number");
    fly_command->add_option("--record", options.recording, "recording to write (default: a new one in flights/)");
    fly_command->add_option("--seconds", command->seconds, "end after this many seconds of the pilot's time");
    fly_command->add_flag("--realtime", options.real_time, "headless: as slowly as a pilot would fly it");
    fly_command->add_option("--film", options.film, "headless: film to make (mp4, needs ffmpeg)");
    fly_command->add_option("--stills", options.stills, "headless: folder for eight stills, evenly over the flight");
    fly_command->add_option("--demonstration", options.demonstration,
                            "headless: folder for recording, film and stills");
    fly_command->add_option("--size", command->size, "WxH of film and stills, or of the window (default 1280x720)");
    fly_command->add_option("--fps", command->frames_per_second, "pictures a second of the film (default 30)");
    fly_command->add_flag("!--no-instruments", options.instruments, "film without the instruments");
    fly_command->add_option("--method", command->method,
                            "how pictures are drawn: automatic, texture or ray (automatic: ray without a GPU)");
    fly_command->add_option("--reflectance", command->reflectance,
                            "spectra of RGB reflectances: five-terms, three-primaries or dominant-wavelength");
    add_microwave_options(*fly_command, command->microwave_background);
    fly_command->add_flag("--cockpit", options.cockpit, "sit in the cabin, lit by what is seen around it (Enter)");
    fly_command->add_option("--vignette", command->vignette, "narrow the view in turns: 0 (not at all) to 1");
    fly_command->add_option("--snap-turn", command->snap_turn, "turn by steps of so many degrees, 5 to 90");
    fly_command->add_option("--brightest", command->brightest,
                            "largest share of the display's light, 0.1 to 1 (1): against the searchlight");
    fly_command->add_flag("--steady-horizon", options.comfort.steady_horizon,
                          "seat, hands and view stay level while the ship rolls");
    fly_command->add_flag("--demo", command->demo,
                          "for visitors: menus locked, a new flight from the start when nobody touches anything");
    fly_command->add_option("--demo-idle", command->demo_idle, "seconds without a touch until then (60)");
    fly_command->add_flag("--vr", options.vr, "in a headset through OpenXR; the window mirrors its left eye");
    fly_command->add_option("--eye-size", command->eye_size,
                            "headset: WxH of an eye's picture (default: what the headset recommends)");
    fly_command->add_flag("--stage", options.stage, "headset: stand on the floor of your room (default: sit)");
    add_camera_options(*fly_command, command->camera);
    fly_command->add_flag("--controls", command->controls, "print the table of controls");
    fly_command->callback([command] { fly(*command); });
}

} // namespace engine
