#include "input/xr_actions.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <vector>

namespace input {

struct XrFlightActions::Definition {
    XrActionType type;
    const char* name;       ///< OpenXR's: lower case
    const char* for_people; ///< shown by the runtime's own table of controls
};

struct XrFlightActions::Suggestion {
    Kind action;
    const char* path;
};

const std::array<XrFlightActions::Definition, XrFlightActions::count>& XrFlightActions::definitions() {
    static constexpr std::array<Definition, count> table{{
        {XR_ACTION_TYPE_FLOAT_INPUT, "thrust_ahead", "Thrust ahead"},
        {XR_ACTION_TYPE_FLOAT_INPUT, "thrust_back", "Thrust back"},
        {XR_ACTION_TYPE_VECTOR2F_INPUT, "thrust_aside", "Thrust aside"},
        {XR_ACTION_TYPE_VECTOR2F_INPUT, "turn", "Turn"},
        {XR_ACTION_TYPE_FLOAT_INPUT, "roll_left", "Roll left"},
        {XR_ACTION_TYPE_FLOAT_INPUT, "roll_right", "Roll right"},
        {XR_ACTION_TYPE_BOOLEAN_INPUT, "boost", "Boost"},
        {XR_ACTION_TYPE_BOOLEAN_INPUT, "brake", "Brake to rest"},
        {XR_ACTION_TYPE_BOOLEAN_INPUT, "recentre", "Recentre"},
        {XR_ACTION_TYPE_BOOLEAN_INPUT, "menu", "Menu"},
        {XR_ACTION_TYPE_FLOAT_INPUT, "select", "Select"},
        {XR_ACTION_TYPE_POSE_INPUT, "aim", "Pointer"},
        {XR_ACTION_TYPE_VIBRATION_OUTPUT, "thrust_felt", "Thrust felt"},
    }};
    return table;
}

XrFlightActions::XrFlightActions(const XrFlightSession& session) : session_(session) {
    const XrRuntime& runtime = session.runtime();
    const XrFunctions& xr = runtime.call();
    XrActionSetCreateInfo set{XR_TYPE_ACTION_SET_CREATE_INFO, nullptr, {}, {}, 0};
    fmt::format_to_n(set.actionSetName, XR_MAX_ACTION_SET_NAME_SIZE - 1, "flight");
    fmt::format_to_n(set.localizedActionSetName, XR_MAX_LOCALIZED_ACTION_SET_NAME_SIZE - 1, "Flight");
    runtime.check(xr.xrCreateActionSet(runtime.instance(), &set, &set_), "xrCreateActionSet");
    try {
        for (std::size_t i = 0; i < count; ++i) {
            const Definition& definition = definitions().at(i);
            XrActionCreateInfo info{XR_TYPE_ACTION_CREATE_INFO, nullptr, {}, definition.type, 0, nullptr, {}};
            fmt::format_to_n(info.actionName, XR_MAX_ACTION_NAME_SIZE - 1, "{}", definition.name);
            fmt::format_to_n(info.localizedActionName, XR_MAX_LOCALIZED_ACTION_NAME_SIZE - 1, "{}",
                             definition.for_people);
            runtime.check(xr.xrCreateAction(set_, &info, &actions_.at(i)), "xrCreateAction");
        }
        suggest_bindings();
        const XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 1, &set_};
        runtime.check(xr.xrAttachSessionActionSets(session.handle(), &attach), "xrAttachSessionActionSets");
        const XrActionSpaceCreateInfo space{XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, actions_[aim], XR_NULL_PATH,
                                            pose_of({})};
        runtime.check(xr.xrCreateActionSpace(session.handle(), &space, &aim_space_), "xrCreateActionSpace");
    } catch (...) {
        xr.xrDestroyActionSet(set_);
        throw;
    }
}

XrFlightActions::~XrFlightActions() {
    session_.runtime().call().xrDestroyActionSet(set_); // and its actions; the space goes with the session
}

void XrFlightActions::suggest_bindings() const {
    struct Profile {
        const char* path;
        std::vector<Suggestion> bindings;
    };
    const std::vector<Suggestion> everywhere{{aim, "/user/hand/right/input/aim/pose"},
                                             {haptic, "/user/hand/left/output/haptic"},
                                             {haptic, "/user/hand/right/output/haptic"}};
    const std::vector<Suggestion> triggers{{thrust_ahead, "/user/hand/right/input/trigger/value"},
                                           {thrust_back, "/user/hand/left/input/trigger/value"},
                                           {select, "/user/hand/right/input/trigger/value"}};
    const std::vector<Suggestion> thumbsticks{{thrust_aside, "/user/hand/right/input/thumbstick"},
                                              {turn, "/user/hand/left/input/thumbstick"}};
    const std::vector<Suggestion> squeezes{{roll_left, "/user/hand/left/input/squeeze/value"},
                                           {roll_right, "/user/hand/right/input/squeeze/value"}};
    const std::vector<Suggestion> menus{{menu, "/user/hand/left/input/menu/click"},
                                        {recentre, "/user/hand/right/input/menu/click"}};
    const std::vector<Suggestion> grips{{boost, "/user/hand/right/input/squeeze/click"},
                                        {brake, "/user/hand/left/input/squeeze/click"}};
    const std::vector<Suggestion> letters{{boost, "/user/hand/right/input/a/click"},
                                          {brake, "/user/hand/right/input/b/click"}};
    const auto joined = [&everywhere](std::initializer_list<std::vector<Suggestion>> parts) {
        std::vector<Suggestion> all = everywhere;
        for (const std::vector<Suggestion>& part : parts) {
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    };
    const std::array<Profile, 5> profiles{{
        {"/interaction_profiles/khr/simple_controller", joined({menus,
                                                                {{thrust_ahead, "/user/hand/right/input/select/click"},
                                                                 {thrust_back, "/user/hand/left/input/select/click"},
                                                                 {select, "/user/hand/right/input/select/click"}}})},
        {"/interaction_profiles/valve/index_controller",
         joined({triggers,
                 thumbsticks,
                 squeezes,
                 letters,
                 {{menu, "/user/hand/left/input/b/click"}, {recentre, "/user/hand/left/input/a/click"}}})},
        {"/interaction_profiles/oculus/touch_controller",
         joined({triggers,
                 thumbsticks,
                 squeezes,
                 letters,
                 {{menu, "/user/hand/left/input/menu/click"}, {recentre, "/user/hand/left/input/x/click"}}})},
        {"/interaction_profiles/htc/vive_controller",
         joined({triggers,
                 menus,
                 grips,
                 {{thrust_aside, "/user/hand/right/input/trackpad"}, {turn, "/user/hand/left/input/trackpad"}}})},
        {"/interaction_profiles/microsoft/motion_controller", joined({triggers, thumbsticks, menus, grips})},
    }};
    const XrRuntime& runtime = session_.runtime();
    for (const Profile& profile : profiles) {
        std::vector<XrActionSuggestedBinding> bindings;
        for (const Suggestion& suggestion : profile.bindings) {
            bindings.push_back({actions_.at(suggestion.action), runtime.path(suggestion.path)});
        }
        const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, nullptr,
                                                        runtime.path(profile.path),
                                                        static_cast<std::uint32_t>(bindings.size()), bindings.data()};
        const XrResult result = runtime.call().xrSuggestInteractionProfileBindings(runtime.instance(), &info);
        if (result != XR_ERROR_PATH_UNSUPPORTED) { // a runtime that does not know this controller
            runtime.check(result, "xrSuggestInteractionProfileBindings");
        }
    }
}

XrActionStateFloat XrFlightActions::number(Kind action) const {
    const XrActionStateGetInfo wanted{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, actions_.at(action), XR_NULL_PATH};
    XrActionStateFloat state{XR_TYPE_ACTION_STATE_FLOAT, nullptr, 0.0F, XR_FALSE, 0, XR_FALSE};
    const XrRuntime& runtime = session_.runtime();
    runtime.check(runtime.call().xrGetActionStateFloat(session_.handle(), &wanted, &state), "xrGetActionStateFloat");
    return state;
}

XrActionStateVector2f XrFlightActions::stick(Kind action) const {
    const XrActionStateGetInfo wanted{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, actions_.at(action), XR_NULL_PATH};
    XrActionStateVector2f state{XR_TYPE_ACTION_STATE_VECTOR2F, nullptr, {}, XR_FALSE, 0, XR_FALSE};
    const XrRuntime& runtime = session_.runtime();
    runtime.check(runtime.call().xrGetActionStateVector2f(session_.handle(), &wanted, &state),
                  "xrGetActionStateVector2f");
    return state;
}

XrActionStateBoolean XrFlightActions::button(Kind action) const {
    const XrActionStateGetInfo wanted{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, actions_.at(action), XR_NULL_PATH};
    XrActionStateBoolean state{XR_TYPE_ACTION_STATE_BOOLEAN, nullptr, XR_FALSE, XR_FALSE, 0, XR_FALSE};
    const XrRuntime& runtime = session_.runtime();
    runtime.check(runtime.call().xrGetActionStateBoolean(session_.handle(), &wanted, &state),
                  "xrGetActionStateBoolean");
    return state;
}

XrControllers XrFlightActions::read() {
    const XrRuntime& runtime = session_.runtime();
    const XrActiveActionSet active{set_, XR_NULL_PATH};
    const XrActionsSyncInfo info{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
    const XrResult synced = runtime.call().xrSyncActions(session_.handle(), &info);
    runtime.check(synced, "xrSyncActions");
    XrControllers hands;
    if (synced == XR_SESSION_NOT_FOCUSED) {
        return hands;
    }
    const XrActionStateFloat ahead = number(thrust_ahead);
    const XrActionStateFloat back = number(thrust_back);
    if (ahead.isActive == XR_TRUE || back.isActive == XR_TRUE) {
        GamepadState pad;
        pad.name = "headset's controllers";
        const auto axis = [&pad](GamepadAxis which) -> float& { return pad.axes.at(static_cast<std::size_t>(which)); };
        const auto press = [&pad](GamepadButton which, bool down) {
            pad.buttons.at(static_cast<std::size_t>(which)) = down;
        };
        const auto trigger = [](float value) { return 2.0F * value - 1.0F; };
        axis(GamepadAxis::right_trigger) = trigger(ahead.currentState);
        axis(GamepadAxis::left_trigger) = trigger(back.currentState);
        // A gamepad's sticks grow downwards, OpenXR's upwards.
        const XrVector2f aside = stick(thrust_aside).currentState;
        axis(GamepadAxis::right_x) = aside.x;
        axis(GamepadAxis::right_y) = -aside.y;
        const XrVector2f turned = stick(turn).currentState;
        axis(GamepadAxis::left_x) = turned.x;
        axis(GamepadAxis::left_y) = -turned.y;
        press(GamepadButton::left_bumper, number(roll_left).currentState > 0.5F);
        press(GamepadButton::right_bumper, number(roll_right).currentState > 0.5F);
        press(GamepadButton::a, button(boost).currentState == XR_TRUE);
        press(GamepadButton::b, button(brake).currentState == XR_TRUE);
        hands.gamepad = pad;
    }
    const auto pressed = [this](Kind action) {
        const XrActionStateBoolean state = button(action);
        return state.isActive == XR_TRUE && state.currentState == XR_TRUE && state.changedSinceLastSync == XR_TRUE;
    };
    hands.recentre = pressed(recentre);
    hands.menu = pressed(menu);
    hands.select = static_cast<double>(number(select).currentState);
    return hands;
}

XrMotion XrFlightActions::pointer(XrTime time) const {
    return session_.locate(aim_space_, time);
}

void XrFlightActions::shake(double amplitude) {
    const XrRuntime& runtime = session_.runtime();
    const XrHapticActionInfo action{XR_TYPE_HAPTIC_ACTION_INFO, nullptr, actions_[haptic], XR_NULL_PATH};
    if (amplitude > 0.0) {
        const XrHapticVibration vibration{XR_TYPE_HAPTIC_VIBRATION, nullptr, 100'000'000, XR_FREQUENCY_UNSPECIFIED,
                                          static_cast<float>(std::min(amplitude, 1.0))};
        runtime.check(runtime.call().xrApplyHapticFeedback(session_.handle(), &action,
                                                           reinterpret_cast<const XrHapticBaseHeader*>(&vibration)),
                      "xrApplyHapticFeedback");
    } else if (shaking_) {
        runtime.check(runtime.call().xrStopHapticFeedback(session_.handle(), &action), "xrStopHapticFeedback");
    }
    shaking_ = amplitude > 0.0;
}

} // namespace input
