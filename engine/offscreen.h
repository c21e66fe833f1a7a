#pragma once

#include "content/scene_desc.h"
#include "render/gl/gl_objects.h"

namespace engine {

/// A framebuffer without a window, to draw frames and instruments into and read them back. Needs a current context.
class Offscreen {
  public:
    Offscreen(int width, int height);

    GLuint framebuffer() const { return framebuffer_.name(); }
    GLuint texture() const { return colour_.name(); }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Puts a picture of its size into it, rows from the top.
    void write(const content::Image& picture);
    /// The pixels as they stand, rows from the top, opaque.
    content::Image read() const;

  private:
    int width_;
    int height_;
    render::Texture colour_;
    render::Framebuffer framebuffer_;
};

/// The pixels of a framebuffer (0: the window's back buffer), rows from the top, opaque.
content::Image read_pixels(GLuint framebuffer, int width, int height);

} // namespace engine
