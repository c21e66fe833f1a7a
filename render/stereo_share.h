#pragma once

#include "render/colour/frame_colour_table.h"
#include "render/raycast/lanes.h"
#include "render/render_frame.h"

#include <glm/vec4.hpp>

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace render {

/// What both eyes of a moment share: found when the first eye is drawn, used for the second. Always the exposure. Where
/// both eyes look the same way, on one grid of pixels, also all that is infinitely far: the sky, ray by ray, the
/// stars, and the colours that D makes of light. Scenery is near: it is each eye's own. The pictures are the
/// same as if nothing had been shared, but for the exposure and where the colours' table is sampled.
class StereoShare {
  public:
    /// Begins a moment. `whole`: a view that looks as both eyes do and whose screen covers theirs; none where they look
    /// different ways. Sizes and distances from the axis of all three screens are multiples of four pixels.
    void begin(const std::optional<EyeView>& whole);

    /// Of the first eye; none until it is drawn.
    std::optional<double> pre_exposure;
    std::optional<double> factor;
    std::optional<FrameColourTable> colours; ///< over the D of `whole`

    const std::optional<EyeView>& whole() const { return whole_; }

    /// The sky's light in four by four pixels, and in which of them it is known.
    struct Sky {
        Lanes3 light;
        LaneMask known = 0;
    };
    /// Of the pixels of an eye's picture with their lower left corner at (left, bottom). One thread at a time each.
    Sky& sky(const EyeView& eye, int left, int bottom);
    /// Where an eye's picture begins in that of `whole`, pixels from the lower left corner.
    glm::ivec2 corner(const EyeView& eye) const;

    std::vector<glm::vec4> stars; ///< of `whole`, as StarSheet draws them; empty until they are drawn

    /// Pixels of sky since begin(): cast, and taken over from the other eye.
    std::atomic<std::int64_t> sky_cast{0};
    std::atomic<std::int64_t> sky_reused{0};

  private:
    std::optional<EyeView> whole_;
    int columns_ = 0;
    std::vector<Sky> sky_;
};

} // namespace render
