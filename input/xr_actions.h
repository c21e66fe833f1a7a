#pragma once

#include "input/gamepad.h"
#include "input/xr_session.h"

#include <array>
#include <optional>

namespace input {

/// Both hands at one moment.
struct XrControllers {
    /// As a gamepad's sticks, triggers and buttons, so that the table of controls holds for both; none while no
    /// controller is there.
    std::optional<GamepadState> gamepad;
    bool recentre = false; ///< pressed since the last reading
    bool menu = false;     ///< pressed since the last reading
    double select = 0.0;   ///< the pointing hand's trigger, in [0, 1]
};

/// The pilot's hands in OpenXR: actions with suggested bindings for the controllers in use today.
class XrFlightActions {
  public:
    /// `session` must outlive this. Throws XrFailure.
    explicit XrFlightActions(const XrFlightSession& session);
    ~XrFlightActions();
    XrFlightActions(const XrFlightActions&) = delete;
    XrFlightActions& operator=(const XrFlightActions&) = delete;

    /// Samples the controllers. While the session is not focused there are none.
    XrControllers read();
    /// Where the right hand points (-z) in the base space; not `tracked`: there is none.
    XrMotion pointer(XrTime time) const;
    /// Both controllers shake, in [0, 1]; 0 stops them. Until it is said again, a tenth of a second at most.
    void shake(double amplitude);

  private:
    enum Kind : std::size_t {
        thrust_ahead,
        thrust_back,
        thrust_aside,
        turn,
        roll_left,
        roll_right,
        boost,
        brake,
        recentre,
        menu,
        select,
        aim,
        haptic,
        count
    };
    struct Definition;
    struct Suggestion;
    static const std::array<Definition, count>& definitions();

    void suggest_bindings() const;
    XrActionStateFloat number(Kind action) const;
    XrActionStateVector2f stick(Kind action) const;
    XrActionStateBoolean button(Kind action) const;

    const XrFlightSession& session_;
    XrActionSet set_ = XR_NULL_HANDLE;
    std::array<XrAction, count> actions_{};
    XrSpace aim_space_ = XR_NULL_HANDLE;
    bool shaking_ = false;
};

} // namespace input
