#include "content/generator/models.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace content::generator {
namespace {

constexpr float pi = glm::pi<float>();
constexpr float least_area = 2e-6f; ///< square metres, twice a triangle's

/// A smooth surface over (s, t) in the unit square; outside is the side from which t runs right where s runs up.
using Surface = std::function<glm::vec3(float s, float t)>;
using Tint = std::function<glm::vec3(float s, float t)>;

glm::vec3 normal_of(const Surface& surface, float s, float t) {
    constexpr float step = 2e-3f;
    const glm::vec3 along_s = surface(s + step, t) - surface(s - step, t);
    const glm::vec3 along_t = surface(s, t + step) - surface(s, t - step);
    const glm::vec3 normal = glm::cross(along_t, along_s);
    const float length = glm::length(normal);
    return length > 0.0f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Adds the surface in `columns` x `rows` smooth quads, each of one tint. Seen at speed a flat face is curved: quads
/// are small against the ship.
void add_patch(Mesh& mesh, const Surface& surface, int columns, int rows, const Tint& tint) {
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            const float middle_s = (static_cast<float>(i) + 0.5f) / static_cast<float>(columns);
            const float middle_t = (static_cast<float>(j) + 0.5f) / static_cast<float>(rows);
            for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                const float s = static_cast<float>(i + di) / static_cast<float>(columns);
                const float t = static_cast<float>(j + dj) / static_cast<float>(rows);
                // A pole's normal is not defined: the quad's middle lends it the direction.
                const float lent = 0.02f;
                mesh.vertices.push_back({surface(s, t),
                                         normal_of(surface, s + lent * (middle_s - s), t + lent * (middle_t - t)),
                                         {s, t},
                                         glm::vec4(tint(middle_s, middle_t), 1.0f)});
            }
            std::array<Vertex*, 4> corners{};
            for (std::uint32_t corner = 0; corner < 4; ++corner) {
                corners.at(corner) = &mesh.vertices[first + corner];
            }
            for (const auto& [second, third] : {std::pair{2u, 1u}, {3u, 2u}}) {
                const glm::vec3 area = glm::cross(corners.at(second)->position - corners[0]->position,
                                                  corners.at(third)->position - corners[0]->position);
                if (glm::length(area) <= least_area) {
                    continue; // at a pole
                }
                mesh.indices.insert(mesh.indices.end(), {first, first + second, first + third});
                for (const std::uint32_t corner : {0u, second, third}) {
                    glm::vec3& normal = corners.at(corner)->normal;
                    if (glm::dot(normal, area) <= 0.0f) { // a rim bends more than a quad follows
                        normal = glm::normalize(area);
                    }
                }
            }
        }
    }
}

Tint plain(const glm::vec3& colour) {
    return [colour](float, float) { return colour; };
}

/// A cross-section of the hull: an ellipse about (0, middle, z).
struct Section {
    float z;
    float half_width;
    float half_height;
    float middle;
};

constexpr std::array<Section, 8> hull = {{{-3.6f, 0.01f, 0.01f, -0.42f},
                                          {-3.2f, 0.22f, 0.16f, -0.40f},
                                          {-2.0f, 0.56f, 0.42f, -0.36f},
                                          {-0.4f, 0.86f, 0.64f, -0.34f},
                                          {1.4f, 1.02f, 0.74f, -0.28f},
                                          {3.2f, 1.00f, 0.66f, -0.20f},
                                          {4.6f, 0.86f, 0.50f, -0.12f},
                                          {5.2f, 0.80f, 0.44f, -0.10f}}};

/// The hull's section at a share of its length, joined by Catmull and Rom's cubics.
Section section_at(float share) {
    const float place = std::clamp(share, 0.0f, 1.0f) * (hull.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(place), hull.size() - 2);
    const float x = place - static_cast<float>(index);
    const Section& a = hull[index == 0 ? 0 : index - 1];
    const Section& b = hull[index];
    const Section& c = hull[index + 1];
    const Section& d = hull[std::min(index + 2, hull.size() - 1)];
    const auto cubic = [x](float p, float q, float r, float s) {
        return q + 0.5f * x * (r - p + x * (2.0f * p - 5.0f * q + 4.0f * r - s + x * (3.0f * (q - r) + s - p)));
    };
    return {cubic(a.z, b.z, c.z, d.z), cubic(a.half_width, b.half_width, c.half_width, d.half_width),
            cubic(a.half_height, b.half_height, c.half_height, d.half_height),
            cubic(a.middle, b.middle, c.middle, d.middle)};
}

void add_hull(Mesh& mesh) {
    const glm::vec3 white = linear(0xe9e8e3);
    const glm::vec3 grey = linear(0x8d959d);
    const glm::vec3 belly = linear(0x4a525c);
    const glm::vec3 stripe = linear(0xd2571e);
    // t turns from below over the right side.
    add_patch(
        mesh,
        [](float s, float t) {
            const Section at = section_at(s);
            const float angle = 2.0f * pi * t;
            return glm::vec3(at.half_width * std::sin(angle), at.middle - at.half_height * std::cos(angle), at.z);
        },
        28, 24,
        [=](float s, float t) {
            const float up = -std::cos(2.0f * pi * t);
            const bool band = (s > 0.50f && s < 0.57f) || (s > 0.60f && s < 0.635f);
            const bool spine = up > 0.93f && s > 0.5f;
            return up < -0.45f ? belly : band ? stripe : spine ? grey : (s < 0.1f ? stripe : white);
        });
    add_patch( // the stern
        mesh,
        [](float s, float t) {
            const Section at = section_at(1.0f);
            const float angle = 2.0f * pi * t;
            const float share = 1.0f - s;
            return glm::vec3(share * at.half_width * std::sin(angle),
                             at.middle - share * at.half_height * std::cos(angle), at.z);
        },
        3, 24, plain(belly));
}

/// A wing or fin: elliptic sections from root to tip. `across`: unit, from leading section's flat to its upper side.
struct Blade {
    glm::vec3 root; ///< middle of the chord
    glm::vec3 tip;
    glm::vec3 across;
    float root_chord; ///< along z
    float tip_chord;
    float root_thickness;
    float tip_thickness;
};

Surface blade_surface(const Blade& blade, bool mirrored) {
    return [=](float s, float t) {
        const float angle = (mirrored ? -2.0f : 2.0f) * pi * t;
        // The last tenth rounds the tip off.
        const float span = std::min(s / 0.9f, 1.0f);
        const float round = s > 0.9f ? std::sqrt(std::max(0.0f, 1.0f - (s - 0.9f) * (s - 0.9f) / 0.01f)) : 1.0f;
        const float chord = glm::mix(blade.root_chord, blade.tip_chord, span) * (0.7f + 0.3f * round);
        const float thickness = glm::mix(blade.root_thickness, blade.tip_thickness, span) * round;
        glm::vec3 point = glm::mix(blade.root, blade.tip, 0.97f * span + 0.03f * s);
        point.z += 0.5f * chord * std::cos(angle);
        point += 0.5f * thickness * std::sin(angle) * blade.across;
        return point;
    };
}

void add_blades(Mesh& mesh) {
    const glm::vec3 white = linear(0xdfe0de);
    const glm::vec3 stripe = linear(0xd2571e);
    for (const float side : {1.0f, -1.0f}) {
        const Blade wing{
            {side * 0.7f, -0.34f, 2.7f}, {side * 3.5f, -0.20f, 4.3f}, {0.0f, 1.0f, 0.0f}, 4.0f, 1.5f, 0.34f, 0.07f};
        const Tint paint = [=](float s, float) { return s > 0.8f ? stripe : white; };
        add_patch(mesh, blade_surface(wing, side > 0.0f), 16, 16, paint);
        const Blade fin{{side * 0.75f, 0.2f, 4.4f},
                        {side * 1.45f, 1.5f, 5.3f},
                        glm::normalize(glm::vec3(-side * 1.3f, 0.7f, 0.0f)),
                        1.9f,
                        0.8f,
                        0.16f,
                        0.05f};
        add_patch(mesh, blade_surface(fin, side > 0.0f), 8, 12, paint);
    }
}

/// A surface turned about an axis parallel to z through `centre`; `radius_and_z` runs so that the outside is outside.
Surface turned(const glm::vec3& centre, const std::function<glm::vec2(float)>& radius_and_z) {
    return [=](float s, float t) {
        const glm::vec2 at = radius_and_z(s);
        const float angle = 2.0f * pi * t;
        return centre + glm::vec3(at.x * std::sin(angle), -at.x * std::cos(angle), at.y);
    };
}

Surface ellipsoid(const glm::vec3& centre, const glm::vec3& radii) {
    return [=](float s, float t) {
        const float along = pi * s;
        const float angle = 2.0f * pi * t;
        return centre + radii * glm::vec3(std::sin(along) * std::sin(angle), -std::sin(along) * std::cos(angle),
                                          -std::cos(along));
    };
}

void place_glow(SceneDesc& scene, const std::string& name, const glm::vec3& radiance, Mesh mesh) {
    mesh.name = name;
    mesh.material = add_glowing_material(scene, name, radiance);
    place(scene, name, add_mesh(scene, std::move(mesh)));
}

/// One nozzle's flame, in four lengths that fade, at full thrust. `outwards`: 1 aft, -1 ahead.
void add_flame(SceneDesc& scene, const std::string& name, const std::vector<glm::vec3>& nozzles, float radius,
               float length, float outwards) {
    constexpr std::array<glm::vec3, 4> glow = {
        {{7.0f, 8.5f, 10.0f}, {3.0f, 4.6f, 7.5f}, {1.3f, 2.2f, 4.6f}, {0.6f, 0.8f, 2.0f}}};
    for (std::size_t part = 0; part < glow.size(); ++part) {
        Mesh mesh;
        for (const glm::vec3& nozzle : nozzles) {
            const auto profile = [=](float s) {
                const float share = (static_cast<float>(part) + s) / static_cast<float>(glow.size());
                const float width = radius * std::sqrt(std::max(0.0f, 1.0f - share)) * (0.8f + 0.2f * share);
                return glm::vec2(width, outwards * length * share);
            };
            add_patch(mesh,
                      turned(
                          nozzle, outwards > 0.0f ? std::function<glm::vec2(float)>(profile)
                                                  : [profile](float s) { return profile(1.0f - s); }),
                      4, 12, plain(glm::vec3(1.0f)));
        }
        place_glow(scene, name + " " + std::to_string(part + 1), glow[part], std::move(mesh));
    }
}

void add_nozzles(Mesh& metal, Mesh& glow, const std::vector<glm::vec3>& nozzles) {
    for (const glm::vec3& nozzle : nozzles) {
        add_patch(metal, turned(nozzle, [](float s) { return glm::vec2(glm::mix(0.46f, 0.38f, s), -0.9f + 0.9f * s); }),
                  4, 16, plain(linear(0x54575c)));
        add_patch(metal, turned(nozzle, [](float s) { return glm::vec2(glm::mix(0.38f, 0.3f, s), -0.25f * s); }), 2, 16,
                  plain(linear(0x2a2b2e)));
        add_patch(glow, turned(nozzle, [](float s) { return glm::vec2(0.3f * (1.0f - s), -0.25f); }), 2, 16,
                  plain(glm::vec3(1.0f)));
    }
}

} // namespace

SceneDesc ship() {
    SceneDesc scene;
    Mesh body;
    add_hull(body);
    add_blades(body);
    const std::vector<glm::vec3> nozzles = {{0.42f, -0.08f, 5.75f}, {-0.42f, -0.08f, 5.75f}};
    Mesh glow;
    add_nozzles(body, glow, nozzles);
    const std::vector<glm::vec3> retro = {{0.6f, -0.42f, -2.2f}, {-0.6f, -0.42f, -2.2f}};
    for (const glm::vec3& at : retro) {
        add_patch(body, ellipsoid(at, {0.14f, 0.14f, 0.3f}), 6, 10, plain(linear(0x54575c)));
    }
    body.name = "hull";
    body.material = add_plain_material(scene, "hull");
    place(scene, "hull", add_mesh(scene, std::move(body)));

    Mesh canopy;
    add_patch(canopy, ellipsoid({0.0f, 0.02f, -0.1f}, {0.56f, 0.5f, 1.6f}), 14, 16, plain(glm::vec3(1.0f)));
    canopy.name = "canopy";
    canopy.material = add_plain_material(scene, "canopy", linear(0x18222c));
    place(scene, "canopy", add_mesh(scene, std::move(canopy)));

    place_glow(scene, "nozzles", {0.35f, 0.5f, 0.8f}, std::move(glow));
    const auto lamp = [](const glm::vec3& at, float radius) {
        Mesh mesh;
        add_patch(mesh, ellipsoid(at, glm::vec3(radius)), 6, 10, plain(glm::vec3(1.0f)));
        return mesh;
    };
    // As ships carry them: red to port, green to starboard, white at the bow and the stern.
    place_glow(scene, "port lamp", {6.0f, 0.15f, 0.1f}, lamp({-3.56f, -0.2f, 4.1f}, 0.11f));
    place_glow(scene, "starboard lamp", {0.1f, 5.0f, 0.5f}, lamp({3.56f, -0.2f, 4.1f}, 0.11f));
    place_glow(scene, "bow lamp", {6.0f, 5.8f, 5.2f}, lamp({0.0f, -0.42f, -3.6f}, 0.1f));
    place_glow(scene, "stern lamp", {5.0f, 4.9f, 4.6f}, lamp({0.0f, 0.38f, 5.2f}, 0.1f));
    add_flame(scene, "exhaust aft", nozzles, 0.3f, 5.0f, 1.0f);
    add_flame(scene, "exhaust ahead", retro, 0.12f, 2.5f, -1.0f);
    return scene;
}

} // namespace content::generator
