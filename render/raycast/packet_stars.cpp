#include "render/raycast/packet_stars.h"

#include <tbb/parallel_for.h>

namespace render {
namespace {

/// `row`: from the bottom.
void add_to_sky(LightPackets& packets, int column, int row, const glm::vec3& light) {
    const std::size_t packet = packets.packet(column, row);
    const int lane = packet_side * (row % packet_side) + column % packet_side;
    if (has(packets.sky[packet], lane)) {
        packets.light[packet].x[lane] += light.x;
        packets.light[packet].y[lane] += light.y;
        packets.light[packet].z[lane] += light.z;
    }
}

/// The stars of both eyes, drawn for the first of them.
void add_shared_stars(const StarSheet& stars, const RenderFrame& frame, double pre_exposure, StereoShare& share,
                      LightPackets& packets) {
    const EyeView& whole = *share.whole();
    if (share.stars.empty()) {
        RenderFrame both = frame;
        both.eye = whole;
        stars.draw(both, pre_exposure, faintest_star_shown, share.stars);
    }
    const glm::ivec2 corner = share.corner(frame.eye);
    tbb::parallel_for(0, packets.height, [&](int row) {
        const glm::vec4* const first = &share.stars[static_cast<std::size_t>(whole.height - 1 - corner.y - row) *
                                                        static_cast<std::size_t>(whole.width) +
                                                    static_cast<std::size_t>(corner.x)];
        for (int column = 0; column < packets.width; ++column) {
            add_to_sky(packets, column, row, glm::vec3(first[column]));
        }
    });
}

} // namespace

void add_stars(const StarSheet& stars, const RenderFrame& frame, double pre_exposure, StereoShare* share,
               LightPackets& packets) {
    if (share != nullptr && share->whole()) {
        add_shared_stars(stars, frame, pre_exposure, *share, packets);
        return;
    }
    stars.for_each_share(frame, pre_exposure, faintest_star_shown,
                         [&](int column, int row_from_top, const glm::vec3& light) {
                             add_to_sky(packets, column, packets.height - 1 - row_from_top, light);
                         });
}

} // namespace render
