#include "engine/picture_request.h"

#include "sim/bad_input.h"
#include "sim/look.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace engine {
namespace {

constexpr double julian_year_seconds = 31557600.0;
constexpr double largest_rapidity = 30.0; // what sim is tested to
constexpr int largest_samples_per_side = 64;
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
        exposure.automatic = *options.exposure == "auto";
        exposure.stops =
            exposure.automatic ? 0.0f : static_cast<float>(number_option("--exposure", *options.exposure, -60.0, 60.0));
    }
    return exposure;
}

void refuse_idle_options(const PictureOptions& options, const PictureRequest& request) {
    if (request.format == render::PictureFormat::png && request.frame.layer != render::Layer::light) {
        throw sim::BadInput("--layer", "", *options.layer, "layers are numbers: name an .exr for them");
    }
    if (request.format == render::PictureFormat::exr && (options.exposure || options.curve)) {
        throw sim::BadInput(options.exposure ? "--exposure" : "--curve", "",
                            options.exposure ? *options.exposure : *options.curve,
                            "only a .png is exposed; an .exr keeps the radiance");
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

PictureRequest picture_request(const PictureOptions& options) {
    PictureRequest request;
    request.file = options.output;
    request.format = render::picture_format(request.file);
    request.scenario = content::load_scenario(options.scenario);
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
    request.frame.metres_per_light_year = scenario.speed_of_light * julian_year_seconds;
    if (options.method) {
        request.method = named_option("--method", *options.method, method_names);
    }
    if (options.samples) {
        request.samples_per_side = whole_number_option("--samples", *options.samples, 1, largest_samples_per_side);
    }
    refuse_idle_options(options, request);
    return request;
}

render::PictureMetadata picture_metadata(const PictureRequest& request) {
    const bool traced = request.method == PictureMethod::reference;
    const bool cast = request.method == PictureMethod::ray;
    render::PictureMetadata metadata{
        {"scenario", request.scenario.name},
        {"method", name_of(request.method, method_names)},
        {"mode", name_of(request.frame.mode, mode_names)},
        {"layer", name_of(request.frame.layer, layer_names)},
        {"beta", std::tanh(request.rapidity.value)},
        {"rapidity", request.rapidity.value},
        {"heading", request.heading},
        {"look", request.look},
        {"event_time_seconds", request.time},
        {"event_position_metres", request.frame.eye.position},
        {"horizontal_field_of_view_degrees", glm::degrees(request.frame.eye.horizontal_field_of_view)},
        {"effects_exact", "aberration, light travel time (scenery at rest), Doppler factor, searchlight D^-4"},
        {"effects_approximate",
         fmt::format(
             "spectra: RGB as three smooth reflectances under a black body of {} K; lamps cast no shadows; light "
             "reflected once{}",
             request.scenario.light_temperature,
             traced ? ""
             : cast ? "; single precision; textures filtered over a pixel's footprint"
                    : "; sun's shadows from a shadow map; colour and sharpness at the tiles' resolution")},
    };
    if ((traced || cast) && request.frame.layer == render::Layer::light) {
        metadata["samples_per_pixel"] = static_cast<double>(request.samples_per_side * request.samples_per_side);
    }
    return metadata;
}

} // namespace engine
