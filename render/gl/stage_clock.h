#pragma once

#include "render/gl/renderer.h"

#include <chrono>

namespace render {

/// Measures the stages of a frame one after the other, waiting for OpenGL at the end of each; does nothing unless on.
class StageClock {
  public:
    explicit StageClock(bool on);

    /// What the stage that ends now took.
    StageCost lap();

  private:
    bool on_;
    std::chrono::steady_clock::time_point wall_;
    double cpu_ms_ = 0.0;
};

} // namespace render
