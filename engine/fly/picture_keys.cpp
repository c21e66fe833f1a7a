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

} // namespace

void change_picture(input::Action action, PictureSettings& picture) {
    constexpr float third_of_a_stop = 1.0F / 3.0F;
    switch (action) {
    case input::Action::mode_next:
        picture.mode =
            picture.mode == Mode::full ? Mode::geometry : static_cast<Mode>(static_cast<int>(picture.mode) + 1);
        break;
    case input::Action::mode_geometry:
        picture.mode = Mode::geometry;
        break;
    case input::Action::mode_doppler:
        picture.mode = Mode::doppler;
        break;
    case input::Action::mode_searchlight:
        picture.mode = Mode::searchlight;
        break;
    case input::Action::mode_full:
        picture.mode = Mode::full;
        break;
    case input::Action::exposure_down:
        picture.exposure.stops -= third_of_a_stop;
        break;
    case input::Action::exposure_up:
        picture.exposure.stops += third_of_a_stop;
        break;
    case input::Action::exposure_automatic:
        picture.exposure.automatic = !picture.exposure.automatic;
        break;
    case input::Action::curve:
        picture.exposure.linear_curve = !picture.exposure.linear_curve;
        break;
    default:
        change_display(action, picture);
    }
}

bool is_locked_in_demo(input::Action action) {
    switch (action) {
    case input::Action::panel:
    case input::Action::quit:
    case input::Action::full_screen:
    case input::Action::screenshot:
    case input::Action::bookmark:
        return true;
    default:
        return false;
    }
}

} // namespace engine
