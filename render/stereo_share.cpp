#include "render/stereo_share.h"

#include "render/eye_ray.h"

#include <cmath>

namespace render {
namespace {

constexpr int packet_side = 4;

/// Where the eye's axis meets its screen, pixels from the lower left corner.
glm::ivec2 axis_from_below(const EyeView& eye) {
    const glm::dvec2 axis = axis_pixel(eye);
    return {static_cast<int>(std::lround(axis.x)), static_cast<int>(std::lround(eye.height - axis.y))};
}

} // namespace

void StereoShare::begin(const std::optional<EyeView>& whole) {
    whole_ = whole;
    pre_exposure.reset();
    factor.reset();
    colours.reset();
    stars.clear();
    sky_cast = 0;
    sky_reused = 0;
    columns_ = 0;
    if (whole_) {
        columns_ = whole_->width / packet_side;
        sky_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(whole_->height / packet_side));
        for (Sky& packet : sky_) {
            packet.known = 0;
        }
    }
}

glm::ivec2 StereoShare::corner(const EyeView& eye) const {
    return axis_from_below(*whole_) - axis_from_below(eye);
}

StereoShare::Sky& StereoShare::sky(const EyeView& eye, int left, int bottom) {
    const glm::ivec2 at = (corner(eye) + glm::ivec2(left, bottom)) / packet_side;
    return sky_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(at.x)];
}

} // namespace render
