#include "engine/trace/traced_picture_file.h"

#include "render/shown_picture.h"
#include "sim/bad_input.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace engine {
namespace {

using render::TracedChannel;

render::Picture assembled(const TilePlan& plan, const TileStore& store, int frame) {
    render::Picture picture;
    picture.width = plan.width();
    picture.height = plan.height();
    picture.channels = static_cast<int>(render::traced_channel_count);
    constexpr std::size_t channels = render::traced_channel_count;
    const auto width = static_cast<std::size_t>(picture.width);
    picture.values.resize(width * static_cast<std::size_t>(picture.height) * channels);
    const std::size_t first = static_cast<std::size_t>(frame) * plan.tiles_per_frame();
    for (std::size_t tile = first; tile < first + plan.tiles_per_frame(); ++tile) {
        const std::optional<std::vector<float>> values = store.load(tile);
        if (!values) {
            throw sim::BadInput(store.folder().string(), fmt::format("tile {}", tile), "",
                                "has gone while the picture was made; run the command again");
        }
        const render::TracedTile place = plan.place_of(tile);
        const std::size_t row_values = static_cast<std::size_t>(place.width) * channels;
        for (int row = 0; row < place.height; ++row) {
            const std::size_t to =
                (static_cast<std::size_t>(place.top + row) * width + static_cast<std::size_t>(place.left)) * channels;
            std::copy_n(values->begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * row_values),
                        row_values, picture.values.begin() + static_cast<std::ptrdiff_t>(to));
        }
    }
    return picture;
}

float channel(const render::Picture& picture, std::size_t pixel, TracedChannel which) {
    return picture.values[pixel * render::traced_channel_count + static_cast<std::size_t>(which)];
}

TraceSummary summary_of(const render::Picture& picture) {
    TraceSummary summary;
    summary.pixels = picture.values.size() / render::traced_channel_count;
    std::vector<float> errors;
    errors.reserve(summary.pixels);
    for (std::size_t pixel = 0; pixel < summary.pixels; ++pixel) {
        summary.rays += channel(picture, pixel, TracedChannel::rays);
        summary.steps += channel(picture, pixel, TracedChannel::steps) / static_cast<double>(summary.pixels);
        if (channel(picture, pixel, TracedChannel::undecided) > 0.0f) {
            ++summary.undecided_pixels;
        } else {
            errors.push_back(channel(picture, pixel, TracedChannel::error));
        }
    }
    if (!errors.empty()) {
        const auto at_share = [&](double share) {
            const auto place = errors.begin() + static_cast<std::ptrdiff_t>(share * double(errors.size() - 1));
            std::nth_element(errors.begin(), place, errors.end());
            return static_cast<double>(*place);
        };
        summary.median_error = at_share(0.5);
        summary.largest_error = at_share(0.99);
    }
    return summary;
}

render::Picture light_of(const render::Picture& picture) {
    render::Picture light;
    light.width = picture.width;
    light.height = picture.height;
    light.channels = 3;
    const std::size_t pixels = picture.values.size() / render::traced_channel_count;
    light.values.reserve(3 * pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        for (const TracedChannel which : {TracedChannel::red, TracedChannel::green, TracedChannel::blue}) {
            light.values.push_back(channel(picture, pixel, which));
        }
    }
    return light;
}

render::PictureMetadata metadata_of(const TraceRequest& request, int frame, const TraceSummary& summary,
                                    const std::string& method) {
    const render::CameraPose& pose = request.frames[static_cast<std::size_t>(frame)];
    render::PictureMetadata metadata{
        {"scenario", request.scenario.name},
        {"spacetime", request.scenario.spacetime.name},
        {"method", method},
        {"camera_time", pose.time},
        {"camera_position", pose.position},
        {"camera_velocity", pose.velocity},
        {"error_asked_radians", request.accuracy.error},
        {"error_99th_percentile_radians", summary.largest_error},
        {"undecided_pixels", static_cast<double>(summary.undecided_pixels)},
        {"rays", summary.rays},
        {"outcome_codes", "0 sky, 1 other sky, 2 captured, 3 object, 4 disk, 5 step limit, 6 left the chart, 7 "
                          "constraint drift, 8 not finite"},
        {"effects_exact", "light bending, delay, aberration, Doppler and gravitational shift, radiance D^-4"},
        {"effects_approximate",
         "the light that falls on spheres and models is not bent; disk: black bodies; spectra of "
         "panoramas and surfaces: RGB as smooth reflectances under one black body"},
    };
    for (const auto& [name, value] : request.scenario.spacetime.parameters) {
        metadata["spacetime_" + name] = value;
    }
    return metadata;
}

} // namespace

TraceSummary write_traced_picture(const TraceRequest& request, const TilePlan& plan, const TileStore& store,
                                  SequenceExposure& exposure, int frame, const std::string& method) {
    const render::Picture picture = assembled(plan, store, frame);
    const TraceSummary summary = summary_of(picture);
    render::PictureMetadata metadata = metadata_of(request, frame, summary, method);
    const std::filesystem::path file = request.picture_file(static_cast<std::size_t>(frame));
    if (request.format == render::PictureFormat::exr) {
        render::write_exr_channels(file, picture, render::traced_channel_names, metadata);
    } else {
        const render::Picture light = light_of(picture);
        const double stops = exposure.stops(static_cast<std::size_t>(frame), request.exposure, light);
        metadata["exposure_stops"] = stops;
        render::RenderFrame shown;
        shown.eye.width = light.width;
        shown.eye.height = light.height;
        shown.exposure = request.exposure;
        shown.display.dither = false; // videos are coded: noise would cost, and not last
        render::write_png(file, render::shown_picture(light, shown, stops), metadata);
    }
    return summary;
}

} // namespace engine
