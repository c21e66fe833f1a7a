#pragma once

#include "engine/flight.h"

#include <filesystem>
#include <string>

namespace engine {

class Recorder;

/// A flight with its recorder.
class RecordedFlight {
  public:
    /// Throws sim::BadInput when `recording` is there and not empty.
    RecordedFlight(const content::Scenario& scenario, std::filesystem::path recording);

    Flight& flight() { return flight_; }
    const Flight& flight() const { return flight_; }
    const std::filesystem::path& file() const { return file_; }

    /// Writes the rest of the recording; returns what went wrong, "" when all is there. Nothing is recorded afterwards.
    std::string close();

  private:
    RecordedFlight(const content::Scenario& scenario, std::filesystem::path recording,
                   std::unique_ptr<Recorder> recorder);

    std::filesystem::path file_;
    Recorder* recorder_; ///< owned by the flight
    Flight flight_;
};

} // namespace engine
