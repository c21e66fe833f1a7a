#include "engine/trace/trace_request.h"

#include "content/file_bytes.h"
#include "content/number.h"
#include "engine/checksum.h"
#include "engine/option_values.h"
#include "engine/trace/recorded_camera.h"
#include "sim/bad_input.h"

#include <glm/trigonometric.hpp>

#include <cmath>
#include <fmt/format.h>
#include <system_error>
#include <tbb/task_arena.h>

namespace engine {
namespace {

constexpr int most_samples_per_side = 16;
constexpr int most_frames = 1000000;
constexpr NamedValues<content::Projection, 3> projection_names{
    {{"perspective", content::Projection::perspective},
     {"fisheye", content::Projection::fisheye},
     {"equirectangular", content::Projection::equirectangular}}};
constexpr NamedValues<bool, 2> curve_names{{{"linear", true}, {"filmic", false}}};

void set_parameters(content::TracedScenario& scenario, const std::vector<std::string>& parameters) {
    for (const std::string& parameter : parameters) {
        const std::size_t equals = parameter.find('=');
        const std::optional<double> value =
            equals == std::string::npos ? std::nullopt : content::finite_number(parameter.substr(equals + 1));
        if (!value || equals == 0) {
            throw sim::BadInput("--param", "", parameter, "must be NAME=NUMBER, as spin=0.5");
        }
        scenario.spacetime.parameters[parameter.substr(0, equals)] = *value;
    }
}

void set_camera(content::TracedScenario& scenario, const TraceOptions& options) {
    content::TracedCamera& camera = scenario.camera;
    if (options.projection) {
        camera.projection = named_option("--projection", *options.projection, projection_names);
    }
    if (options.field_of_view) {
        const double widest = camera.projection == content::Projection::perspective ? 179.0 : 360.0;
        camera.field_of_view = glm::radians(number_option("--fov", *options.field_of_view, 1e-6, widest));
    }
    if (options.position) {
        const std::vector<double> place = numbers_option("--position", *options.position, 3);
        camera.moment.position = {place[0], place[1], place[2]};
        camera.path.clear();
    }
    if (options.look) {
        camera.moment.look = direction_option("--look", *options.look);
        camera.path.clear();
    }
}

/// Frame numbers stand for #### in a sequence's name.
std::size_t hashes(const std::string& name) {
    const std::size_t begin = name.find('#');
    return begin == std::string::npos ? 0 : name.find_first_not_of('#', begin) - begin;
}

std::vector<render::CameraPose> camera_frames(const TraceOptions& options, const content::TracedScenario& scenario) {
    const int frames = options.frames ? whole_number_option("--frames", *options.frames, 1, most_frames) : 1;
    if (options.recording) {
        return recorded_camera(*options.recording, frames);
    }
    const std::vector<content::CameraMoment>& path = scenario.camera.path;
    if (frames > 1 && path.empty()) {
        throw sim::BadInput("--frames", "", *options.frames,
                            "a sequence needs a [[camera.path]] in the scenario, or --recording");
    }
    if (frames == 1 && !options.at) {
        content::TracedScenario still = scenario; // the camera as the scenario has it, not its path's beginning
        still.camera.path.clear();
        return {render::camera_pose(still, 0.0)};
    }
    std::vector<render::CameraPose> poses;
    for (int i = 0; i < frames; ++i) {
        double moment = path.empty() ? 0.0 : path.front().at;
        if (options.at) {
            moment = number_option("--at", *options.at);
        } else if (frames > 1) {
            moment += (path.back().at - path.front().at) * i / (frames - 1);
        }
        poses.push_back(render::camera_pose(scenario, moment));
    }
    return poses;
}

std::uint64_t checksum_of(const std::filesystem::path& file) {
    Checksum sum;
    const std::vector<std::uint8_t> bytes = content::read_file_bytes(file);
    sum.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    return sum.sum();
}

std::string vector_text(const glm::dvec3& v) {
    return fmt::format("{},{},{}", v.x, v.y, v.z);
}

// The scenario's own text stands for all that the options leave as it says; other files by what they hold.
std::string job_text(const TraceRequest& request) {
    const content::TracedScenario& scenario = request.scenario;
    std::string text =
        fmt::format("rapidity {}\nscenario {} {:016x}\n", RAPIDITY_VERSION, scenario.name, checksum_of(scenario.file));
    for (const auto& [name, value] : scenario.spacetime.parameters) {
        text += fmt::format("parameter {} {}\n", name, value);
    }
    const auto add_file = [&](const std::filesystem::path& file) {
        std::error_code error;
        if (std::filesystem::is_regular_file(file, error)) {
            text += fmt::format("file {:016x}\n", checksum_of(file));
        }
    };
    add_file(scenario.sky.panorama);
    if (scenario.other_sky) {
        add_file(scenario.other_sky->panorama);
    }
    add_file(scenario.spacetime.name);
    for (const content::TracedSphere& sphere : scenario.spheres) {
        add_file(sphere.texture);
    }
    for (const content::TracedModel& model : scenario.models) {
        add_file(model.file);
    }
    text += fmt::format("size {}x{}\nprojection {}\nfield of view {}\nsamples {}\nerror {}\ntables {}\n",
                        request.lens.width, request.lens.height, static_cast<int>(request.lens.projection),
                        request.lens.field_of_view, request.samples_per_side, request.accuracy.error,
                        request.accuracy.tables);
    if (request.frames.size() > 1 && request.format == render::PictureFormat::png) {
        text += fmt::format("exposure {} {}, {} curve, {} frames a second\n",
                            request.exposure.automatic ? "automatic" : "of", request.exposure.stops,
                            request.exposure.linear_curve ? "linear" : "filmic", request.frames_per_second);
    }
    for (const render::CameraPose& pose : request.frames) {
        text += fmt::format("frame {} {} {} {} {}\n", pose.time, vector_text(pose.position), vector_text(pose.velocity),
                            vector_text(pose.look), vector_text(pose.up));
    }
    return text;
}

void check_output(TraceRequest& request) {
    request.format = render::picture_format(request.output);
    const std::size_t digits = hashes(request.output.filename().string());
    if (request.frames.size() > 1 && digits == 0) {
        throw sim::BadInput("--output", "", request.output.string(),
                            "a sequence's name needs #### where the frame's number goes");
    }
    if (request.frames.size() == 1 && digits > 0) {
        throw sim::BadInput("--output", "", request.output.string(), "#### is for the frames of a sequence");
    }
}

} // namespace

std::filesystem::path TraceRequest::picture_file(std::size_t frame) const {
    std::string name = output.filename().string();
    if (const std::size_t digits = hashes(name); digits > 0) {
        name.replace(name.find('#'), digits, fmt::format("{:0{}}", frame, digits));
    }
    return output.parent_path() / name;
}

std::filesystem::path TraceRequest::tiles_folder() const {
    std::filesystem::path folder = output;
    folder += ".tiles";
    return folder;
}

TraceRequest trace_request(const TraceOptions& options) {
    TraceRequest request;
    request.output = options.output;
    request.scenario = content::load_traced_scenario(options.scenario);
    set_parameters(request.scenario, options.parameters);
    set_camera(request.scenario, options);
    const content::TracedCamera& camera = request.scenario.camera;
    const bool whole_sky = camera.projection == content::Projection::equirectangular;
    const PictureSize size =
        options.size ? size_option("--size", *options.size) : (whole_sky ? PictureSize{2048, 1024} : PictureSize{});
    request.lens = {camera.projection, camera.field_of_view, size.width, size.height};
    if (options.samples) {
        request.samples_per_side = whole_number_option("--samples", *options.samples, 2, most_samples_per_side);
    }
    if (options.error) {
        request.accuracy.error = number_option("--error", *options.error, 1e-12, 1e-2);
    }
    request.accuracy.tables = !options.every_ray;
    request.exposure.automatic = request.scenario.automatic_exposure;
    request.exposure.stops = static_cast<float>(request.scenario.exposure_stops);
    request.exposure.linear_curve = options.curve && named_option("--curve", *options.curve, curve_names);
    if (options.exposure) {
        request.exposure.automatic = *options.exposure == "auto";
        request.exposure.stops = request.exposure.automatic
                                     ? 0.0f
                                     : static_cast<float>(number_option("--exposure", *options.exposure, -60.0, 60.0));
    }
    if (options.frames_per_second) {
        request.frames_per_second = number_option("--fps", *options.frames_per_second, 0.1, 1000.0);
    }
    const int cores = tbb::this_task_arena::max_concurrency();
    request.threads = options.threads ? whole_number_option("--threads", *options.threads, 1, 1024) : cores;
    request.restart = options.restart;
    request.frames = camera_frames(options, request.scenario);
    check_output(request);
    if (request.format == render::PictureFormat::exr && (options.exposure || options.curve)) {
        throw sim::BadInput(options.exposure ? "--exposure" : "--curve", "",
                            options.exposure ? *options.exposure : *options.curve,
                            "only a .png is exposed; an .exr keeps the radiance");
    }
    request.job = job_text(request);
    return request;
}

} // namespace engine
