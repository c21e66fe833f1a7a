#pragma once

#include "content/generator/mesh_builder.h"
#include "content/scene_desc.h"

/// Pictures of windows, doors and shop fronts, several in one, and where each lies.
namespace content::generator {

Image opening_image();
TextureArea window_area(int variant); ///< 4 variants, in opening_image
TextureArea door_area(int variant);   ///< 2 variants, in opening_image

Image shop_image();
TextureArea shop_area(int variant); ///< 2 variants, four times as wide as high

Image church_image();
TextureArea rose_window_area();
TextureArea clock_area();
TextureArea portal_area();
TextureArea lancet_area();

} // namespace content::generator
