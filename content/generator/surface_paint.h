#pragma once

#include "content/scene_desc.h"

/// Pictures of surfaces. Each repeats; those called neutral are greys that a vertex colour tints. In brackets the size
/// that a picture is meant to have.
namespace content::generator {

Image asphalt_image(); ///< [8 m]
Image road_image();    ///< asphalt with gutters at both sides and a dashed centre line along y [8 m]
Image zebra_image();   ///< asphalt with white bars along y [8 m x 4 m]
Image paving_image();  ///< slabs [3 m]
Image ashlar_image();  ///< courses of dressed blocks, neutral [4 m]
Image stone_image();   ///< smooth stone, neutral [2 m]
Image plaster_image(); ///< neutral [4 m]
Image brick_image();   ///< neutral [2 m]
Image roof_image();    ///< rows of tiles, neutral [2.4 m]
Image bark_image();    ///< [1.2 m]
Image leaf_image();    ///< transparent between the leaves [1.7 m]
Image grass_image();   ///< [16 m]

} // namespace content::generator
