#pragma once

#include <bitset>
#include <cstdint>
#include <string_view>

namespace input {

/// Keys that steer Rapidity, by their place on a US keyboard. The values are GLFW's, so that the window passes its own
/// through; the engine checks that with static assertions where it includes GLFW.
enum class Key : std::uint16_t {
    none = 0,
    space = 32,
    apostrophe = 39,
    comma = 44,
    minus = 45,
    period = 46,
    slash = 47,
    digit_0 = 48,
    digit_1 = 49,
    digit_2 = 50,
    digit_3 = 51,
    digit_4 = 52,
    digit_5 = 53,
    digit_6 = 54,
    digit_7 = 55,
    digit_8 = 56,
    digit_9 = 57,
    semicolon = 59,
    equal = 61,
    a = 65,
    b = 66,
    c = 67,
    d = 68,
    e = 69,
    f = 70,
    g = 71,
    h = 72,
    i = 73,
    j = 74,
    k = 75,
    l = 76,
    m = 77,
    n = 78,
    o = 79,
    p = 80,
    q = 81,
    r = 82,
    s = 83,
    t = 84,
    u = 85,
    v = 86,
    w = 87,
    x = 88,
    y = 89,
    z = 90,
    left_bracket = 91,
    backslash = 92,
    right_bracket = 93,
    grave_accent = 96,
    escape = 256,
    enter = 257,
    tab = 258,
    backspace = 259,
    insert = 260,
    del = 261,
    right = 262,
    left = 263,
    down = 264,
    up = 265,
    page_up = 266,
    page_down = 267,
    home = 268,
    end = 269,
    f1 = 290,
    f2 = 291,
    f3 = 292,
    f4 = 293,
    f5 = 294,
    f6 = 295,
    f7 = 296,
    f8 = 297,
    f9 = 298,
    f10 = 299,
    f11 = 300,
    f12 = 301,
    left_shift = 340,
    left_control = 341,
    right_shift = 344,
    right_control = 345,
};

/// What is printed on the key; "" for Key::none.
std::string_view key_name(Key key);

/// Which keys are down. A tap between two samples counts as down for one sample, so that a slow frame loses no key.
class KeyState {
  public:
    void set(Key key, bool down);
    bool down(Key key) const;
    bool any_down() const { return held_.any() || tapped_.any(); }
    /// The sample was taken: taps that have already ended are forgotten.
    void end_sample() { tapped_.reset(); }
    /// The window lost the keyboard: nothing is held any longer.
    void release_all();

  private:
    std::bitset<512> held_;
    std::bitset<512> tapped_;
};

} // namespace input
