#pragma once

namespace render {

/// An OpenGL 4.5 core context without a window, current on the thread that made it until it is destroyed: on a GPU
/// where one can be reached without a display, otherwise on Mesa's software rasteriser.
class EglContext {
  public:
    /// Throws sim::BadInput when no EGL display of this machine offers OpenGL 4.5 core.
    EglContext();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

/// Throws sim::BadInput unless the current context is OpenGL 4.5 or newer; for contexts made elsewhere (a window).
void require_opengl_45();

} // namespace render
