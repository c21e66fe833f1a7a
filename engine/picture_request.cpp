#include "engine/picture_request.h"

#include "engine/picture_maker.h"
#include "sim/bad_input.h"
#include "sim/look.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/trigonometric.hpp>
#include <utility>

namespace engine {
namespace {

constexpr double largest_rapidity = 30.0; // what sim is tested to
constexpr int largest_samples_per_side = 64;
constexpr double largest_bloom = 0.9;
constexpr NamedValues<bool, 2> curve_names{{{"linear", true}, {"filmic", false}}};

sim::Rapidity rapidity_of(const PictureOptions& options, const content::Scenario& scenario) {
    if (options.beta && options.rapidity) {
        throw sim::BadInput("--rapidity", "", *options.rapidity, "give either --beta or --rapidity, not both");
    }
    if (options.rapidity) {
        return sim::Rapidity(number_option("--rapidity", *options.rapidity, 0.0, largest_rapidity));
    }
    const double beta = options.beta ? number_option("--beta", *options.beta) : scenario.start_beta;
    if (beta < 0.0 || beta >= 1.0) {
        throw sim::BadInput("--beta", "", *options.beta, "must be at least 0 and less than 1 (the speed of light)");
    }
    return sim::Rapidity(std::atanh(beta));
}

double field_of_view(const PictureOptions& options, const content::Scenario& scenario) {
    if (!options.field_of_view) {
        return scenario.horizontal_field_of_view;
    }
    const double degrees = number_option("--fov", *options.field_of_view);
    if (degrees <= 0.0 || degrees >= 180.0) {
        throw sim::BadInput("--fov", "", *options.field_of_view, "must be more than 0 and less than 180 degrees");
    }
    return glm::radians(degrees);
}

render::Exposure exposure(const PictureOptions& options, const content::Scenario& scenario) {
    render::Exposure exposure;
    exposure.automatic = scenario.exposure.automatic;
    exposure.stops = static_cast<float>(scenario.exposure.stops);
    exposure.linear_curve = options.curve && named_option("--curve", *options.curve, curve_names);
    if (options.exposure) {
        const render::Exposure typed = exposure_option("--exposure", *options.exposure);
        exposure.automatic = typed.automatic;
        exposure.stops = typed.stops;
    }
    return exposure;
}

std::vector<std::string> words_between_commas(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == ',') {
            words.emplace_back();
        } else {
            words.back() += c;
        }
    }
    return words;
}

/// A pane by the name of a mode or of a view, in the picture's own mode.
Pane named_pane(const std::string& name, render::Mode mode) {
    for (const auto& [known, value] : mode_names) {
        if (known == name) {
            return {value, render::View::natural};
        }
    }
    for (const auto& [known, value] : view_names) {
        if (known == name) {
            return {mode, value};
        }
    }
    if (name == "D") { // "doppler" is the mode
        return {mode, render::View::doppler};
    }
    refuse_name("--split", name, {"geometry", "doppler", "searchlight", "full", "D", "rings", "luminance"});
}

std::vector<Pane> panes(const PictureOptions& options, const render::RenderFrame& frame) {
    if (!options.split) {
        return {{frame.mode, frame.display.view}};
    }
    const std::vector<std::string> names = words_between_commas(*options.split);
    if (names.size() < 2 || names.size() > most_panes) {
        throw sim::BadInput("--split", "", *options.split, "wants two to four panes, for example geometry,full,rings");
    }
    std::vector<Pane> panes;
    for (const std::string& name : names) {
        panes.push_back(named_pane(name, frame.mode));
    }
    return panes;
}

render::Display display(const PictureOptions& options) {
    render::Display display;
    display.view = options.view ? named_option("--view", *options.view, view_names) : render::View::natural;
    display.iso_lines = options.iso_lines;
    display.bloom =
        options.bloom ? static_cast<float>(number_option("--bloom", *options.bloom, 0.0, largest_bloom)) : 0.0f;
    display.dither = !options.no_dither;
    return display;
}

/// What only pictures for display have, as typed; "" when there is none.
std::pair<std::string, std::string> display_option(const PictureOptions& options) {
    for (const auto& [name, value] : {std::pair("--exposure", options.exposure),
                                      {"--curve", options.curve},
                                      {"--view", options.view},
                                      {"--split", options.split},
                                      {"--bloom", options.bloom}}) {
        if (value) {
            return {name, *value};
        }
    }
    return {options.iso_lines   ? "--iso-lines"
            : options.no_dither ? "--no-dither"
            : options.no_legend ? "--no-legend"
            : options.cockpit   ? "--cockpit"
                                : "",
            ""};
}

void refuse_idle_options(const PictureOptions& options, const PictureRequest& request) {
    if (request.format == render::PictureFormat::png && request.frame.layer != render::Layer::light) {
        throw sim::BadInput("--layer", "", *options.layer, "layers are numbers: name an .exr for them");
    }
    const auto [option, typed] = display_option(options);
    if (request.format == render::PictureFormat::exr && !option.empty()) {
        throw sim::BadInput(option, "", typed, "only a .png is made for a display; an .exr keeps the radiance");
    }
    if (options.primaries && request.frame.layer != render::Layer::light) {
        throw sim::BadInput("--primaries", "", *options.primaries, "only light has colours; this layer is numbers");
    }
    if (options.view && options.split) {
        throw sim::BadInput("--view", "", *options.view, "give either --view or --split, whose panes may be views");
    }
    if (options.cockpit && options.split) {
        throw sim::BadInput("--cockpit", "", "", "one cabin has one view: give either --cockpit or --split");
    }
    if (options.cockpit && request.primaries != render::Primaries::srgb) {
        throw sim::BadInput("--primaries", "", *options.primaries, "the cabin of --cockpit is drawn in sRGB");
    }
    if (options.samples && ((request.method != PictureMethod::reference && request.method != PictureMethod::ray) ||
                            request.frame.layer != render::Layer::light)) {
        throw sim::BadInput("--samples", "", *options.samples,
                            "only --method ray and reference average samples of light");
    }
    if (request.method == PictureMethod::plain && request.rapidity.value > 0.0) {
        throw sim::BadInput("--method", "", *options.method, "shows an eye at rest only; texture shows a moving one");
    }
}

} // namespace

render::Exposure exposure_option(const std::string& option, const std::string& text) {
    render::Exposure exposure;
    exposure.automatic = text == "auto";
    exposure.stops = exposure.automatic ? 0.0f : static_cast<float>(number_option(option, text, -60.0, 60.0));
    return exposure;
}

PictureRequest picture_request(const PictureOptions& options) {
    PictureRequest request;
    request.file = options.output;
    if (!options.output.empty()) {
        request.format = render::picture_format(request.file);
    }
    request.scenario = content::load_scenario(options.scenario);
    if (options.reflectance) {
        request.scenario.reflectance_model = named_option("--reflectance", *options.reflectance, reflectance_names);
    }
    request.scenario.microwave_background =
        options.microwave_background.value_or(request.scenario.microwave_background);
    const content::Scenario& scenario = request.scenario;

    request.rapidity = rapidity_of(options, scenario);
    request.heading = options.heading ? direction_option("--heading", *options.heading) : scenario.start_heading;
    request.look = options.look ? direction_option("--look", *options.look) : scenario.start_look;
    render::EyeView& eye = request.frame.eye;
    eye.position = scenario.start_position;
    if (options.at) {
        const std::vector<double> event = numbers_option("--at", *options.at, 4);
        request.time = event[0];
        eye.position = {event[1], event[2], event[3]};
    }
    eye.world_from_head = sim::world_from_looking<sim::Head>(request.rapidity, request.heading, request.look);
    eye.horizontal_field_of_view = field_of_view(options, scenario);
    const PictureSize size = options.size ? size_option("--size", *options.size) : PictureSize{};
    eye.width = size.width;
    eye.height = size.height;

    request.frame.mode = options.mode ? named_option("--mode", *options.mode, mode_names) : render::Mode::full;
    request.frame.layer = options.layer ? named_option("--layer", *options.layer, layer_names) : render::Layer::light;
    request.frame.exposure = exposure(options, scenario);
    request.frame.sharpness = still_sharpness;
    request.frame.display = display(options);
    request.panes = panes(options, request.frame);
    request.legend = !options.no_legend;
    request.cockpit = options.cockpit;
    if (options.primaries) {
        request.primaries = named_option("--primaries", *options.primaries, primaries_names);
    }
    request.frame.metres_per_light_year = scenario.speed_of_light * content::julian_year_seconds;
    if (options.method) {
        request.method = named_option("--method", *options.method, method_names);
    }
    if (options.samples) {
        request.samples_per_side = whole_number_option("--samples", *options.samples, 1, largest_samples_per_side);
    }
    if (options.samples && request.method == PictureMethod::automatic) {
        request.method = chosen_method(request.method); // whether they are idle depends on it
    }
    refuse_idle_options(options, request);
    return request;
}

void add_eye_metadata(render::PictureMetadata& metadata, const render::RenderFrame& frame) {
    const render::EyeView& eye = frame.eye;
    const sim::BoostAndRotation split = sim::split(eye.world_from_head);
    const double beta = std::tanh(split.xi.value);
    metadata["mode"] = name_of(frame.mode, mode_names);
    metadata["beta"] = beta;
    metadata["rapidity"] = split.xi.value;
    metadata["heading"] = split.along;
    metadata["velocity_c"] = beta * split.along;
    metadata["look"] = split.boosted_from_head * glm::dvec3(0.0, 0.0, -1.0);
    metadata["event_position_metres"] = eye.position;
    metadata["horizontal_field_of_view_degrees"] = glm::degrees(eye.horizontal_field_of_view);
    metadata["effects_exact"] = std::string(exact_effects);
}

void add_display_metadata(render::PictureMetadata& metadata, const render::RenderFrame& frame,
                          const std::vector<Pane>& panes) {
    metadata["curve"] = name_of(frame.exposure.linear_curve, curve_names);
    metadata["bloom"] = static_cast<double>(frame.display.bloom);
    metadata["view"] = name_of(frame.display.view, view_names);
    std::string names;
    for (const Pane& pane : panes) {
        names += (names.empty() ? "" : ", ") + pane_name(pane);
    }
    if (panes.size() > 1) {
        metadata["panes"] = names;
    }
}

render::PictureMetadata picture_metadata(const PictureRequest& request) {
    const bool traced = request.method == PictureMethod::reference;
    const bool cast = request.method == PictureMethod::ray;
    render::PictureMetadata metadata;
    add_eye_metadata(metadata, request.frame);
    const render::PictureMetadata further{
        {"scenario", request.scenario.name},
        {"method", name_of(request.method, method_names)},
        {"layer", name_of(request.frame.layer, layer_names)},
        {"rapidity", request.rapidity.value}, // as asked for, to the last digit
        {"heading", request.heading},
        {"look", request.look},
        {"event_time_seconds", request.time},
        {"primaries", name_of(request.primaries, primaries_names)},
        {"effects_approximate",
         fmt::format("spectra: RGB reflectances as {} under a black body of {} K; light reflected once{}",
                     content::reflectance_model_names.at(static_cast<std::size_t>(request.scenario.reflectance_model)),
                     request.scenario.light_temperature,
                     traced ? ""
                     : cast ? "; single precision; textures filtered over a pixel's footprint"
                            : "; shadows from shadow maps; colour and sharpness at the tiles' resolution")},
    };
    for (const auto& [name, value] : further) {
        metadata[name] = value;
    }
    if (request.format == render::PictureFormat::png) {
        add_display_metadata(metadata, request.frame, request.panes);
    }
    if ((traced || cast) && request.frame.layer == render::Layer::light) {
        metadata["samples_per_pixel"] = static_cast<double>(request.samples_per_side * request.samples_per_side);
    }
    return metadata;
}

} // namespace engine
