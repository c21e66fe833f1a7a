#include "input/xr_swapchain.h"

#include "input/xr_failure.h"

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>

namespace input {
namespace {

std::int64_t chosen_format(const XrFlightSession& session, std::span<const std::int64_t> wanted) {
    const XrRuntime& runtime = session.runtime();
    std::uint32_t count = 0;
    runtime.check(runtime.call().xrEnumerateSwapchainFormats(session.handle(), 0, &count, nullptr),
                  "xrEnumerateSwapchainFormats");
    std::vector<std::int64_t> offered(count);
    runtime.check(runtime.call().xrEnumerateSwapchainFormats(session.handle(), count, &count, offered.data()),
                  "xrEnumerateSwapchainFormats");
    for (const std::int64_t format : wanted) {
        if (std::ranges::find(offered, format) != offered.end()) {
            return format;
        }
    }
    throw XrFailure(XrFailure::Cause::unsuited, "the headset takes no pictures of a format that Rapidity draws");
}

} // namespace

XrSwapchainOfTextures::XrSwapchainOfTextures(const XrFlightSession& session, int width, int height, Use use,
                                             std::span<const std::int64_t> formats)
    : runtime_(session.runtime()), width_(width), height_(height) {
    XrSwapchainCreateInfo info{};
    info.type = XR_TYPE_SWAPCHAIN_CREATE_INFO;
    info.usageFlags = use == Use::colour ? XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT
                                         : XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    info.format = chosen_format(session, formats);
    info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
    info.width = static_cast<std::uint32_t>(width);
    info.height = static_cast<std::uint32_t>(height);
    runtime_.check(runtime_.call().xrCreateSwapchain(session.handle(), &info, &swapchain_), "xrCreateSwapchain");
    std::uint32_t count = 0;
    runtime_.check(runtime_.call().xrEnumerateSwapchainImages(swapchain_, 0, &count, nullptr),
                   "xrEnumerateSwapchainImages");
    std::vector<XrSwapchainImageOpenGLKHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, 0});
    runtime_.check(runtime_.call().xrEnumerateSwapchainImages(
                       swapchain_, count, &count, reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
                   "xrEnumerateSwapchainImages");
    for (const XrSwapchainImageOpenGLKHR& image : images) {
        textures_.push_back(image.image);
    }
}

XrSwapchainOfTextures::~XrSwapchainOfTextures() {
    runtime_.call().xrDestroySwapchain(swapchain_);
}

std::uint32_t XrSwapchainOfTextures::acquire() {
    const XrSwapchainImageAcquireInfo acquire{XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO, nullptr};
    std::uint32_t index = 0;
    runtime_.check(runtime_.call().xrAcquireSwapchainImage(swapchain_, &acquire, &index), "xrAcquireSwapchainImage");
    const XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, nullptr, XR_INFINITE_DURATION};
    runtime_.check(runtime_.call().xrWaitSwapchainImage(swapchain_, &wait), "xrWaitSwapchainImage");
    return textures_.at(index);
}

void XrSwapchainOfTextures::release() {
    const XrSwapchainImageReleaseInfo release{XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO, nullptr};
    runtime_.check(runtime_.call().xrReleaseSwapchainImage(swapchain_, &release), "xrReleaseSwapchainImage");
}

} // namespace input
