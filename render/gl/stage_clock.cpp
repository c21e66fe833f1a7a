#include "render/gl/stage_clock.h"

#include "render/gl/gl_objects.h"

#include <sys/resource.h>

namespace render {
namespace {

double process_cpu_ms() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto ms = [](const timeval& t) {
        return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
    };
    return ms(usage.ru_utime) + ms(usage.ru_stime);
}

} // namespace

StageClock::StageClock(bool on) : on_(on) {
    lap();
}

StageCost StageClock::lap() {
    if (!on_) {
        return {};
    }
    glFinish();
    const auto now = std::chrono::steady_clock::now();
    const double cpu = process_cpu_ms();
    const StageCost cost{std::chrono::duration<double, std::milli>(now - wall_).count(), cpu - cpu_ms_};
    wall_ = now;
    cpu_ms_ = cpu;
    return cost;
}

} // namespace render
