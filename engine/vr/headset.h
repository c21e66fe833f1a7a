#pragma once

#include "engine/frame_builder.h"
#include "engine/option_values.h"
#include "engine/vr/eye_pictures.h"
#include "input/xr_actions.h"
#include "input/xr_session.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace engine {

/// What a frame of the headset begins with.
struct HeadsetFrame {
    double elapsed_seconds = 0.0; ///< from when the last frame was seen to when this one will be; 0 for the first
    input::XrControllers controllers;
    input::XrMotion head;    ///< in the vehicle, when this frame will be seen
    input::XrMotion pointer; ///< of the right hand, in the vehicle
    bool shown = false;      ///< a picture is wanted
};

/// A headset in a flight: found, lost and found again, while whoever flies goes on.
class Headset {
  public:
    /// Needs the OpenGL context current that the pictures are drawn with, as for all that follows. Throws
    /// input::XrFailure when there is no headset now.
    /// `eye_size`: pixels of an eye's picture, instead of what the runtime recommends.
    explicit Headset(input::XrBase base, const std::optional<PictureSize>& eye_size = {});
    ~Headset();
    Headset(const Headset&) = delete;
    Headset& operator=(const Headset&) = delete;

    /// Waits until it is time for the next frame and begins it; none while there is no headset or it wants no frames,
    /// and then nothing is waited for. A lost headset is looked for again every other second.
    std::optional<HeadsetFrame> begin_frame();
    /// Draws what both eyes see, `overlay` over each (may be empty), and ends the frame: `ship` at the moment of the
    /// frame.
    void end_frame(render::Renderer& renderer, const Flight& flight, const sim::VehicleState& ship,
                   const PictureSettings& picture, const input::RoomScale& scale, const EyeOverlay& overlay,
                   double elapsed_seconds);
    /// The head in the vehicle so many seconds after this frame is seen (negative: before).
    input::XrMotion head_after(double seconds);

    /// The seat is where the head is now, ahead is where it looks.
    void recentre();
    /// Turns the pilot's room about the head, to the left, radians: a snap turn.
    void turn_view(double angle);
    /// How the seat is turned in the ship from the next frame on: it takes the pilot's room along.
    void set_vehicle_from_seat(const glm::dquat& rotation) { vehicle_from_seat_ = rotation; }
    /// The thrust that the hands feel, in [0, 1].
    void shake(double amplitude);

    /// There is a headset now.
    bool present() const { return link_ != nullptr; }
    /// The pilot, or the runtime, ended the session for good.
    bool over() const { return over_; }
    /// Frames begun while tracking was lost: the last place of the head is held and the pictures are dimmed.
    bool tracking_lost() const { return tracking_lost_; }
    /// From asking where the head is to handing over the pictures for it, in the last frame that was shown.
    double pose_to_submit_seconds() const { return pose_to_submit_seconds_; }
    /// What happened since the last call, one line each.
    std::vector<std::string> take_notes();
    /// The eyes' pictures; only while present().
    const EyePictures& pictures() const;

    /// Asks the runtime to end the session and waits for it, for two seconds at most.
    void close();

  private:
    struct Link;
    using Clock = std::chrono::steady_clock;

    void connect();
    std::optional<HeadsetFrame> try_begin_frame();
    void lose(const std::string& why);
    input::XrMotion with_velocity(input::XrMotion in_base) const;
    input::XrMotion in_vehicle(const input::XrMotion& in_base) const;
    void follow_tracking(const input::XrMotion& head);

    input::XrBase base_;
    std::optional<PictureSize> eye_size_;
    std::unique_ptr<Link> link_;
    input::XrPlace vehicle_from_base_; ///< the seat's axes for the vehicle's: vehicle_from_seat_ comes on top
    glm::dquat vehicle_from_seat_{1.0, 0.0, 0.0, 0.0};
    bool seated_ = false; ///< recentred at least once since the headset was found
    bool tracking_lost_ = false;
    double brightness_ = 1.0;
    double pose_to_submit_seconds_ = 0.0;
    bool over_ = false;
    Clock::time_point look_again_;
    std::vector<std::string> notes_;
};

} // namespace engine
