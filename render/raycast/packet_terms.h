#pragma once

#include "render/colour/frame_colour_table.h"
#include "render/raycast/lanes.h"

#include <glm/vec3.hpp>

/// Spectral terms of sixteen pixels at once: weights at rest, and light seen by the frame's colour table.
namespace render {

/// Where a packet's D lie in the frame's table. D varies slowly over the screen: most packets span less than two of the
/// table's steps, and then each term is looked up twice for all sixteen and joined linearly, as the table itself is.
struct PacketPlaces {
    Lanes place; ///< samples from the table's first
    Lanes share; ///< of the way from lowest to highest
    float lowest = 0.0f;
    float highest = 0.0f;
    bool narrow = false;
};

/// The frame's table with a packet's places in it.
struct PacketColours {
    const FrameColourTable& table;
    PacketPlaces places;
};

PacketPlaces places_of(const FrameColourTable& table, const Lanes& wavelength_ratio);

/// Where a term stands in the frame's table.
struct TermPlace {
    int layer = 0;
    bool in_alphas = false; ///< of this layer and the two after it
};
/// Of term `term` of a group without hues, whose layers begin at `first_layer`.
TermPlace place_of_term(int first_layer, int term);

/// Adds the light seen of a term, by the lanes' weights.
void add_term(const PacketColours& colours, const TermPlace& term, const Lanes& weight, Lanes3& light);
void add_term(const PacketColours& colours, int first_layer, int term, const Lanes& weight, Lanes3& light);

/// Adds linear RGB of the scene's light: by a group's three primaries, or, in geometry, as it stands.
void add_radiance(const PacketColours& colours, int first_layer, const Lanes3& rgb, Lanes3& light);

/// Coloured product; nothing in lanes whose `share` is 0.
void lit_colours(const Lanes3& reflectance, const Lanes3& received, const Lanes& share, Lanes3& rgb);

/// What falls on surfaces of some lanes and is sent on: coloured product, features times luminance
/// (shared/reflectance.glsl) and the luminance itself; nothing in lanes whose `share` is 0.
struct LitLanes {
    Lanes3 rgb;
    Lanes3 features;
    Lanes luminance;
};
void light_surfaces(const Lanes3& reflectance, const Lanes3& received, const Lanes& share, LitLanes& lit);

void luminance_of_lanes(const Lanes3& rgb, Lanes& luminance);

/// Adds white and hues of the group whose layers begin at `layer`, that make up linear RGB.
void add_hues(const PacketColours& colours, const HueWheel& wheel, int layer, const Lanes3& rgb, Lanes3& light);

/// Adds what surfaces of a rule without hues send on of one light, whose layers begin at `layer`; invisible bands
/// apart.
void add_lit(const PacketColours& colours, content::ReflectanceRule rule, int layer, const LitLanes& lit,
             const Lanes3& reflectance, Lanes3& light);

} // namespace render
