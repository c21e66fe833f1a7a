#pragma once

#include <algorithm>

namespace render {

/// A place in a row or a column of cells, between the centres of two neighbours.
struct Between {
    int first = 0;
    int second = 0;
    float share = 0.0f; ///< of the second

    /// `place`: in cells, whose centres lie at halves; held beyond the outermost. `count` of them.
    Between(float place, int count) {
        const float from_first_centre = std::clamp(place - 0.5f, 0.0f, static_cast<float>(count - 1));
        first = static_cast<int>(from_first_centre);
        second = std::min(first + 1, count - 1);
        share = from_first_centre - static_cast<float>(first);
    }
};

} // namespace render
