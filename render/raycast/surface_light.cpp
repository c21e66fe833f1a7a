#include "render/raycast/surface_light.h"

#include "render/falling_light.h"
#include "render/raycast/lane_vectors.h"
#include "render/raycast/surfaces.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace render {
namespace {

/// Finer than the isotropic filter that OpenGL prescribes, which blurs what is seen at a slant.
constexpr float level_bias = -0.5f;

RAPIDITY_VECTOR_CLONES
void place(const PacketRays& rays, const PacketHits& hits, Surfaces& surfaces) {
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 direction = lane_of(rays.direction, i);
        const glm::vec3 area = lane_of(hits.normal, i);
        set_lane(surfaces.position, i, rays.origin + hits.distance[i] * direction);
        const float turn = glm::dot(area, direction) < 0.0f ? 1.0f : -1.0f;
        set_lane(surfaces.facing, i, (turn / std::sqrt(glm::dot(area, area))) * area);
    }
}

/// Turns normals towards the eye and makes them unit; where a triangle gave none, its plane's.
RAPIDITY_VECTOR_CLONES
void finish_normals(Surfaces& surfaces) {
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 facing = lane_of(surfaces.facing, i);
        const glm::vec3 given = lane_of(surfaces.normal, i);
        const float length2 = glm::dot(given, given);
        const float scale =
            (glm::dot(given, facing) < 0.0f ? -1.0f : 1.0f) / std::sqrt(length2 > 0.0f ? length2 : 1.0f);
        const float own = length2 > 0.0f ? 0.0f : 1.0f;
        set_lane(surfaces.normal, i, scale * given + own * facing);
    }
}

/// Level of detail at which one texel of a texture of one texel a coordinate unit is as long as the pixel's footprint
/// on the surface: half the log2 of the footprint's larger eigenvalue.
RAPIDITY_VECTOR_CLONES
void footprint_levels(const PacketRays& rays, const PacketHits& hits, const Surfaces& surfaces, const Lanes& width,
                      const Lanes& height, Lanes& level) {
    for (int i = 0; i < lane_count; ++i) {
        // Two directions across the ray (Duff et al. 2017), carried along it onto the surface.
        const glm::vec3 d = lane_of(rays.direction, i);
        const float sign = std::copysign(1.0f, d.z);
        const float a = -1.0f / (sign + d.z);
        const float b = d.x * d.y * a;
        const glm::vec3 across(1.0f + sign * d.x * d.x * a, sign * b, -sign * d.x);
        const glm::vec3 up(b, sign + d.y * d.y * a, -d.y);
        const glm::vec3 n = lane_of(surfaces.facing, i);
        const float cosine = glm::dot(n, d) < -1e-4f ? glm::dot(n, d) : -1e-4f; // a grazing ray, not an endless one
        const glm::vec3 p = across - (glm::dot(n, across) / cosine) * d;
        const glm::vec3 q = up - (glm::dot(n, up) / cosine) * d;
        const float radius = hits.distance[i] * rays.spread[i];
        const glm::vec3 gs = (radius * width[i]) * lane_of(surfaces.gradient_s, i);
        const glm::vec3 gt = (radius * height[i]) * lane_of(surfaces.gradient_t, i);
        const float sp = glm::dot(gs, p);
        const float sq = glm::dot(gs, q);
        const float tp = glm::dot(gt, p);
        const float tq = glm::dot(gt, q);
        const float half_sum = 0.5f * (sp * sp + sq * sq + tp * tp + tq * tq);
        const float determinant = sp * tq - sq * tp;
        const float under_root = half_sum * half_sum - determinant * determinant;
        const float largest = half_sum + std::sqrt(under_root > 0.0f ? under_root : 0.0f);
        level[i] = 0.5f * log2_of_lane(largest > 1e-20f ? largest : 1e-20f) + level_bias;
    }
}

RAPIDITY_VECTOR_CLONES
void add_ambient(const glm::vec3& ambient, const Surfaces& surfaces, Lanes3& light) {
    for (int i = 0; i < lane_count; ++i) {
        set_lane(light, i, shared::ambient_share(surfaces.normal.y[i]) * ambient);
    }
}

RAPIDITY_VECTOR_CLONES
void sun_cosines(const Surfaces& surfaces, const glm::vec3& towards_sun, Lanes& cosine) {
    for (int i = 0; i < lane_count; ++i) {
        cosine[i] = glm::dot(lane_of(surfaces.normal, i), towards_sun);
    }
}

/// Starts of shadow rays: off the surface, on the sun's side, by more than single precision can misplace it.
template <class Towards>
inline void shadow_origins(const PacketHits& hits, const Surfaces& surfaces, const Towards& towards, Lanes3& origins) {
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 position = lane_of(surfaces.position, i);
        const glm::vec3 towards_light = towards(position);
        const glm::vec3 size = glm::abs(position);
        const float gap = 2e-4f + 2e-6f * (size.x + size.y + size.z + hits.distance[i]);
        const glm::vec3 facing = lane_of(surfaces.facing, i);
        set_lane(origins, i, position + (glm::dot(facing, towards_light) < 0.0f ? -gap : gap) * facing);
    }
}

RAPIDITY_VECTOR_CLONES
void add_sun(const Lanes& cosine, const Lanes& visible, const glm::vec3& sun_light, Lanes3& light) {
    for (int i = 0; i < lane_count; ++i) {
        set_lane(light, i, lane_of(light, i) + (cosine[i] > 0.0f ? cosine[i] * visible[i] : 0.0f) * sun_light);
    }
}

RAPIDITY_VECTOR_CLONES
void lamp_shares(const content::Lamp& lamp, const Surfaces& surfaces, Lanes& shares) {
    for (int i = 0; i < lane_count; ++i) {
        shares[i] =
            shared::lamp_share(lamp.position - lane_of(surfaces.position, i), lane_of(surfaces.normal, i), lamp.range);
    }
}

RAPIDITY_VECTOR_CLONES
void add_shares(const Lanes& shares, const Lanes& visible, const glm::vec3& intensity, Lanes3& light) {
    for (int i = 0; i < lane_count; ++i) {
        set_lane(light, i, lane_of(light, i) + (shares[i] * visible[i]) * intensity);
    }
}

/// 1 in the lanes of the mask, 0 in the others.
void shares_of(LaneMask mask, Lanes& shares) {
    for (int i = 0; i < lane_count; ++i) {
        shares[i] = has(mask, i) ? 1.0f : 0.0f;
    }
}

/// Lanes of `rest` whose materials are the same as the first one's.
template <class Same>
LaneMask alike(const Surfaces& surfaces, LaneMask rest, const Same& same) {
    const CastMaterial& first = *surfaces.materials[static_cast<std::size_t>(std::countr_zero(rest))];
    LaneMask found = 0;
    for (LaneMask left = rest; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left);
        found |= same(first, *surfaces.materials[static_cast<std::size_t>(i)]) ? 1u << static_cast<unsigned>(i) : 0u;
    }
    return found;
}

/// Component of the invisible bands, times a share, lane by lane.
void band_weights(const Surfaces& surfaces, LaneMask lanes, glm::length_t band, const Lanes& share, Lanes& weight) {
    for (int i = 0; i < lane_count; ++i) {
        weight[i] =
            has(lanes, i) ? share[i] * surfaces.materials[static_cast<std::size_t>(i)]->invisible_bands[band] : 0.0f;
    }
}

/// What the records say of each hit.
void look_up(const CastScenery& scenery, const PacketHits& hits, LaneMask wanted, Surfaces& surfaces) {
    for (LaneMask rest = wanted; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        const LaneMask bit = 1u << static_cast<unsigned>(i);
        const CastTriangle& triangle = scenery.triangles[scenery.first_triangle[hits.instance[i]] + hits.triangle[i]];
        const CastMaterial& material = scenery.materials[triangle.material];
        const float u = hits.u[i];
        const float v = hits.v[i];
        glm::vec3 reflectance = material.base_colour;
        glm::vec3 normal(0.0f);
        if (triangle.corners != 0) {
            const CastCorners& corners = scenery.corners[triangle.corners];
            reflectance *= corners.colours[0] + u * corners.colours[1] + v * corners.colours[2];
            normal = corners.normals[0] + u * corners.normals[1] + v * corners.normals[2];
        }
        set_lane(surfaces.reflectance, i, reflectance);
        set_lane(surfaces.normal, i, normal);
        set_lane(surfaces.emission, i, material.emission);
        surfaces.materials[static_cast<std::size_t>(i)] = &material;
        surfaces.lit |= material.unlit ? 0u : bit;
        surfaces.emitting |= material.emits || material.unlit ? bit : 0u;
        if (material.base_colour_image >= 0 || material.emission_image >= 0) {
            const glm::vec2 coordinates = triangle.texture_coordinates + u * triangle.along_u + v * triangle.along_v;
            surfaces.s[i] = coordinates.x;
            surfaces.t[i] = coordinates.y;
            set_lane(surfaces.gradient_s, i, triangle.gradient_s);
            set_lane(surfaces.gradient_t, i, triangle.gradient_t);
            surfaces.textured |= material.base_colour_image >= 0 ? bit : 0u;
            surfaces.emission_textured |= material.emission_image >= 0 ? bit : 0u;
        }
    }
}

/// Multiplies one of a surface's colours by an image of its material.
struct TexturedColour {
    std::int32_t CastMaterial::*image;
    Lanes3 Surfaces::*colour;
    LaneMask lanes;
};

void apply_textures(const CastScenery& scenery, const TexturePool& textures, const PacketRays& rays,
                    const PacketHits& hits, const TexturedColour& what, Surfaces& surfaces) {
    TextureLookUp look_up{{}, surfaces.s, surfaces.t, {}};
    Lanes width;
    Lanes height;
    for (LaneMask rest = what.lanes; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        const CastTriangle& triangle = scenery.triangles[scenery.first_triangle[hits.instance[i]] + hits.triangle[i]];
        look_up.image[i] = static_cast<std::uint32_t>(scenery.materials[triangle.material].*what.image);
        width[i] = textures.width(look_up.image[i]);
        height[i] = textures.height(look_up.image[i]);
    }
    footprint_levels(rays, hits, surfaces, width, height, look_up.level);
    std::array<Four, lane_count> colours;
    textures.sample(look_up, what.lanes, colours);
    for (LaneMask rest = what.lanes; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        const Four& texel = colours[static_cast<std::size_t>(i)];
        set_lane(surfaces.*what.colour, i, lane_of(surfaces.*what.colour, i) * glm::vec3(texel[0], texel[1], texel[2]));
    }
}

} // namespace

/// Light on white surfaces, as radiance, by light.
struct SurfaceLight::Received {
    Lanes3 of_scene;
    std::vector<Lanes3> of_lamps; ///< of the falling lights after the first
};

SurfaceLight::SurfaceLight(const content::SceneDesc& scene, const SceneSpectra& spectra, const SceneryHits& scenery)
    : scene_(scene), spectra_(spectra), scenery_(scenery), surfaces_(scene, spectra), textures_(scene.images) {
    if (scene.sun) {
        towards_sun_ = glm::normalize(scene.sun->direction);
        sun_light_ = std::numbers::inv_pi_v<float> * scene.sun->irradiance;
    }
}

void SurfaceLight::receive(const Surfaces& surfaces, const PacketHits& hits, LaneMask lit, Received& received) const {
    add_ambient(scene_.ambient, surfaces, received.of_scene);
    if (scene_.sun) {
        Lanes cosine;
        sun_cosines(surfaces, towards_sun_, cosine);
        LaneMask turned = 0;
        for (int i = 0; i < lane_count; ++i) {
            turned |= cosine[i] > 0.0f ? 1u << static_cast<unsigned>(i) : 0u;
        }
        turned &= lit;
        if (turned != 0) {
            Lanes3 origins;
            shadow_origins(
                hits, surfaces, [this](const glm::vec3&) { return towards_sun_; }, origins);
            Lanes visible;
            shares_of(turned & ~scenery_.blocked(origins, towards_sun_, turned), visible);
            add_sun(cosine, visible, sun_light_, received.of_scene);
        }
    }
    if (scene_.lamps.empty()) {
        return;
    }
    received.of_lamps.resize(spectra_.falling_lights() - 1);
    const PacketBox box(surfaces, lit);
    for (std::size_t index = 0; index < scene_.lamps.size(); ++index) {
        const content::Lamp& lamp = scene_.lamps[index];
        if (lamp.range > 0.0f && !box.within(lamp.range, lamp.position)) {
            continue;
        }
        Lanes shares;
        lamp_shares(lamp, surfaces, shares);
        LaneMask reached = 0;
        for (int i = 0; i < lane_count; ++i) {
            reached |= shares[i] > 0.0f ? 1u << static_cast<unsigned>(i) : 0u;
        }
        reached &= lit;
        if (reached == 0) {
            continue;
        }
        Lanes3 origins;
        shadow_origins(
            hits, surfaces, [&lamp](const glm::vec3& position) { return lamp.position - position; }, origins);
        const LaneMask dark =
            scenery_.blocked_towards(origins, lamp.position, static_cast<float>(content::lamp_clearance), reached);
        Lanes visible;
        shares_of(reached & ~dark, visible);
        const std::size_t light = spectra_.lamps()[index];
        add_shares(shares, visible, std::numbers::inv_pi_v<float> * lamp.intensity,
                   light == 0 ? received.of_scene : received.of_lamps[light - 1]);
    }
}

void SurfaceLight::add_reflected(const Surfaces& surfaces, const Received& received, LaneMask lit,
                                 const PacketColours& colours, Lanes3& light) const {
    for (LaneMask rest = lit; rest != 0;) {
        const CastMaterial& material = *surfaces.materials[static_cast<std::size_t>(std::countr_zero(rest))];
        const LaneMask lanes = alike(surfaces, rest, [](const CastMaterial& a, const CastMaterial& b) {
            return a.reflected_layer == b.reflected_layer;
        });
        rest &= ~lanes;
        Lanes share;
        shares_of(lanes, share);
        for (std::size_t index = 0; index <= received.of_lamps.size(); ++index) {
            const Lanes3& of_light = index == 0 ? received.of_scene : received.of_lamps[index - 1];
            if (index == 0 && colours.table.plain_gain > 0.0f && material.rule != content::ReflectanceRule::own) {
                Lanes3 rgb;
                lit_colours(surfaces.reflectance, of_light, share, rgb);
                add_radiance(colours, material.reflected_layer, rgb, light);
                continue;
            }
            LitLanes lit_lanes;
            light_surfaces(surfaces.reflectance, of_light, share, lit_lanes);
            add_terms(surfaces, material, lanes, static_cast<int>(index), lit_lanes, colours, light);
        }
    }
}

void SurfaceLight::add_terms(const Surfaces& surfaces, const CastMaterial& material, LaneMask lanes, int of_light,
                             const LitLanes& lit, const PacketColours& colours, Lanes3& light) const {
    const int layer = material.reflected_layer + of_light * material.next_light;
    const bool hues = material.rule == content::ReflectanceRule::dominant_wavelength;
    if (hues) {
        add_hues(colours, spectra_.hue_wheel(), layer, lit.rgb, light);
    } else {
        add_lit(colours, material.rule, layer, lit, surfaces.reflectance, light);
    }
    if (!material.invisible) {
        return;
    }
    for (const int band : {0, 1}) {
        Lanes weight;
        band_weights(surfaces, lanes, band, lit.luminance, weight);
        const int term = material.first_invisible + band;
        add_term(colours, hues ? TermPlace{layer + term} : place_of_term(layer, term), weight, light);
    }
}

void SurfaceLight::add_emitted(const Surfaces& surfaces, LaneMask wanted, const PacketColours& colours,
                               Lanes3& light) const {
    for (LaneMask rest = surfaces.emitting & wanted; rest != 0;) {
        const CastMaterial& material = *surfaces.materials[static_cast<std::size_t>(std::countr_zero(rest))];
        const LaneMask lanes = alike(surfaces, rest, [](const CastMaterial& a, const CastMaterial& b) {
            return a.emitted_layer == b.emitted_layer && a.unlit == b.unlit;
        });
        rest &= ~lanes;
        const Lanes3& source = material.unlit ? surfaces.reflectance : surfaces.emission;
        Lanes3 emitted;
        for (int i = 0; i < lane_count; ++i) {
            set_lane(emitted, i, has(lanes, i) ? lane_of(source, i) : glm::vec3(0.0f));
        }
        if (material.emission_spectrum) {
            Lanes luminance;
            luminance_of_lanes(emitted, luminance);
            add_term(colours, material.emitted_layer, 0, luminance, light);
            continue;
        }
        add_radiance(colours, material.emitted_layer, emitted, light);
        if (material.emission_invisible && colours.table.plain_gain == 0.0f) {
            Lanes share;
            shares_of(lanes, share);
            for (const int band : {0, 1}) {
                Lanes weight;
                band_weights(surfaces, lanes, 2 + band, share, weight);
                add_term(colours, material.emitted_layer, 3 + band, weight, light);
            }
        }
    }
}

void SurfaceLight::add_seen_light(const PacketRays& rays, const PacketHits& hits, LaneMask wanted,
                                  const PacketColours& colours, Lanes3& light) const {
    Surfaces surfaces{};
    place(rays, hits, surfaces);
    look_up(surfaces_, hits, wanted, surfaces);
    if (surfaces.textured != 0) {
        apply_textures(surfaces_, textures_, rays, hits,
                       {&CastMaterial::base_colour_image, &Surfaces::reflectance, surfaces.textured}, surfaces);
    }
    if (surfaces.emission_textured != 0) {
        apply_textures(surfaces_, textures_, rays, hits,
                       {&CastMaterial::emission_image, &Surfaces::emission, surfaces.emission_textured}, surfaces);
    }
    const LaneMask lit = surfaces.lit & wanted;
    if (lit != 0) {
        finish_normals(surfaces);
        Received received;
        receive(surfaces, hits, lit, received);
        add_reflected(surfaces, received, lit, colours, light);
    }
    add_emitted(surfaces, wanted, colours, light);
}

} // namespace render
