#pragma once

#include "content/reflectance.h"
#include "content/spectrum.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// A scene as plain data, whoever made it: what `content` hands to `engine` and `render`. Positions in scene metres,
/// world axes (y up), the world frame, in which the scenery is at rest. Colours linear sRGB (BT.709 primaries, D65)
/// as seen at rest; radiances relative to the scene's white (1 = a white surface square to the sun at exposure 1).
namespace content {

struct Vertex {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f, 1.0f, 0.0f};
    glm::vec2 texture_coordinates{0.0f};
    glm::vec4 colour{1.0f}; ///< linear, multiplies the base colour
};

/// 8-bit image, rows from the top, four channels; colour channels sRGB-encoded, alpha linear.
struct Image {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

enum class AlphaMode : std::uint8_t { opaque, mask };

struct Material {
    std::string name;
    glm::vec4 base_colour{1.0f}; ///< linear reflectance, each in [0, 1]; alpha used by AlphaMode::mask
    std::optional<std::size_t> base_colour_image;
    glm::vec3 emission{0.0f}; ///< linear emitted radiance, strength included, >= 0
    std::optional<std::size_t> emission_image;
    std::optional<float> emission_temperature; ///< kelvin; set: the emission is a black body's, as bright as `emission`
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool unlit = false; ///< KHR_materials_unlit: base colour is radiance as it stands
    bool double_sided = false;
    InvisibleBands invisible_reflectance;              ///< each in [0, 1]
    InvisibleBands invisible_emission;                 ///< 1: as bright there as the scene's white
    bool vegetation = false;                           ///< leaves: dark in the red, bright in the infrared
    std::optional<Spectrum> reflectance_spectrum = {}; ///< instead of the base colour, which only dims it
    std::optional<Spectrum> emission_spectrum = {};    ///< of that shape, as bright as `emission`
};

/// Whether a material sends out light of its own.
inline bool emits(const Material& material) {
    return material.emission != glm::vec3(0.0f) || material.invisible_emission.ultraviolet ||
           material.invisible_emission.infrared;
}

/// Triangles with one material, in the mesh's own space.
struct Mesh {
    std::string name;
    std::size_t material = 0;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< three a triangle, counter-clockwise seen from outside
};

/// One mesh placed in the world. Its index in SceneDesc::instances is the object id that layers and tests use.
struct Instance {
    std::string name;
    std::size_t mesh = 0;
    glm::mat4 world_from_mesh{1.0f};
};

/// The one distant light that casts shadows.
struct Sun {
    glm::vec3 direction{0.3f, 0.9f, 0.3f}; ///< unit, towards the sun, world
    glm::vec3 irradiance{3.1415927f};      ///< linear; pi lets a white surface square to it have radiance 1
};

/// What is nearer to a lamp than this throws no shadow, metres: lamps hang inside of their lanterns.
inline constexpr double lamp_clearance = 0.4;

/// A point lamp (KHR_lights_punctual), at rest in the world.
struct Lamp {
    std::string name;
    glm::vec3 position{0.0f};
    glm::vec3 intensity{1.0f}; ///< linear radiant intensity: irradiance is intensity * cos / distance^2
    float range = 0.0f;        ///< metres, beyond it no light; 0: unlimited
    std::optional<Spectrum> spectrum =
        {}; ///< its own light, then `intensity` is grey; without: the scene's, so coloured
};

/// A start view from a glTF camera.
struct StartView {
    std::string name;
    glm::dvec3 position{0.0};
    glm::dvec3 look{0.0, 0.0, -1.0}; ///< unit
    glm::dvec3 up{0.0, 1.0, 0.0};
    double horizontal_field_of_view = 1.5707963267948966; ///< radians
};

/// Equirectangular sky, linear radiance; row 0 is the zenith (+y), column width/2 looks along -z, longitude grows
/// towards +x.
struct Panorama {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> radiance;
};

/// A star as a point.
struct Star {
    glm::dvec3 position{0.0};    ///< light-years, world axes
    float visual_magnitude = 0;  ///< as seen from the world's origin
    float temperature = 5772.0f; ///< kelvin, effective black body from B-V
    bool distance_known = true;  ///< false: placed on the far shell
};

/// Sky without a panorama: a smooth vertical gradient (radiance) and, below the horizon, the ground's.
struct GradientSky {
    glm::vec3 zenith{0.10f, 0.22f, 0.50f};
    glm::vec3 horizon{0.55f, 0.65f, 0.80f};
    glm::vec3 nadir{0.12f, 0.11f, 0.10f};
};

struct SceneDesc {
    std::string name;
    std::vector<Image> images;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Lamp> lamps;
    std::vector<StartView> start_views;
    std::optional<Sun> sun;
    glm::vec3 ambient{0.0f};          ///< constant sky light: radiance of a white surface facing up under it alone
    std::optional<Panorama> panorama; ///< wins over the gradient
    GradientSky gradient_sky;
    std::vector<Star> stars;
    float light_temperature = 5762.0f; ///< kelvin; black body that reflectances and RGB radiances are lit by
    ReflectanceModel reflectance_model = ReflectanceModel::five_terms;
    bool microwave_background = false; ///< black body of 2.725 K behind everything, added to the sky
    std::vector<std::string> notes;    ///< what was replaced or left out while loading, one line each, for the user
};

} // namespace content
