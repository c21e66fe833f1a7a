#pragma once

#include "input/bindings.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

struct GLFWwindow;

namespace engine {

/// No window can be opened here: no display, or one that does not answer. The flight can still go on headless.
class NoDisplay : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A window with an OpenGL 4.5 core context, current on this thread, and the devices that belong to it. One at a time.
class Window {
  public:
    enum class Visible : bool { no, yes };

    /// Throws NoDisplay; sim::BadInput when the display has no OpenGL 4.5. Sizes in screen coordinates.
    Window(const std::string& title, int width, int height, Visible visible = Visible::yes);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Collects what happened since the last call. Keys and mouse that the instruments' panel uses are left out.
    void poll(bool keyboard_taken, bool mouse_taken);
    /// As of the last poll. Mouse movements and taps count for one poll.
    const input::DeviceState& devices() const;

    bool closing() const;
    void close();
    void swap();
    /// Whether swap() waits for the screen; at first it does.
    void set_vertical_sync(bool wait);
    void toggle_full_screen();

    struct Size {
        int width = 0; ///< pixels; 0 while minimised
        int height = 0;
    };
    Size framebuffer_size() const;
    /// Where the mouse is, in pixels of the framebuffer from its upper left corner; outside of it too.
    struct Point {
        double x = 0.0;
        double y = 0.0;
    };
    Point cursor() const;
    /// Whether the left mouse button is down, as of the last poll.
    bool presses_left_button() const;
    /// Pixels per point of text: the monitor's scale.
    float content_scale() const;

    GLFWwindow* handle() const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Names of the gamepads that are plugged in, with "(no mapping)" where GLFW's database does not know the model. Opens
/// and closes GLFW if no window is open; empty when that fails.
std::vector<std::string> gamepad_names();

} // namespace engine
