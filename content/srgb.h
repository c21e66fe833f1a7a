#pragma once

namespace content {

/// sRGB transfer function (IEC 61966-2-1) backwards: encoded in [0, 1] to linear in [0, 1]; clamps outside.
float linear_from_srgb(float encoded);

} // namespace content
