#pragma once

#include "input/xr_runtime.h"

#include <memory>

namespace engine {

/// The OpenGL context that is current on this thread, as an OpenXR session wants it.
class GraphicsBinding {
  public:
    /// Throws input::XrFailure when the context is of neither kind.
    GraphicsBinding();
    ~GraphicsBinding();
    GraphicsBinding(const GraphicsBinding&) = delete;
    GraphicsBinding& operator=(const GraphicsBinding&) = delete;

    input::XrGraphics graphics() const;
    /// The XrGraphicsBinding... structure; lives as long as this.
    const void* structure() const;

  private:
    struct Structures;
    std::unique_ptr<Structures> structures_;
};

} // namespace engine
