#pragma once

#include "engine/flight.h"

#include <filesystem>
#include <string>

namespace engine {

class Recorder;

/// A flight and its recording.
class RecordedFlight {
  public:
    /// Throws sim::BadInput when `recording` is there and not empty.
    RecordedFlight(const content::Scenario& scenario, const std::filesystem::path& recording);
    /// A flight that goes on from another's tick; `origin` says which. Throws sim::BadInput as above.
    RecordedFlight(const content::Scenario& scenario, const std::filesystem::path& recording, const FlightChange& start,
                   const std::string& origin);
    /// A flight that only shows moments of `recording`, and is not recorded once more.
    static RecordedFlight replay(const content::Scenario& scenario, const std::filesystem::path& recording);

    Flight& flight() { return flight_; }
    const Flight& flight() const { return flight_; }
    const std::filesystem::path& file() const { return file_; }

    /// Writes the rest of the recording; returns what went wrong, "" when all is there. Nothing is recorded afterwards.
    std::string close();

  private:
    RecordedFlight(const content::Scenario& scenario, std::filesystem::path recording,
                   std::unique_ptr<Recorder> recorder);

    std::filesystem::path file_;
    Recorder* recorder_; ///< owned by the flight; none in a replay
    Flight flight_;
};

} // namespace engine
