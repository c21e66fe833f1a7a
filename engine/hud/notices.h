#pragma once

#include <string>
#include <vector>

namespace engine {

/// Lines that the pilot should see for a while.
class Notices {
  public:
    /// Shows a line for `seconds` of the pilot's time; the same line again only starts its time anew.
    void show(const std::string& line, double seconds = 4.0);
    /// Time passes.
    void advance(double seconds);
    std::vector<std::string> lines() const;

  private:
    struct Notice {
        std::string line;
        double seconds_left;
    };
    std::vector<Notice> notices_;
};

} // namespace engine
