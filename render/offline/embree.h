#pragma once

#include <memory>
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

/// Owners of Embree's objects, and its queries in the words of either version.
namespace render {

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct GeometryRelease {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using DeviceHandle = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using SceneHandle = std::unique_ptr<RTCSceneTy, SceneRelease>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, GeometryRelease>;

// Embree 3 (Debian 12) wants a context with each query, Embree 4 (Debian 13) none.
inline void intersect(RTCScene tree, RTCRayHit& query) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(tree, &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(tree, &context, &query);
#endif
}

inline bool occluded(RTCScene tree, RTCRay ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(tree, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(tree, &context, &ray);
#endif
    return ray.tfar < 0.0f;
}

// Packets of rays that go much the same way.
inline void intersect(RTCScene tree, const int* valid, RTCRayHit16& query) {
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect16(valid, tree, &query, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, tree, &context, &query);
#endif
}

inline void occlude(RTCScene tree, const int* valid, RTCRay16& query) {
#if RTC_VERSION_MAJOR >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcOccluded16(valid, tree, &query, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(valid, tree, &context, &query);
#endif
}

} // namespace render
