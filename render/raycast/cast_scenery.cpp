#include "render/raycast/cast_scenery.h"

#include "render/colour/frame_colour_table.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <tbb/parallel_for.h>

namespace render {
namespace {

constexpr std::uint32_t flat_and_plain = 0;

using Corner = std::array<const content::Vertex*, 3>;

/// Normals within this of the plane's are the plane's: a tenth of an 8-bit step of light.
constexpr float flatness = 4e-4f;

bool is_flat(const std::array<glm::vec3, 3>& normals, const glm::vec3& plane_normal) {
    for (const glm::vec3& normal : normals) {
        // Lit on the side that is looked at, so a normal may point either way, but all the same.
        const glm::vec3 turned = glm::dot(normals[0], plane_normal) < 0.0f ? -normal : normal;
        if (glm::distance(glm::normalize(turned), plane_normal) > flatness) {
            return false;
        }
    }
    return true;
}

/// Gradients of texture coordinates over the plane that two edges span.
void set_gradients(CastTriangle& triangle, const glm::dvec3& along_u, const glm::dvec3& along_v) {
    const double uu = glm::dot(along_u, along_u);
    const double uv = glm::dot(along_u, along_v);
    const double vv = glm::dot(along_v, along_v);
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 0.0)) {
        return;
    }
    // Dual vectors of the edges: du/dx and dv/dx.
    const glm::dvec3 u_gradient = (vv * along_u - uv * along_v) / determinant;
    const glm::dvec3 v_gradient = (uu * along_v - uv * along_u) / determinant;
    triangle.gradient_s = glm::vec3(static_cast<double>(triangle.along_u.x) * u_gradient +
                                    static_cast<double>(triangle.along_v.x) * v_gradient);
    triangle.gradient_t = glm::vec3(static_cast<double>(triangle.along_u.y) * u_gradient +
                                    static_cast<double>(triangle.along_v.y) * v_gradient);
}

CastTriangle triangle_of(const content::Instance& instance, const content::Mesh& mesh, const Corner& vertices,
                         CastCorners& corners) {
    const glm::dmat3 linear(instance.world_from_mesh);
    const glm::dvec3 along_u = linear * (glm::dvec3(vertices[1]->position) - glm::dvec3(vertices[0]->position));
    const glm::dvec3 along_v = linear * (glm::dvec3(vertices[2]->position) - glm::dvec3(vertices[0]->position));
    CastTriangle triangle;
    triangle.material = static_cast<std::uint32_t>(mesh.material);
    triangle.texture_coordinates = vertices[0]->texture_coordinates;
    triangle.along_u = vertices[1]->texture_coordinates - vertices[0]->texture_coordinates;
    triangle.along_v = vertices[2]->texture_coordinates - vertices[0]->texture_coordinates;
    set_gradients(triangle, along_u, along_v);

    const glm::mat3 normal_matrix = glm::transpose(glm::inverse(glm::mat3(linear)));
    std::array<glm::vec3, 3> normals{};
    for (std::size_t i = 0; i < 3; ++i) {
        normals[i] = normal_matrix * vertices[i]->normal;
    }
    const glm::vec3 area(glm::cross(along_u, along_v));
    const bool flat = glm::dot(area, area) > 0.0f && is_flat(normals, glm::normalize(area));
    const glm::vec3 colour(vertices[0]->colour);
    const bool plain = colour == glm::vec3(1.0f) && glm::vec3(vertices[1]->colour) == colour &&
                       glm::vec3(vertices[2]->colour) == colour;
    triangle.corners = flat && plain ? flat_and_plain : 1u;
    corners.normals = {normals[0], normals[1] - normals[0], normals[2] - normals[0]};
    if (flat) {
        corners.normals = {}; // the plane's own normal is exact
    }
    corners.colours = {colour, glm::vec3(vertices[1]->colour) - colour, glm::vec3(vertices[2]->colour) - colour};
    return triangle;
}

CastMaterial material_of(const content::Material& material, const MaterialTerms& terms, const SceneSpectra& spectra,
                         const FrameColourTable& table) {
    const auto index = [](const std::optional<std::size_t>& image) {
        return image ? static_cast<std::int32_t>(*image) : -1;
    };
    CastMaterial result;
    result.base_colour = glm::vec3(material.base_colour);
    result.emission = material.emission;
    result.base_colour_image = index(material.base_colour_image);
    result.emission_image = index(material.emission_image);
    result.unlit = material.unlit;
    if (material.unlit) {
        return result;
    }
    result.emits = content::emits(material);
    const SurfaceSpectrum& surface = spectra.surfaces()[terms.surface];
    result.rule = surface.rule;
    result.invisible = surface.invisible();
    result.first_invisible = static_cast<int>(surface.terms.size());
    const SurfaceSpectrum& emitted = spectra.surfaces()[spectra.groups()[terms.emitted].surface];
    result.emission_spectrum = emitted.rule == content::ReflectanceRule::own;
    result.emission_invisible = emitted.invisible();
    result.reflected_layer = table.first_layer[terms.reflected];
    result.next_light = layers_of(surface);
    result.emitted_layer = table.first_layer[terms.emitted];
    result.invisible_bands = invisible_bands(terms);
    return result;
}

} // namespace

CastScenery::CastScenery(const content::SceneDesc& scene, const SceneSpectra& spectra) {
    const FrameColourTable table(spectra);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        materials.push_back(material_of(scene.materials[i], spectra.materials()[i], spectra, table));
    }
    std::size_t count = 0;
    for (const content::Instance& instance : scene.instances) {
        first_triangle.push_back(static_cast<std::uint32_t>(count));
        count += scene.meshes[instance.mesh].indices.size() / 3;
    }
    triangles.resize(count);
    std::vector<CastCorners> all_corners(count);
    tbb::parallel_for(std::size_t{0}, scene.instances.size(), [&](std::size_t i) {
        const content::Instance& instance = scene.instances[i];
        const content::Mesh& mesh = scene.meshes[instance.mesh];
        for (std::size_t j = 0; j < mesh.indices.size() / 3; ++j) {
            const Corner vertices{&mesh.vertices[mesh.indices[3 * j]], &mesh.vertices[mesh.indices[3 * j + 1]],
                                  &mesh.vertices[mesh.indices[3 * j + 2]]};
            const std::size_t at = first_triangle[i] + j;
            triangles[at] = triangle_of(instance, mesh, vertices, all_corners[at]);
        }
    });
    corners.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
        if (triangles[i].corners != flat_and_plain) {
            triangles[i].corners = static_cast<std::uint32_t>(corners.size());
            corners.push_back(all_corners[i]);
        }
    }
}

} // namespace render
