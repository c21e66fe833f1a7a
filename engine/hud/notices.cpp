#include "engine/hud/notices.h"

#include <algorithm>

namespace engine {

void Notices::show(const std::string& line, double seconds) {
    const auto same = std::ranges::find(notices_, line, &Notice::line);
    if (same != notices_.end()) {
        same->seconds_left = seconds;
    } else {
        notices_.push_back({line, seconds});
    }
}

void Notices::advance(double seconds) {
    for (Notice& notice : notices_) {
        notice.seconds_left -= seconds;
    }
    std::erase_if(notices_, [](const Notice& notice) { return notice.seconds_left <= 0.0; });
}

std::vector<std::string> Notices::lines() const {
    std::vector<std::string> lines;
    for (const Notice& notice : notices_) {
        lines.push_back(notice.line);
    }
    return lines;
}

} // namespace engine
