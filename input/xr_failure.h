#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace input {

/// A headset cannot be used, or no longer. what() is one line for the pilot. Whoever flies goes on without it, and may
/// try again later: a headset comes back when it is plugged in, its runtime when it is started.
class XrFailure : public std::runtime_error {
  public:
    enum class Cause : std::uint8_t {
        no_loader,  ///< the OpenXR library is not installed
        no_runtime, ///< no runtime, or one that cannot be loaded
        no_headset, ///< the runtime has none, or it is not to be had now
        unsuited,   ///< what is there cannot do what is needed: no OpenGL, not two views
        lost,       ///< there was one: the runtime ended the session or itself
        refused,    ///< a call failed
    };

    XrFailure(Cause cause, const std::string& line) : std::runtime_error(line), cause_(cause) {}
    Cause cause() const { return cause_; }

  private:
    Cause cause_;
};

} // namespace input
