#pragma once

#include "engine/film/film_request.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>

namespace engine {

/// The options of a film as they were typed.
struct FilmOptions {
    std::string video;
    std::string frames;
    std::optional<std::string> size;
    std::optional<std::string> frames_per_second;
    std::optional<std::string> clock;
    std::optional<std::string> speed;
    std::optional<std::string> mode;
    std::optional<std::string> samples;
    std::optional<std::string> projection;
    std::optional<std::string> stereo;
    std::optional<std::string> exposure;

    bool wanted() const { return !video.empty() || !frames.empty(); }
    /// Whether there are options of a film, but no film to use them.
    bool without_film() const {
        return !wanted() &&
               (size || frames_per_second || clock || speed || mode || samples || projection || stereo || exposure);
    }
};

void add_film_options(CLI::App& command, FilmOptions& options);

/// Checks everything before any work is done. `method`: as typed; "": automatic. Throws sim::BadInput naming the
/// option.
FilmRequest film_request(const FilmOptions& options, const std::string& method);

} // namespace engine
