#include "content/srgb.h"

#include <algorithm>
#include <cmath>

namespace content {

float linear_from_srgb(float encoded) {
    const float x = std::clamp(encoded, 0.0f, 1.0f);
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

} // namespace content
