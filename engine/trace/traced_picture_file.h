#pragma once

#include "engine/film/exposure_log.h"
#include "engine/trace/tile_store.h"
#include "engine/trace/trace_request.h"

#include <array>
#include <string>

namespace engine {

/// What a traced picture came to.
struct TraceSummary {
    std::size_t pixels = 0;
    std::size_t undecided_pixels = 0; ///< with rays that ran out of steps, left the chart or were not finite
    double rays = 0.0;
    double steps = 0.0;         ///< mean a ray of the pixels
    double largest_error = 0.0; ///< estimate, radians, of decided pixels away from the photon ring: 99th percentile
    double median_error = 0.0;
};

/// Puts a frame's tiles together and writes its picture: .png exposed and encoded for display, .exr with the radiance
/// and all layers (traced_channel_names). Frames in their order, each once: `exposure` adapts from one to the next.
/// Throws sim::BadInput, also for a tile that has gone.
TraceSummary write_traced_picture(const TraceRequest& request, const TilePlan& plan, const TileStore& store,
                                  SequenceExposure& exposure, int frame, const std::string& method);

} // namespace engine
