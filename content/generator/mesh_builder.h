#pragma once

#include "content/scene_desc.h"

#include <glm/gtc/constants.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <functional>
#include <span>

namespace content::generator {

/// Part of a texture: `lower_left` and `upper_right` of the picture as painted, y up, in pictures.
struct TextureArea {
    glm::vec2 lower_left{0.0f};
    glm::vec2 upper_right{1.0f};
};

/// Faces of a box that are made.
enum BoxFaces : std::uint8_t {
    face_left = 1u << 0u,   ///< -x
    face_right = 1u << 1u,  ///< +x
    face_bottom = 1u << 2u, ///< -y
    face_top = 1u << 3u,    ///< +y
    face_back = 1u << 4u,   ///< -z
    face_front = 1u << 5u,  ///< +z
    all_faces = 0x3f,
    all_but_bottom = all_faces & ~face_bottom,
};

/// A point of a profile that is turned about the y axis.
struct ProfilePoint {
    float radius;
    float height;
};

/// Collects triangles of one material. Positions are given in a local frame that `transform` carries into the mesh.
/// Flat faces take their texture coordinates from their local position (`texture_size` metres a picture) unless a
/// TextureArea is given.
class MeshBuilder {
  public:
    /// Brightness at a point of the mesh (position and unit normal in the mesh's space): contact shade baked into
    /// vertex colours.
    using Shade = std::function<float(const glm::vec3& position, const glm::vec3& normal)>;

    glm::mat4 transform{1.0f};
    glm::vec3 tint{1.0f}; ///< linear, becomes the vertex colour
    float texture_size = 1.0f;
    Shade shade;

    /// A flat four-cornered face, counter-clockwise seen from outside.
    void quad(const std::array<glm::vec3, 4>& corners);
    /// The same with the picture's area: corners are its lower left, lower right, upper right, upper left.
    void quad(const std::array<glm::vec3, 4>& corners, const TextureArea& area);
    void triangle(const std::array<glm::vec3, 3>& corners);
    void box(const glm::vec3& low, const glm::vec3& high, unsigned faces = all_faces);
    /// A convex outline in the plane z = `back`, counter-clockwise seen from +z, carried to z = `front`; both ends
    /// closed.
    void extrude(std::span<const glm::vec2> outline, float back, float front);
    /// A profile from bottom to top turned about the local y axis, smooth around, flat along the profile.
    void turn(std::span<const ProfilePoint> profile, int segments);
    /// A round tube along a path, smooth around, its ends open. `sides`: of its cross-section, at least 3.
    void tube(std::span<const glm::vec3> path, float radius, int sides);
    /// A ball of `20 * 4^subdivisions` triangles, each unit direction moved out to `radius(direction)`.
    void ball(const glm::vec3& centre, int subdivisions, const std::function<float(const glm::vec3&)>& radius);

    /// What was collected, as a mesh.
    Mesh mesh(std::string name, std::size_t material) const;
    bool empty() const { return indices_.empty(); }

  private:
    std::uint32_t vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& texture_coordinates);
    glm::vec2 planar(const glm::vec3& position, const glm::vec3& normal) const;

    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> indices_;
};

} // namespace content::generator
