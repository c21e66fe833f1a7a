#include "engine/vr/headset.h"

#include "engine/vr/graphics_binding.h"
#include "input/xr_failure.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <fmt/core.h>
#include <thread>
#include <utility>

namespace engine {
namespace {

using input::XrFailure;
using input::XrMotion;
using input::XrPlace;

constexpr double seat_eye_height = 1.2; ///< metres: the ship's origin above the floor of the pilot's room
constexpr std::chrono::seconds look_again_after{2};
constexpr std::chrono::seconds longest_farewell{2};
constexpr double dimmed = 0.2;        ///< pictures while tracking is lost
constexpr double fade_seconds = 0.25; ///< time constant of dimming

/// Where the head looks, without nodding and tilting: a turn about the vertical.
glm::dquat yaw_of(const glm::dquat& head) {
    glm::dvec3 ahead = head * glm::dvec3(0.0, 0.0, -1.0);
    if (std::abs(ahead.y) > 0.99) { // straight up or down: where the top of the head points says more
        ahead = (ahead.y > 0.0 ? -1.0 : 1.0) * (head * glm::dvec3(0.0, 1.0, 0.0));
    }
    return glm::angleAxis(std::atan2(-ahead.x, -ahead.z), glm::dvec3(0.0, 1.0, 0.0));
}

bool may_come_back(XrFailure::Cause cause) {
    return cause != XrFailure::Cause::no_loader && cause != XrFailure::Cause::unsuited;
}

} // namespace

/// Everything that ends with the headset, in the order in which it begins.
struct Headset::Link {
    Link(input::XrBase base, const std::optional<PictureSize>& eye_size)
        : runtime(binding.graphics()), session(runtime, binding.structure(), base), actions(session),
          pictures(session, eye_size.value_or(PictureSize{runtime.recommended_width(), runtime.recommended_height()})) {
    }

    GraphicsBinding binding;
    input::XrRuntime runtime;
    input::XrFlightSession session;
    input::XrFlightActions actions;
    EyePictures pictures;
    input::XrFrame frame;
    Clock::time_point pose_asked; ///< for this frame
    XrTime last_display_time = 0;
    XrPlace base_from_head;        ///< at the frame's display time
    XrMotion head;                 ///< the same in the vehicle
    glm::dvec3 mean_velocity{0.0}; ///< of the head in the base since the last frame, for runtimes that tell none
    int origin_changes = 0;
};

Headset::Headset(input::XrBase base, const std::optional<PictureSize>& eye_size) : base_(base), eye_size_(eye_size) {
    connect();
}

Headset::~Headset() = default;

void Headset::connect() {
    link_ = std::make_unique<Link>(base_, eye_size_);
    // Standing, the ship's origin is where a seated pilot's eyes would be; sitting, the first look says where that is.
    vehicle_from_base_ = {};
    if (base_ == input::XrBase::stage) {
        vehicle_from_base_.position.y = -seat_eye_height;
    }
    seated_ = base_ == input::XrBase::stage;
    tracking_lost_ = false;
    brightness_ = 1.0;
    notes_.push_back(fmt::format("headset: {}, {}x{} pixels an eye", link_->runtime.name(),
                                 link_->pictures.size().width, link_->pictures.size().height));
}

void Headset::lose(const std::string& why) {
    link_.reset();
    look_again_ = Clock::now() + look_again_after;
    notes_.push_back(fmt::format("headset lost ({}): the flight goes on without it", why));
}

std::optional<HeadsetFrame> Headset::begin_frame() {
    if (over_) {
        return std::nullopt;
    }
    try {
        if (!link_) {
            if (Clock::now() < look_again_) {
                return std::nullopt;
            }
            connect();
        }
    } catch (const XrFailure& failure) {
        look_again_ = may_come_back(failure.cause()) ? Clock::now() + look_again_after : Clock::time_point::max();
        return std::nullopt;
    }
    try {
        return try_begin_frame();
    } catch (const XrFailure& failure) {
        lose(failure.what());
        return std::nullopt;
    }
}

std::optional<HeadsetFrame> Headset::try_begin_frame() {
    Link& link = *link_;
    link.session.poll();
    if (link.session.ended()) {
        over_ = true;
        notes_.emplace_back("the headset ends the flight");
        link_.reset();
        return std::nullopt;
    }
    if (!link.session.running()) {
        return std::nullopt;
    }
    link.frame = link.session.begin_frame();
    HeadsetFrame frame;
    frame.shown = link.frame.shown;
    if (link.last_display_time != 0) {
        frame.elapsed_seconds = 1e-9 * static_cast<double>(link.frame.display_time - link.last_display_time);
    }
    link.last_display_time = link.frame.display_time;
    frame.controllers = link.actions.read();

    link.mean_velocity = glm::dvec3(0.0);
    link.pose_asked = Clock::now();
    XrMotion in_base = link.session.head(link.frame.display_time);
    if (in_base.tracked && !tracking_lost_ && frame.elapsed_seconds > 0.0) {
        link.mean_velocity = (in_base.place.position - link.base_from_head.position) / frame.elapsed_seconds;
    }
    in_base = with_velocity(in_base);
    link.base_from_head = in_base.place;
    if (link.session.origin_changes() != std::exchange(link.origin_changes, link.session.origin_changes())) {
        seated_ = base_ == input::XrBase::stage;
    }
    if ((!seated_ && in_base.tracked) || frame.controllers.recentre) {
        recentre();
    }
    follow_tracking(in_base);
    link.head = in_vehicle(in_base);
    frame.head = link.head;
    frame.pointer = in_vehicle(link.actions.pointer(link.frame.display_time));
    const double change = 1.0 - std::exp(-frame.elapsed_seconds / fade_seconds);
    brightness_ += change * ((tracking_lost_ ? dimmed : 1.0) - brightness_);
    return frame;
}

void Headset::follow_tracking(const XrMotion& head) {
    if (!head.tracked && !tracking_lost_) {
        notes_.emplace_back("the headset's tracking is lost: the last place of the head is held");
    } else if (head.tracked && tracking_lost_) {
        notes_.emplace_back("the headset is tracked again");
    }
    tracking_lost_ = !head.tracked;
}

XrMotion Headset::with_velocity(XrMotion in_base) const {
    if (in_base.tracked && !in_base.measured) {
        in_base.velocity = link_->mean_velocity;
    }
    return in_base;
}

XrMotion Headset::in_vehicle(const XrMotion& in_base) const {
    const XrPlace turned = XrPlace{{}, vehicle_from_seat_} * vehicle_from_base_;
    return {turned * in_base.place, turned.orientation * in_base.velocity, in_base.tracked, in_base.measured};
}

XrMotion Headset::head_after(double seconds) {
    if (!link_) {
        return {};
    }
    try {
        return in_vehicle(with_velocity(link_->session.head(link_->frame.display_time + std::llround(1e9 * seconds))));
    } catch (const XrFailure& failure) {
        lose(failure.what());
        return {};
    }
}

void Headset::recentre() {
    if (!link_) {
        return;
    }
    XrPlace base_from_seat{link_->base_from_head.position, yaw_of(link_->base_from_head.orientation)};
    if (base_ == input::XrBase::stage) {
        base_from_seat.position.y = seat_eye_height; // the floor stays where it is
    }
    vehicle_from_base_ = inverse(base_from_seat);
    if (std::exchange(seated_, true)) {
        notes_.emplace_back("recentred: you sit here and look ahead");
    }
}

void Headset::turn_view(double angle) {
    if (!link_) {
        return;
    }
    const glm::dvec3 head = (vehicle_from_base_ * link_->base_from_head).position; // in the seat
    const glm::dquat turn = glm::angleAxis(angle, glm::dvec3(0.0, 1.0, 0.0));
    vehicle_from_base_ = XrPlace{head - turn * head, turn} * vehicle_from_base_;
}

void Headset::shake(double amplitude) {
    if (!link_) {
        return;
    }
    try {
        link_->actions.shake(amplitude);
    } catch (const XrFailure& failure) {
        lose(failure.what());
    }
}

void Headset::end_frame(render::Renderer& renderer, const Flight& flight, const sim::VehicleState& ship,
                        const PictureSettings& picture, const input::RoomScale& scale, const EyeOverlay& overlay,
                        double elapsed_seconds) {
    if (!link_) {
        return;
    }
    try {
        Link& link = *link_;
        if (!link.frame.shown) {
            link.session.end_frame(link.frame, {});
            return;
        }
        const input::XrEyes eyes = link.session.eyes(link.frame.display_time);
        const std::array<EyeScreen, 2> screens = link.pictures.screens(eyes);
        const sim::ControlFrame demand = input::with_head(flight.control(), link.head, scale);
        const std::array<render::EyeView, 2> views =
            eye_views(ship, demand, flight.metres_per_light_unit(), eyes, screens);
        std::array<render::RenderFrame, 2> frames;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            frames.at(i) = build_frame(flight, ship, demand.vehicle_from_head, picture, elapsed_seconds);
            frames.at(i).eye = views.at(i);
            frames.at(i).exposure.stops += static_cast<float>(std::log2(brightness_));
        }
        std::array<render::CabinView, 2> in_vehicle;
        for (std::size_t i = 0; i < in_vehicle.size(); ++i) {
            const XrPlace eye = link.head.place * eyes.at(i).head_from_eye;
            const EyeScreen& screen = screens.at(i);
            in_vehicle.at(i) = {
                eye.position, eye.orientation, {screen.left(), screen.right(), screen.down(), screen.up()}};
        }
        link.pictures.draw(renderer, eyes, frames, screens, in_vehicle, overlay);
        link.pictures.hand_over();
        const std::array layers{link.pictures.layer(link.session, link.base_from_head, eyes)};
        link.session.end_frame(link.frame, layers);
        pose_to_submit_seconds_ = std::chrono::duration<double>(Clock::now() - link.pose_asked).count();
    } catch (const XrFailure& failure) {
        lose(failure.what());
    }
}

const EyePictures& Headset::pictures() const {
    return link_->pictures;
}

std::vector<std::string> Headset::take_notes() {
    return std::exchange(notes_, {});
}

void Headset::close() {
    if (!link_) {
        return;
    }
    try {
        Link& link = *link_;
        link.session.request_exit();
        const Clock::time_point deadline = Clock::now() + longest_farewell;
        while (!link.session.ended() && Clock::now() < deadline) {
            link.session.poll();
            if (link.session.running()) {
                link.session.end_frame(link.session.begin_frame(), {});
            } else {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }
    } catch (const XrFailure&) {
        // It is going away in any case.
    }
    link_.reset();
    over_ = true;
}

} // namespace engine
