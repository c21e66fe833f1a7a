#pragma once

#include "render/colour/auto_exposure.h"
#include "render/render_frame.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace engine {

/// How bright the frames of a sequence are, by frame, kept in a file as they are made: automatic exposure adapts from
/// one to the next as an eye does in the film's time, and an interrupted sequence goes on from the same exposure.
class ExposureLog {
  public:
    /// What is whole of an earlier run's file is taken over; the file need not be there.
    explicit ExposureLog(std::filesystem::path file);

    /// The well-exposed factor of a frame (render::well_exposed_factor); none: not known.
    std::optional<double> factor(std::size_t frame) const;
    /// Notes it, in the file as well, before the frame's picture is written. Throws sim::BadInput.
    void note(std::size_t frame, double factor);

  private:
    std::filesystem::path file_;
    std::vector<std::optional<double>> factors_;
};

/// The stops that a frame of a sequence is shown with, from those before it: frame by frame, in their order.
class SequenceExposure {
  public:
    SequenceExposure(std::filesystem::path log_file, double frames_per_second)
        : log_(std::move(log_file)), seconds_(1.0 / frames_per_second) {}

    /// Whether the frame's light is still to be metered.
    bool needs(std::size_t frame, const render::Exposure& exposure) const {
        return exposure.automatic && !log_.factor(frame);
    }
    /// `light`: radiance; may be empty when it is not needed.
    double stops(std::size_t frame, const render::Exposure& exposure, const render::Picture& light);

  private:
    ExposureLog log_;
    double seconds_;
    render::AutoExposure eye_;
};

} // namespace engine
