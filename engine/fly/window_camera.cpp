#include "engine/fly/window_flight.h"

#include <fmt/format.h>

namespace engine {
namespace {

/// How fast the free camera goes, scene metres in a second of the viewer's time.
constexpr double free_camera_speed = 6.0;

} // namespace

/// Where the pilot's own camera looks: whoever watches a replay may look around from the recorded head.
glm::dquat WindowFlight::look() const {
    const Flight& flight = recorded_->flight();
    return is_replay()   ? flight.head_between(fraction_) * hands_.vehicle_from_head()
           : is_mirror() ? headset_frame_->head.place.orientation
           : script_     ? flight.head_between(fraction_)
                         : hands_.vehicle_from_head();
}

void WindowFlight::handle_camera(input::Action action) {
    const sim::VehicleState moment = recorded_->flight().between(fraction_);
    if (action == input::Action::camera_next) {
        cameras_.choose_next(moment);
    } else if (action == input::Action::camera_pilot) {
        cameras_.choose(CameraKind::pilot, moment);
    } else {
        return;
    }
    notices_.show(fmt::format("camera: {}", name_of(cameras_.kind(), camera_names)));
}

/// In a replay nobody flies: the keys of thrust move the free camera.
void WindowFlight::move_camera(double elapsed_seconds) {
    if (!is_replay() || cameras_.kind() != CameraKind::free) {
        return;
    }
    using input::Action;
    const auto held = [this](Action more, Action less) {
        return input::strength(window_.devices(), more) - input::strength(window_.devices(), less);
    };
    cameras_.move(free_camera_speed * elapsed_seconds *
                  glm::dvec3(held(Action::thrust_right, Action::thrust_left),
                             held(Action::thrust_up, Action::thrust_down),
                             held(Action::thrust_back, Action::thrust_ahead)));
}

} // namespace engine
