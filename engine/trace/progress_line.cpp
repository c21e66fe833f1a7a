#include "engine/trace/progress_line.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace engine {

std::string duration_text(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole >= 3600) {
        return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
    }
    return whole >= 60 ? fmt::format("{} min {:02} s", whole / 60, whole % 60) : fmt::format("{} s", whole);
}

ProgressLine::ProgressLine(std::size_t total, std::size_t done_before)
    : total_(total), done_before_(done_before), done_(done_before), terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show() {
    const auto now = Clock::now();
    if (!terminal_ && now - last_line_ < std::chrono::seconds(10)) {
        return;
    }
    last_line_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const std::size_t here = done_ - done_before_;
    const std::string left =
        here == 0 ? "time left not known yet"
                  : duration_text(seconds / static_cast<double>(here) * static_cast<double>(total_ - done_)) + " left";
    fmt::print(stderr, "{}rapidity: {:.1f} %, tile {} of {}, {}{}", terminal_ ? "\r\033[K" : "",
               100.0 * static_cast<double>(done_) / static_cast<double>(total_), done_, total_, left,
               terminal_ ? "" : "\n");
    std::fflush(stderr);
    shown_ = true;
}

void ProgressLine::clear() {
    if (terminal_ && shown_) {
        fmt::print(stderr, "\r\033[K");
    }
}

} // namespace engine
