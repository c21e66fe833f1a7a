#pragma once

namespace engine {

/// Holds the frame rate by drawing fewer pixels when frames cost too much, and all of them again when they are cheap.
/// Pure: told what frames cost, it reads no clock.
class DynamicResolution {
  public:
    /// `budget_seconds`: what a frame may cost, > 0.
    explicit DynamicResolution(double budget_seconds);

    /// A frame drawn at scale() cost so much. Returns the scale for the next.
    double update(double frame_seconds);

    /// Linear factor on width and height, in [smallest, 1], in steps so that the picture does not breathe.
    double scale() const { return scale_; }

    static constexpr double smallest = 0.375;
    static constexpr double step = 0.0625;

  private:
    double budget_seconds_;
    double scale_ = 1.0;
    double smoothed_seconds_ = 0.0; ///< 0: nothing measured at this scale yet
    int frames_at_scale_ = 0;
};

} // namespace engine
