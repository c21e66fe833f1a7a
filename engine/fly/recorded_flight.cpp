#include "engine/fly/recorded_flight.h"

#include "engine/recorder.h"
#include "engine/recording_header.h"

#include <utility>

namespace engine {

RecordedFlight::RecordedFlight(const content::Scenario& scenario, std::filesystem::path recording)
    : RecordedFlight(scenario, recording,
                     std::make_unique<Recorder>(recording, describe_flight(scenario), starting_change(scenario))) {}

RecordedFlight::RecordedFlight(const content::Scenario& scenario, std::filesystem::path recording,
                               std::unique_ptr<Recorder> recorder)
    : file_(std::move(recording)), recorder_(recorder.get()), flight_(scenario, std::move(recorder)) {}

RecordedFlight RecordedFlight::replay(const content::Scenario& scenario, const std::filesystem::path& recording,
                                      std::vector<FlightChange> changes) {
    RecordedFlight replayed(scenario, recording, nullptr);
    replayed.flight_.follow(std::move(changes));
    return replayed;
}

std::string RecordedFlight::close() {
    if (recorder_ == nullptr) {
        return {};
    }
    recorder_->close();
    return recorder_->trouble();
}

} // namespace engine
