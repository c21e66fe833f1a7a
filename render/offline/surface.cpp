#include "render/offline/surface.h"

#include "render/bilinear.h"
#include "render/colour/display.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace render {
namespace {

std::array<double, 256> linear_from_byte() {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
    }
    return table;
}

glm::dvec4 texel(const content::Image& image, std::int64_t column, std::int64_t row) {
    static const std::array<double, 256> decoded = linear_from_byte();
    const std::int64_t x = ((column % image.width) + image.width) % image.width;
    const std::int64_t y = ((row % image.height) + image.height) % image.height;
    const std::uint8_t* rgba = &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
    return {decoded[rgba[0]], decoded[rgba[1]], decoded[rgba[2]], rgba[3] / 255.0};
}

/// texture_colour's alpha. The place within the image is found by floors: remainders of integers cost more than the
/// rest.
double texture_alpha(const content::Image& image, const glm::dvec2& coordinates) {
    const glm::dvec2 within = coordinates - glm::floor(coordinates);
    const double x = within.x * image.width - 0.5;
    const double y = within.y * image.height - 0.5;
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    const int left = column < 0 ? image.width - 1 : column;
    const int right = column + 1 < image.width ? column + 1 : 0;
    const int upper = row < 0 ? image.height - 1 : row;
    const int lower = row + 1 < image.height ? row + 1 : 0;
    const auto alpha = [&](int at_column, int at_row) {
        return image.rgba[4 * (static_cast<std::size_t>(at_row) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(at_column)) +
                          3] /
               255.0;
    };
    const double above = glm::mix(alpha(left, upper), alpha(right, upper), x - column);
    const double below = glm::mix(alpha(left, lower), alpha(right, lower), x - column);
    return glm::mix(above, below, y - row);
}

template <class Member>
auto interpolated(const TriangleView& triangle, const glm::dvec3& weights, const Member& member) {
    return weights.x * member(*triangle.vertices[0]) + weights.y * member(*triangle.vertices[1]) +
           weights.z * member(*triangle.vertices[2]);
}

glm::dvec2 texture_coordinates(const TriangleView& triangle, const glm::dvec3& barycentric) {
    return interpolated(triangle, barycentric,
                        [](const content::Vertex& v) { return glm::dvec2(v.texture_coordinates); });
}

} // namespace

glm::dvec4 texture_colour(const content::Image& image, const glm::dvec2& coordinates) {
    const double x = coordinates.x * image.width - 0.5;
    const double y = coordinates.y * image.height - 0.5;
    return bilinear(x, y, [&image](std::int64_t column, std::int64_t row) { return texel(image, column, row); });
}

TriangleView::TriangleView(const content::SceneDesc& scene, std::size_t instance_index, std::uint32_t triangle)
    : instance(scene.instances[instance_index]), mesh(scene.meshes[instance.mesh]),
      material(scene.materials[mesh.material]), vertices{&mesh.vertices[mesh.indices[3 * std::size_t{triangle}]],
                                                         &mesh.vertices[mesh.indices[3 * std::size_t{triangle} + 1]],
                                                         &mesh.vertices[mesh.indices[3 * std::size_t{triangle} + 2]]} {}

glm::dvec3 TriangleView::world_position(int corner) const {
    const glm::dvec4 in_mesh(glm::dvec3(vertices[static_cast<std::size_t>(corner)]->position), 1.0);
    const glm::dvec3 in_world(glm::dmat4(instance.world_from_mesh) * in_mesh);
    return in_world;
}

double opacity(const content::SceneDesc& scene, const TriangleView& triangle, const glm::dvec3& barycentric) {
    const double alpha =
        static_cast<double>(triangle.material.base_colour.a) *
        interpolated(triangle, barycentric, [](const content::Vertex& v) { return static_cast<double>(v.colour.a); });
    return triangle.material.base_colour_image
               ? alpha * texture_alpha(scene.images[*triangle.material.base_colour_image],
                                       texture_coordinates(triangle, barycentric))
               : alpha;
}

glm::dvec4 base_colour(const content::SceneDesc& scene, const TriangleView& triangle, const glm::dvec3& barycentric) {
    glm::dvec4 colour =
        glm::dvec4(triangle.material.base_colour) *
        interpolated(triangle, barycentric, [](const content::Vertex& v) { return glm::dvec4(v.colour); });
    if (triangle.material.base_colour_image) {
        colour *= texture_colour(scene.images[*triangle.material.base_colour_image],
                                 texture_coordinates(triangle, barycentric));
    }
    return colour;
}

glm::dvec3 emission(const content::SceneDesc& scene, const TriangleView& triangle, const glm::dvec3& barycentric) {
    glm::dvec3 radiance(triangle.material.emission);
    if (triangle.material.emission_image) {
        radiance *= glm::dvec3(texture_colour(scene.images[*triangle.material.emission_image],
                                              texture_coordinates(triangle, barycentric)));
    }
    return radiance;
}

glm::dvec3 shading_normal(const TriangleView& triangle, const glm::dvec3& barycentric) {
    const glm::dvec3 in_mesh =
        interpolated(triangle, barycentric, [](const content::Vertex& v) { return glm::dvec3(v.normal); });
    return glm::normalize(glm::transpose(glm::inverse(glm::dmat3(triangle.instance.world_from_mesh))) * in_mesh);
}

} // namespace render
