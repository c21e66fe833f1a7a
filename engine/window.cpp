#include "engine/window.h"

#include "render/gl/egl_context.h"
#include "sim/bad_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <fmt/core.h>

namespace engine {
namespace {

// input knows no window library: these keep its numbers and GLFW's the same.
template <class Enumeration>
constexpr int value(Enumeration e) {
    return static_cast<int>(e);
}
static_assert(value(input::Key::space) == GLFW_KEY_SPACE && value(input::Key::equal) == GLFW_KEY_EQUAL &&
              value(input::Key::a) == GLFW_KEY_A && value(input::Key::x) == GLFW_KEY_X &&
              value(input::Key::digit_1) == GLFW_KEY_1 && value(input::Key::left_bracket) == GLFW_KEY_LEFT_BRACKET &&
              value(input::Key::right_bracket) == GLFW_KEY_RIGHT_BRACKET &&
              value(input::Key::escape) == GLFW_KEY_ESCAPE && value(input::Key::tab) == GLFW_KEY_TAB &&
              value(input::Key::backspace) == GLFW_KEY_BACKSPACE && value(input::Key::enter) == GLFW_KEY_ENTER &&
              value(input::Key::del) == GLFW_KEY_DELETE && value(input::Key::grave_accent) == GLFW_KEY_GRAVE_ACCENT &&
              value(input::Key::left_control) == GLFW_KEY_LEFT_CONTROL &&
              value(input::Key::right_control) == GLFW_KEY_RIGHT_CONTROL && value(input::Key::up) == GLFW_KEY_UP &&
              value(input::Key::right) == GLFW_KEY_RIGHT && value(input::Key::f1) == GLFW_KEY_F1 &&
              value(input::Key::f10) == GLFW_KEY_F10 && value(input::Key::f12) == GLFW_KEY_F12 &&
              value(input::Key::left_shift) == GLFW_KEY_LEFT_SHIFT &&
              value(input::Key::right_shift) == GLFW_KEY_RIGHT_SHIFT);
static_assert(value(input::GamepadAxis::right_trigger) == GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER &&
              value(input::GamepadAxis::right_x) == GLFW_GAMEPAD_AXIS_RIGHT_X);
static_assert(value(input::GamepadButton::pad_left) == GLFW_GAMEPAD_BUTTON_DPAD_LEFT &&
              value(input::GamepadButton::left_bumper) == GLFW_GAMEPAD_BUTTON_LEFT_BUMPER &&
              value(input::GamepadButton::left_thumb) == GLFW_GAMEPAD_BUTTON_LEFT_THUMB);

/// Why GLFW's last call failed; GLFW keeps it, so no error callback prints anything.
std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "unknown reason";
}

/// GLFW for as long as this lives.
class Library {
  public:
    Library() {
        if (glfwInit() != GLFW_TRUE) {
            throw NoDisplay(glfw_error());
        }
    }
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

/// The first gamepad that GLFW's mapping database knows; asked at every poll, so plugging in and out just works.
std::optional<input::GamepadState> first_gamepad() {
    for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
        GLFWgamepadstate raw;
        if (glfwJoystickIsGamepad(joystick) != GLFW_TRUE || glfwGetGamepadState(joystick, &raw) != GLFW_TRUE) {
            continue;
        }
        input::GamepadState state;
        state.name = glfwGetGamepadName(joystick);
        std::copy(std::begin(raw.axes), std::end(raw.axes), state.axes.begin());
        std::transform(std::begin(raw.buttons), std::end(raw.buttons), state.buttons.begin(),
                       [](unsigned char button) { return button == GLFW_PRESS; });
        return state;
    }
    return std::nullopt;
}

} // namespace

class Window::Implementation {
  public:
    Implementation(const std::string& title, int width, int height, Visible visible) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        glfwWindowHint(GLFW_VISIBLE, visible == Visible::yes ? GLFW_TRUE : GLFW_FALSE);
        window_.reset(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
        if (!window_) {
            throw sim::BadInput("OpenGL", "window", "",
                                fmt::format("this display offers no OpenGL 4.5 core ({}); "
                                            "LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software rasteriser",
                                            glfw_error()));
        }
        glfwSetWindowUserPointer(window_.get(), this);
        glfwSetKeyCallback(window_.get(), on_key);
        glfwSetScrollCallback(window_.get(), on_scroll);
        glfwSetWindowFocusCallback(window_.get(), on_focus);
        glfwMakeContextCurrent(window_.get());
        glfwSwapInterval(1);
        render::require_opengl_45();
    }

    void poll(bool keyboard_taken, bool mouse_taken) {
        devices_.keys.end_sample();
        devices_.mouse.wheel = 0.0;
        keyboard_taken_ = keyboard_taken;
        mouse_taken_ = mouse_taken;
        glfwPollEvents();
        poll_drags();
        devices_.gamepad = first_gamepad();
    }

    void set_vertical_sync(bool wait) {
        if (wait != vertical_sync_) {
            vertical_sync_ = wait;
            glfwSwapInterval(wait ? 1 : 0);
        }
    }

    void toggle_full_screen() {
        if (glfwGetWindowMonitor(window_.get()) != nullptr) {
            glfwSetWindowMonitor(window_.get(), nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], 0);
            return;
        }
        GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
        if (mode == nullptr) {
            return;
        }
        glfwGetWindowPos(window_.get(), &windowed_[0], &windowed_[1]);
        glfwGetWindowSize(window_.get(), &windowed_[2], &windowed_[3]);
        glfwSetWindowMonitor(window_.get(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

    GLFWwindow* handle() const { return window_.get(); }
    const input::DeviceState& devices() const { return devices_; }

  private:
    struct DestroyWindow {
        void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
    };

    static Implementation& of(GLFWwindow* window) {
        return *static_cast<Implementation*>(glfwGetWindowUserPointer(window));
    }

    static void on_key(GLFWwindow* window, int key, int /*scancode*/, int action, int /*modifiers*/) {
        Implementation& self = of(window);
        if (action != GLFW_REPEAT && key > 0 && !(self.keyboard_taken_ && action == GLFW_PRESS)) {
            self.devices_.keys.set(static_cast<input::Key>(key), action == GLFW_PRESS);
        }
    }

    static void on_scroll(GLFWwindow* window, double /*x*/, double y) {
        Implementation& self = of(window);
        if (!self.mouse_taken_) {
            self.devices_.mouse.wheel += y;
        }
    }

    static void on_focus(GLFWwindow* window, int focused) {
        if (focused != GLFW_TRUE) {
            of(window).devices_.keys.release_all();
        }
    }

    /// Left drag: how far from where it began. Right drag: how far since the last poll.
    void poll_drags() {
        int width = 0;
        int height = 0;
        glfwGetWindowSize(window_.get(), &width, &height);
        double x = 0.0;
        double y = 0.0;
        glfwGetCursorPos(window_.get(), &x, &y);
        const double scale = 1.0 / std::max(height, 1);
        const bool left = glfwGetMouseButton(window_.get(), GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
        const bool right = glfwGetMouseButton(window_.get(), GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
        if (left && !left_ && !mouse_taken_) {
            steering_ = true;
            steer_from_ = {x, y};
        }
        steering_ = steering_ && left;
        looking_ = right && (looking_ || !mouse_taken_);

        input::MouseState& mouse = devices_.mouse;
        mouse.steer_x = steering_ ? 2.0 * scale * (x - steer_from_[0]) : 0.0;
        mouse.steer_y = steering_ ? 2.0 * scale * (steer_from_[1] - y) : 0.0;
        const bool dragged = looking_ && right_;
        mouse.look_x = dragged ? scale * (x - last_[0]) : 0.0;
        mouse.look_y = dragged ? scale * (last_[1] - y) : 0.0;
        last_ = {x, y};
        left_ = left;
        right_ = right;
    }

    Library library_;
    std::unique_ptr<GLFWwindow, DestroyWindow> window_;
    input::DeviceState devices_;
    bool vertical_sync_ = true;
    bool keyboard_taken_ = false;
    bool mouse_taken_ = false;
    bool left_ = false;
    bool right_ = false;
    bool steering_ = false;
    bool looking_ = false;
    std::array<double, 2> steer_from_{};
    std::array<double, 2> last_{};
    std::array<int, 4> windowed_{};
};

Window::Window(const std::string& title, int width, int height, Visible visible)
    : implementation_(std::make_unique<Implementation>(title, width, height, visible)) {}
Window::~Window() = default;

void Window::poll(bool keyboard_taken, bool mouse_taken) {
    implementation_->poll(keyboard_taken, mouse_taken);
}

const input::DeviceState& Window::devices() const {
    return implementation_->devices();
}

bool Window::closing() const {
    return glfwWindowShouldClose(handle()) == GLFW_TRUE;
}

void Window::close() {
    glfwSetWindowShouldClose(handle(), GLFW_TRUE);
}

void Window::swap() {
    glfwSwapBuffers(handle());
}

void Window::set_vertical_sync(bool wait) {
    implementation_->set_vertical_sync(wait);
}

void Window::toggle_full_screen() {
    implementation_->toggle_full_screen();
}

Window::Size Window::framebuffer_size() const {
    Size size;
    glfwGetFramebufferSize(handle(), &size.width, &size.height);
    return size;
}

Window::Point Window::cursor() const {
    Point point;
    glfwGetCursorPos(handle(), &point.x, &point.y);
    int width = 0;
    int height = 0;
    glfwGetWindowSize(handle(), &width, &height);
    const Size size = framebuffer_size();
    return {point.x * size.width / std::max(width, 1), point.y * size.height / std::max(height, 1)};
}

bool Window::presses_left_button() const {
    return glfwGetMouseButton(handle(), GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
}

float Window::content_scale() const {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(handle(), &x, &y);
    return std::max({x, y, 0.5F});
}

GLFWwindow* Window::handle() const {
    return implementation_->handle();
}

std::vector<std::string> gamepad_names() {
    std::vector<std::string> names;
    try {
        const Library library;
        for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
            if (glfwJoystickIsGamepad(joystick) == GLFW_TRUE) {
                names.emplace_back(glfwGetGamepadName(joystick));
            } else if (glfwJoystickPresent(joystick) == GLFW_TRUE) {
                names.push_back(std::string(glfwGetJoystickName(joystick)) + " (no mapping)");
            }
        }
    } catch (const NoDisplay&) {
        names.clear();
    }
    return names;
}

} // namespace engine
