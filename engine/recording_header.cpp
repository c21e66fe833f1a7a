#include "engine/recording_header.h"

#include "engine/checksum.h"

#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <optional>

namespace engine {
namespace {

std::optional<std::string> text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !std::filesystem::is_regular_file(file)) {
        return std::nullopt;
    }
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

std::optional<std::uint64_t> checksum_of(const std::filesystem::path& file) {
    const std::optional<std::string> text = text_of(file);
    if (!text) {
        return std::nullopt;
    }
    Checksum sum;
    sum.add(*text);
    return sum.sum();
}

} // namespace

std::uint64_t RecordingHeader::checksum() const {
    Checksum sum;
    for (const std::string* text :
         {&program_version, &started, &scenario, &scenario_name, &title, &scenario_text, &clock_unit_name}) {
        sum.add(*text);
    }
    sum.add(clock_unit_seconds);
    sum.add(pace);
    for (const InputFile& input : inputs) {
        sum.add(input.role);
        sum.add(input.file);
        sum.add(input.checksum);
    }
    if (!origin.empty()) { // older recordings have none, and a sum without it
        sum.add(origin);
    }
    return sum.sum();
}

RecordingHeader describe_flight(const content::Scenario& scenario) {
    RecordingHeader header;
    header.program_version = RAPIDITY_VERSION;
    header.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    const std::filesystem::path& file = scenario.file.empty() ? scenario.model : scenario.file;
    header.scenario = file.empty() ? "" : std::filesystem::absolute(file).string();
    header.scenario_name = scenario.name;
    header.title = scenario.title;
    header.clock_unit_seconds = scenario.clock_unit_seconds;
    header.clock_unit_name = scenario.clock_unit_name;
    header.pace = scenario.pace;
    header.scenario_text = text_of(scenario.file).value_or("");

    struct Named {
        const char* role;
        const std::filesystem::path& file;
    };
    for (const Named& input :
         {Named{"scenario", scenario.file}, Named{"model", scenario.model}, Named{"panorama", scenario.panorama}}) {
        if (const auto checksum = checksum_of(input.file)) {
            header.inputs.push_back({input.role, std::filesystem::absolute(input.file).string(), *checksum});
        }
    }
    return header;
}

std::vector<std::string> changed_inputs(const RecordingHeader& header) {
    std::vector<std::string> lines;
    for (const InputFile& input : header.inputs) {
        const auto checksum = checksum_of(input.file);
        if (!checksum) {
            lines.push_back(fmt::format("the {} {} can no longer be read", input.role, input.file));
        } else if (*checksum != input.checksum) {
            lines.push_back(fmt::format("the {} {} has changed since this flight", input.role, input.file));
        }
    }
    return lines;
}

} // namespace engine
