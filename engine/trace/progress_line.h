#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace engine {

/// "3 h 12 min", "2 min 05 s", "8 s".
std::string duration_text(double seconds);

/// Says on standard error how far a long job is and how long it will still take: in place on a terminal, elsewhere a
/// line every ten seconds.
class ProgressLine {
  public:
    ProgressLine(std::size_t total, std::size_t done_before);

    void advance() { ++done_; }
    void show();
    /// Clears the line of a terminal.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    std::size_t total_;
    std::size_t done_before_;
    std::size_t done_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_line_ = Clock::now();
};

} // namespace engine
