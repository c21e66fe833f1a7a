// An OpenXR layer that goes wrong on purpose, as the environment's RAPIDITY_FAULTS says, "name=number" separated by
// spaces. Frames are counted, from 1, as long as the process asks for the same faults.
//   lose_session=N         xrWaitFrame of frame N: XR_ERROR_SESSION_LOST
//   lose_session_soon=N    the session's state becomes LOSS_PENDING before frame N
//   lose_instance_soon=N   the runtime says that it is going away before frame N
//   stop=N                 the pilot ends the session from the runtime's own menu before frame N
//   no_headset=N           xrGetSystem finds none the first N times
//   away=N                 xrGetSystem finds none the first N times after the first session
//   no_views=1             no views
//   untracked=N            from frame N on, for `untracked_frames`, places are unknown
//   untracked_frames=N     10 unless said
//   no_controllers=N       from frame N on no controller is there

#include "tests/xr/loader_interface.h"

#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

namespace {

/// The next function down, and what has happened so far. The loader asks for plain functions: they have no other place.
struct Layer {
    PFN_xrGetInstanceProcAddr next = nullptr;
    XrInstance instance = XR_NULL_HANDLE;
    XrSession session = XR_NULL_HANDLE;
    long frame = 0;
    long systems_asked = 0;
    long systems_asked_after_session = 0;
    bool had_session = false;
    bool told = false; ///< the event of this fault
    std::string faults;
};
Layer layer;

std::string asked_faults() {
    const char* const text = std::getenv("RAPIDITY_FAULTS");
    return text != nullptr ? text : "";
}

long fault(const std::string& name) {
    std::istringstream words(layer.faults);
    for (std::string word; words >> word;) {
        if (word.starts_with(name + "=")) {
            return std::stol(word.substr(name.size() + 1));
        }
    }
    return 0;
}

/// The next frame is at or after the fault's.
bool due(const char* name) {
    const long at = fault(name);
    return at != 0 && layer.frame + 1 >= at;
}

bool once(const char* name) {
    if (layer.told || !due(name)) {
        return false;
    }
    layer.told = true;
    return true;
}

template <class Function>
Function next(const char* name) {
    PFN_xrVoidFunction function = nullptr;
    layer.next(layer.instance, name, &function);
    return reinterpret_cast<Function>(function);
}

XRAPI_ATTR XrResult XRAPI_CALL get_system(XrInstance instance, const XrSystemGetInfo* info, XrSystemId* system) {
    if (++layer.systems_asked <= fault("no_headset") ||
        (layer.had_session && ++layer.systems_asked_after_session <= fault("away"))) {
        return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
    }
    return next<PFN_xrGetSystem>("xrGetSystem")(instance, info, system);
}

XRAPI_ATTR XrResult XRAPI_CALL enumerate_views(XrInstance instance, XrSystemId system, XrViewConfigurationType type,
                                               std::uint32_t capacity, std::uint32_t* count,
                                               XrViewConfigurationView* views) {
    if (fault("no_views") != 0) {
        *count = 0;
        return XR_SUCCESS;
    }
    return next<PFN_xrEnumerateViewConfigurationViews>("xrEnumerateViewConfigurationViews")(instance, system, type,
                                                                                            capacity, count, views);
}

XRAPI_ATTR XrResult XRAPI_CALL create_session(XrInstance instance, const XrSessionCreateInfo* info,
                                              XrSession* session) {
    const XrResult result = next<PFN_xrCreateSession>("xrCreateSession")(instance, info, session);
    layer.session = *session;
    layer.had_session = true;
    return result;
}

XRAPI_ATTR XrResult XRAPI_CALL poll_event(XrInstance instance, XrEventDataBuffer* event) {
    if (once("lose_session_soon")) {
        const XrEventDataSessionStateChanged change{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr, layer.session,
                                                    XR_SESSION_STATE_LOSS_PENDING, 0};
        std::memcpy(event, &change, sizeof(change));
        return XR_SUCCESS;
    }
    if (once("lose_instance_soon")) {
        const XrEventDataInstanceLossPending loss{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING, nullptr, 0};
        std::memcpy(event, &loss, sizeof(loss));
        return XR_SUCCESS;
    }
    if (once("stop")) {
        next<PFN_xrRequestExitSession>("xrRequestExitSession")(layer.session);
    }
    return next<PFN_xrPollEvent>("xrPollEvent")(instance, event);
}

XRAPI_ATTR XrResult XRAPI_CALL wait_frame(XrSession session, const XrFrameWaitInfo* info, XrFrameState* state) {
    if (once("lose_session")) {
        return XR_ERROR_SESSION_LOST;
    }
    ++layer.frame;
    return next<PFN_xrWaitFrame>("xrWaitFrame")(session, info, state);
}

XRAPI_ATTR XrResult XRAPI_CALL locate_space(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* location) {
    const XrResult result = next<PFN_xrLocateSpace>("xrLocateSpace")(space, base, time, location);
    const long first = fault("untracked");
    const long frames = fault("untracked_frames") != 0 ? fault("untracked_frames") : 10;
    if (first != 0 && layer.frame >= first && layer.frame < first + frames) {
        location->locationFlags = 0;
        location->pose = {{0.0F, 0.0F, 0.0F, 0.0F}, {1e9F, 1e9F, 1e9F}}; // nobody may use it
    }
    return result;
}

/// Of every kind of action: nobody holds a controller.
template <class Function, class State>
XrResult action_state(const char* name, XrSession session, const XrActionStateGetInfo* info, State* state) {
    const XrResult result = next<Function>(name)(session, info, state);
    if (due("no_controllers")) {
        state->isActive = XR_FALSE;
        state->currentState = {};
        state->changedSinceLastSync = XR_FALSE;
    }
    return result;
}

XRAPI_ATTR XrResult XRAPI_CALL state_boolean(XrSession session, const XrActionStateGetInfo* info,
                                             XrActionStateBoolean* state) {
    return action_state<PFN_xrGetActionStateBoolean>("xrGetActionStateBoolean", session, info, state);
}
XRAPI_ATTR XrResult XRAPI_CALL state_float(XrSession session, const XrActionStateGetInfo* info,
                                           XrActionStateFloat* state) {
    return action_state<PFN_xrGetActionStateFloat>("xrGetActionStateFloat", session, info, state);
}
XRAPI_ATTR XrResult XRAPI_CALL state_vector(XrSession session, const XrActionStateGetInfo* info,
                                            XrActionStateVector2f* state) {
    return action_state<PFN_xrGetActionStateVector2f>("xrGetActionStateVector2f", session, info, state);
}

struct Override {
    const char* name;
    PFN_xrVoidFunction function;
};

XRAPI_ATTR XrResult XRAPI_CALL get_instance_proc_addr(XrInstance instance, const char* name,
                                                      PFN_xrVoidFunction* function) {
    const Override overrides[] = {
        {"xrGetInstanceProcAddr", reinterpret_cast<PFN_xrVoidFunction>(&get_instance_proc_addr)},
        {"xrGetSystem", reinterpret_cast<PFN_xrVoidFunction>(&get_system)},
        {"xrEnumerateViewConfigurationViews", reinterpret_cast<PFN_xrVoidFunction>(&enumerate_views)},
        {"xrCreateSession", reinterpret_cast<PFN_xrVoidFunction>(&create_session)},
        {"xrPollEvent", reinterpret_cast<PFN_xrVoidFunction>(&poll_event)},
        {"xrWaitFrame", reinterpret_cast<PFN_xrVoidFunction>(&wait_frame)},
        {"xrLocateSpace", reinterpret_cast<PFN_xrVoidFunction>(&locate_space)},
        {"xrGetActionStateBoolean", reinterpret_cast<PFN_xrVoidFunction>(&state_boolean)},
        {"xrGetActionStateFloat", reinterpret_cast<PFN_xrVoidFunction>(&state_float)},
        {"xrGetActionStateVector2f", reinterpret_cast<PFN_xrVoidFunction>(&state_vector)},
    };
    for (const Override& entry : overrides) {
        if (std::strcmp(entry.name, name) == 0) {
            *function = entry.function;
            return XR_SUCCESS;
        }
    }
    return layer.next(instance, name, function);
}

XRAPI_ATTR XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo* info,
                                               const xr_loader::CreateInfo* layer_info, XrInstance* instance) {
    xr_loader::CreateInfo further = *layer_info;
    further.next_info = layer_info->next_info->next;
    if (layer.faults != asked_faults()) {
        layer = Layer{};
        layer.faults = asked_faults();
    }
    layer.next = layer_info->next_info->get_instance_proc_addr;
    const XrResult result = layer_info->next_info->create_api_layer_instance(info, &further, instance);
    layer.instance = *instance;
    return result;
}

} // namespace

extern "C" __attribute__((visibility("default"))) XrResult
xrNegotiateLoaderApiLayerInterface(const xr_loader::LoaderInfo* /*loader*/, const char* /*name*/,
                                   xr_loader::LayerRequest* request) {
    request->interface_version = 1;
    request->api_version = XR_MAKE_VERSION(1, 0, 0);
    request->get_instance_proc_addr = &get_instance_proc_addr;
    request->create_instance = &create_instance;
    return XR_SUCCESS;
}
