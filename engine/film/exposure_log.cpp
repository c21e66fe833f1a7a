#include "engine/film/exposure_log.h"

#include "render/shown_picture.h"
#include "sim/bad_input.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace engine {
namespace {

constexpr std::size_t most_frames = 10'000'000; // days of film: what is above it in a file is damage

} // namespace

ExposureLog::ExposureLog(std::filesystem::path file) : file_(std::move(file)) {
    std::ifstream stream(file_, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    std::size_t whole = 0; // an interrupted run may have left part of a line
    for (std::size_t end = 0; (end = text.find('\n', whole)) != std::string::npos; whole = end + 1) {
        unsigned long frame = 0;
        double factor = 0.0;
        // A hexadecimal number is the same double when it is read again.
        if (std::sscanf(text.c_str() + whole, "%lu,%la\n", &frame, &factor) != 2 || frame == 0 || frame > most_frames ||
            !(factor >= 0.0)) {
            break;
        }
        factors_.resize(std::max<std::size_t>(factors_.size(), frame));
        factors_[frame - 1] = factor;
    }
    stream.close();
    if (whole < text.size()) {
        std::error_code error;
        std::filesystem::resize_file(file_, whole, error);
        if (error) {
            throw sim::BadInput(file_.string(), "", "", "cannot be written: " + error.message());
        }
    }
}

std::optional<double> ExposureLog::factor(std::size_t frame) const {
    return frame < factors_.size() ? factors_[frame] : std::nullopt;
}

void ExposureLog::note(std::size_t frame, double factor) {
    factors_.resize(std::max(factors_.size(), frame + 1));
    factors_[frame] = factor;
    std::ofstream stream(file_, std::ios::binary | std::ios::app);
    stream << fmt::format("{},{:a}\n", frame + 1, factor);
    stream.close();
    if (!stream) {
        throw sim::BadInput(file_.string(), "", "", "cannot be written");
    }
}

double SequenceExposure::stops(std::size_t frame, const render::Exposure& exposure, const render::Picture& light) {
    if (!exposure.automatic) {
        return static_cast<double>(exposure.stops);
    }
    if (!log_.factor(frame)) {
        log_.note(frame, render::well_exposed_factor(render::metered(light)));
    }
    return std::log2(eye_.adapt_to(*log_.factor(frame), seconds_, static_cast<double>(exposure.stops)));
}

} // namespace engine
