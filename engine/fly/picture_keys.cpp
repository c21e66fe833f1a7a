#include "engine/fly/picture_keys.h"

namespace engine {
namespace {

using render::Mode;
using render::View;

/// One pane, then a second to compare with, then all four modes, then one again.
std::vector<Pane> next_panes(const PictureSettings& picture) {
    const auto mode_after = [&](std::size_t n) {
        return static_cast<Mode>((static_cast<std::size_t>(picture.mode) + n) % 4);
    };
    switch (picture.other_panes.size()) {
    case 0:
        return {{picture.mode == Mode::full ? Mode::geometry : Mode::full, View::natural}};
    case 1:
        return {{mode_after(1), View::natural}, {mode_after(2), View::natural}, {mode_after(3), View::natural}};
    default:
        return {};
    }
}

} // namespace

void change_display(input::Action action, PictureSettings& picture) {
    switch (action) {
    case input::Action::view_next:
        picture.display.view = picture.display.view == View::luminance
                                   ? View::natural
                                   : static_cast<View>(static_cast<int>(picture.display.view) + 1);
        break;
    case input::Action::iso_lines:
        picture.display.iso_lines = !picture.display.iso_lines;
        break;
    case input::Action::split:
        picture.other_panes = next_panes(picture);
        break;
    case input::Action::bloom:
        picture.display.bloom = picture.display.bloom > 0.0F ? 0.0F : usual_bloom;
        break;
    default:
        break;
    }
}

} // namespace engine
