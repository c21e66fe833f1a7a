#include "input/keys.h"

#include <algorithm>
#include <array>
#include <utility>

namespace input {
namespace {

constexpr std::array names{
    std::pair{Key::none, std::string_view("")},
    std::pair{Key::space, std::string_view("Space")},
    std::pair{Key::apostrophe, std::string_view("'")},
    std::pair{Key::comma, std::string_view(",")},
    std::pair{Key::minus, std::string_view("-")},
    std::pair{Key::period, std::string_view(".")},
    std::pair{Key::slash, std::string_view("/")},
    std::pair{Key::digit_0, std::string_view("0")},
    std::pair{Key::digit_1, std::string_view("1")},
    std::pair{Key::digit_2, std::string_view("2")},
    std::pair{Key::digit_3, std::string_view("3")},
    std::pair{Key::digit_4, std::string_view("4")},
    std::pair{Key::digit_5, std::string_view("5")},
    std::pair{Key::digit_6, std::string_view("6")},
    std::pair{Key::digit_7, std::string_view("7")},
    std::pair{Key::digit_8, std::string_view("8")},
    std::pair{Key::digit_9, std::string_view("9")},
    std::pair{Key::semicolon, std::string_view(";")},
    std::pair{Key::equal, std::string_view("=")},
    std::pair{Key::a, std::string_view("A")},
    std::pair{Key::b, std::string_view("B")},
    std::pair{Key::c, std::string_view("C")},
    std::pair{Key::d, std::string_view("D")},
    std::pair{Key::e, std::string_view("E")},
    std::pair{Key::f, std::string_view("F")},
    std::pair{Key::g, std::string_view("G")},
    std::pair{Key::h, std::string_view("H")},
    std::pair{Key::i, std::string_view("I")},
    std::pair{Key::j, std::string_view("J")},
    std::pair{Key::k, std::string_view("K")},
    std::pair{Key::l, std::string_view("L")},
    std::pair{Key::m, std::string_view("M")},
    std::pair{Key::n, std::string_view("N")},
    std::pair{Key::o, std::string_view("O")},
    std::pair{Key::p, std::string_view("P")},
    std::pair{Key::q, std::string_view("Q")},
    std::pair{Key::r, std::string_view("R")},
    std::pair{Key::s, std::string_view("S")},
    std::pair{Key::t, std::string_view("T")},
    std::pair{Key::u, std::string_view("U")},
    std::pair{Key::v, std::string_view("V")},
    std::pair{Key::w, std::string_view("W")},
    std::pair{Key::x, std::string_view("X")},
    std::pair{Key::y, std::string_view("Y")},
    std::pair{Key::z, std::string_view("Z")},
    std::pair{Key::left_bracket, std::string_view("[")},
    std::pair{Key::backslash, std::string_view("\\")},
    std::pair{Key::right_bracket, std::string_view("]")},
    std::pair{Key::grave_accent, std::string_view("`")},
    std::pair{Key::enter, std::string_view("Enter")},
    std::pair{Key::del, std::string_view("Delete")},
    std::pair{Key::left_control, std::string_view("Left Ctrl")},
    std::pair{Key::right_control, std::string_view("Right Ctrl")},
    std::pair{Key::escape, std::string_view("Esc")},
    std::pair{Key::tab, std::string_view("Tab")},
    std::pair{Key::backspace, std::string_view("Backspace")},
    std::pair{Key::right, std::string_view("Right")},
    std::pair{Key::left, std::string_view("Left")},
    std::pair{Key::down, std::string_view("Down")},
    std::pair{Key::up, std::string_view("Up")},
    std::pair{Key::page_up, std::string_view("Page Up")},
    std::pair{Key::page_down, std::string_view("Page Down")},
    std::pair{Key::insert, std::string_view("Insert")},
    std::pair{Key::home, std::string_view("Home")},
    std::pair{Key::end, std::string_view("End")},
    std::pair{Key::f1, std::string_view("F1")},
    std::pair{Key::f2, std::string_view("F2")},
    std::pair{Key::f3, std::string_view("F3")},
    std::pair{Key::f4, std::string_view("F4")},
    std::pair{Key::f5, std::string_view("F5")},
    std::pair{Key::f6, std::string_view("F6")},
    std::pair{Key::f7, std::string_view("F7")},
    std::pair{Key::f8, std::string_view("F8")},
    std::pair{Key::f9, std::string_view("F9")},
    std::pair{Key::f10, std::string_view("F10")},
    std::pair{Key::f11, std::string_view("F11")},
    std::pair{Key::f12, std::string_view("F12")},
    std::pair{Key::left_shift, std::string_view("Shift")},
    std::pair{Key::right_shift, std::string_view("Right Shift")},
};

} // namespace

std::string_view key_name(Key key) {
    const auto* const found = std::find_if(names.begin(), names.end(), [key](const auto& n) { return n.first == key; });
    return found == names.end() ? std::string_view("?") : found->second;
}

void KeyState::set(Key key, bool down) {
    const auto index = static_cast<std::size_t>(key);
    if (key == Key::none || index >= held_.size()) {
        return;
    }
    held_.set(index, down);
    if (down) {
        tapped_.set(index);
    }
}

bool KeyState::down(Key key) const {
    const auto index = static_cast<std::size_t>(key);
    return held_.test(index) || tapped_.test(index);
}

void KeyState::release_all() {
    held_.reset();
    tapped_.reset();
}

} // namespace input
