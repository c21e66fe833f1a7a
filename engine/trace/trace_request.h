#pragma once

#include "content/traced/traced_scenario.h"
#include "render/offline/traced/traced_scene.h"
#include "render/picture_file.h"
#include "render/render_frame.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace engine {

/// The options of `rapidity trace` as they were typed; unset ones take the scenario's value or a default.
struct TraceOptions {
    std::string scenario;
    std::string output;
    std::vector<std::string> parameters; ///< each "name=value", of the spacetime
    std::optional<std::string> size;
    std::optional<std::string> samples;
    std::optional<std::string> error;
    std::optional<std::string> projection;
    std::optional<std::string> field_of_view;
    std::optional<std::string> position;
    std::optional<std::string> look;
    std::optional<std::string> at;
    std::optional<std::string> frames;
    std::optional<std::string> recording;
    std::optional<std::string> frames_per_second;
    std::optional<std::string> exposure;
    std::optional<std::string> curve;
    std::optional<std::string> threads;
    bool every_ray = false;
    bool restart = false;
};

/// A picture or sequence, ready to be made.
struct TraceRequest {
    content::TracedScenario scenario;
    render::CameraLens lens;
    render::TraceAccuracy accuracy;
    int samples_per_side = 2;
    std::vector<render::CameraPose> frames; ///< one a picture
    std::filesystem::path output;           ///< of a sequence: with ####, for the frame's number
    render::PictureFormat format = render::PictureFormat::png;
    render::Exposure exposure;
    double frames_per_second = 30.0; ///< at which exposure adapts from picture to picture
    int threads = 0;
    bool restart = false;
    std::string job; ///< all that the tiles depend on, as text

    std::filesystem::path picture_file(std::size_t frame) const;
    std::filesystem::path tiles_folder() const;
};

/// Checks everything that was typed before any work is done. Throws sim::BadInput naming the option or key.
TraceRequest trace_request(const TraceOptions& options);

} // namespace engine
