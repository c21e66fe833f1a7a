#include "engine/fly/recorded_flight.h"

#include "engine/recorder.h"
#include "engine/recording_header.h"

#include <utility>

namespace engine {
namespace {

RecordingHeader describe_branch(const content::Scenario& scenario, const std::string& origin) {
    RecordingHeader header = describe_flight(scenario);
    header.origin = origin;
    return header;
}

} // namespace

RecordedFlight::RecordedFlight(const content::Scenario& scenario, const std::filesystem::path& recording)
    : RecordedFlight(scenario, recording,
                     std::make_unique<Recorder>(recording, describe_flight(scenario), starting_change(scenario))) {}

RecordedFlight::RecordedFlight(const content::Scenario& scenario, std::filesystem::path recording,
                               std::unique_ptr<Recorder> recorder)
    : file_(std::move(recording)), recorder_(recorder.get()), flight_(scenario, std::move(recorder)) {}

RecordedFlight::RecordedFlight(const content::Scenario& scenario, const std::filesystem::path& recording,
                               const FlightChange& start, const std::string& origin)
    : RecordedFlight(scenario, recording,
                     std::make_unique<Recorder>(recording, describe_branch(scenario, origin), start)) {
    flight_.begin_at(start);
}

RecordedFlight RecordedFlight::replay(const content::Scenario& scenario, const std::filesystem::path& recording) {
    return {scenario, recording, nullptr};
}

std::string RecordedFlight::close() {
    if (recorder_ == nullptr) {
        return {};
    }
    recorder_->close();
    return recorder_->trouble();
}

} // namespace engine
