#pragma once

#include "render/gl/boosted_view.h"

namespace render {

/// How far the GPU's warp is from double precision over a whole screen.
struct WarpError {
    double pixels = 0.0;       ///< largest distance between where a pixel looks and where it should
    double relative_d = 0.0;   ///< largest relative error of D
    glm::ivec2 worst_pixel{0}; ///< of `pixels`, from the lower left corner
};

/// Plans the tiles of a view, lets the GPU map every pixel into them and compares with sim::see in double precision.
/// Needs a current OpenGL 4.5 context.
WarpError warp_error(const EyeView& eye);

} // namespace render
