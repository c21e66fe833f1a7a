#pragma once

#include "render/colour/auto_exposure.h"

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

} // namespace engine
