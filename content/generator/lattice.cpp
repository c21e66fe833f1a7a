#include "content/generator/models.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

namespace content::generator {
namespace {

constexpr float cell = 10.0f;
constexpr int block_cells = 4; // a block is what is placed again and again
constexpr glm::ivec3 blocks{3, 3, 8};
constexpr float beam_half_width = 0.55f;
constexpr float joint_half_width = 0.95f;

// One side of a beam over one cell: the joint is at x = 0 and 1, half-way is 0.5.
glm::vec3 beam_colour(const glm::vec2& point) {
    constexpr float aspect = cell / (2.0f * beam_half_width); // x in beam widths
    constexpr float texel = aspect / 1024.0f;
    const glm::vec2 p{point.x * aspect, point.y};
    const float from_joint = std::min(p.x, aspect - p.x);
    glm::vec3 colour = encoded(0xd9d6cf) * (0.94f + 0.08f * clouds(point, {48, 6}, 3, 11));
    const auto lay = [&](const glm::vec3& over, float amount) { colour = glm::mix(colour, over, amount); };

    const float quarter = std::abs(p.x - aspect / 2.0f);
    const float panel = box_distance({from_joint, p.y}, {aspect * 0.2f + 0.35f, 0.5f}, {aspect * 0.11f, 0.29f}, 0.25f);
    lay(encoded(0xa49e92), 0.65f * coverage(panel, texel * 6.0f));
    lay(encoded(0x5d564c), 0.5f * coverage(std::abs(panel) - 0.025f, texel * 4.0f));
    lay(encoded(0x463f3a), 0.85f * coverage(quarter - 0.62f, texel * 3.0f));
    lay(encoded(0xf2ede0), 0.95f * coverage(std::abs(quarter - 0.25f) - 0.09f, texel * 3.0f));
    lay(encoded(0x4b463f), 0.7f * coverage(std::abs(from_joint - 1.45f) - 0.03f, texel * 3.0f));
    const glm::vec2 rivet{from_joint < 1.25f ? from_joint - 1.12f : from_joint - 1.72f, std::abs(p.y - 0.5f) - 0.33f};
    lay(encoded(0x5c564d), 0.8f * coverage(disk_distance(rivet, glm::vec2(0.0f), 0.075f), texel * 4.0f));
    lay(encoded(0xf4efe4), 0.7f * coverage(disk_distance(rivet, {-0.015f, 0.02f}, 0.045f), texel * 4.0f));

    const float edge = std::min(p.y, 1.0f - p.y);
    lay(encoded(0xfbf8f0), 0.5f * coverage(std::abs(edge - 0.05f) - 0.02f, 0.03f));
    lay(encoded(0x3c3833), 0.55f * coverage(edge - 0.02f, 0.03f));
    const float contact = glm::smoothstep(0.8f, 2.2f, from_joint); // shade where the joint stands over the beam
    return colour * (0.55f + 0.45f * contact);
}

// One side of a joint.
glm::vec3 joint_colour(const glm::vec2& point) {
    constexpr float texel = 1.0f / 128.0f;
    glm::vec3 colour = encoded(0xb9b4a9) * (0.92f + 0.1f * clouds(point, {6, 6}, 3, 23));
    const auto lay = [&](const glm::vec3& over, float amount) { colour = glm::mix(colour, over, amount); };
    const glm::vec2 folded = glm::abs(point - 0.5f);
    const float edge = 0.5f - std::max(folded.x, folded.y);
    lay(encoded(0xf3efe6), 0.8f * coverage(std::abs(edge - 0.045f) - 0.018f, texel * 2.0f));
    lay(encoded(0x5a554d), 0.5f * coverage(edge - 0.02f, texel * 2.0f));
    lay(encoded(0x47423b), 0.85f * coverage(disk_distance(folded, {0.385f, 0.385f}, 0.052f), texel * 1.5f));
    lay(encoded(0xe9e4d8), 0.9f * coverage(disk_distance(folded, {0.378f, 0.392f}, 0.03f), texel * 1.5f));
    const float beam = std::max(folded.x, folded.y) - beam_half_width / joint_half_width * 0.5f;
    return colour * (0.6f + 0.4f * glm::smoothstep(0.0f, 0.11f, beam));
}

// The bundle of beams along one axis in one block, open at both ends. `axes`: the mesh's x, y, z from the bundle's,
// whose beams run along its x.
MeshBuilder beams(const glm::mat4& axes, const glm::vec3& tint) {
    MeshBuilder builder;
    builder.tint = tint;
    constexpr float h = beam_half_width;
    constexpr float length = cell * static_cast<float>(block_cells);
    // The picture begins at a joint, and a block begins half a cell before its first joint.
    const TextureArea area{{0.5f, 0.0f}, {0.5f + static_cast<float>(block_cells), 1.0f}};
    for (int j = 0; j < block_cells; ++j) {
        for (int k = 0; k < block_cells; ++k) {
            const glm::vec3 start = cell * glm::vec3(0.0f, static_cast<float>(j) + 0.5f, static_cast<float>(k) + 0.5f);
            for (int side = 0; side < 4; ++side) {
                const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), glm::half_pi<float>() * static_cast<float>(side),
                                                     glm::vec3(1.0f, 0.0f, 0.0f));
                builder.transform = axes * glm::translate(glm::mat4(1.0f), start) * turned;
                builder.quad({{{0.0f, -h, h}, {length, -h, h}, {length, h, h}, {0.0f, h, h}}}, area);
            }
        }
    }
    return builder;
}

// Lids on the ends of a bundle's beams at the side of +x.
MeshBuilder lids(const glm::mat4& axes, const glm::vec3& tint) {
    MeshBuilder builder;
    builder.tint = tint * 0.7f;
    builder.transform = axes;
    constexpr float h = beam_half_width;
    for (int j = 0; j < block_cells; ++j) {
        for (int k = 0; k < block_cells; ++k) {
            const float y = cell * (static_cast<float>(j) + 0.5f);
            const float z = cell * (static_cast<float>(k) + 0.5f);
            builder.quad({{{0.0f, y - h, z + h}, {0.0f, y - h, z - h}, {0.0f, y + h, z - h}, {0.0f, y + h, z + h}}},
                         TextureArea{});
        }
    }
    return builder;
}

/// The place of the i-th cell of a cube with `cells` along each side.
glm::ivec3 cube_cell(int i, int cells) {
    return {i % cells, i / cells % cells, i / (cells * cells)};
}

MeshBuilder joints(int cells) {
    MeshBuilder builder;
    constexpr float h = joint_half_width;
    for (int i = 0; i < cells * cells * cells; ++i) {
        const glm::vec3 centre = cell * (glm::vec3(cube_cell(i, cells)) + 0.5f);
        for (int side = 0; side < 6; ++side) {
            const glm::vec3 axis = side < 4 ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
            const float quarters = side < 4 ? static_cast<float>(side) : static_cast<float>(2 * side - 9);
            builder.transform =
                glm::rotate(glm::translate(glm::mat4(1.0f), centre), glm::half_pi<float>() * quarters, axis);
            builder.quad({{{-h, -h, h}, {h, -h, h}, {h, h, h}, {-h, h, h}}}, TextureArea{});
        }
    }
    return builder;
}

struct Axis {
    const char* name;
    glm::mat4 axes; // the block's axes from the bundle's
    glm::vec3 tint;
};

std::array<Axis, 3> lattice_axes() {
    const glm::vec4 x(1.0f, 0.0f, 0.0f, 0.0f);
    const glm::vec4 y(0.0f, 1.0f, 0.0f, 0.0f);
    const glm::vec4 z(0.0f, 0.0f, 1.0f, 0.0f);
    const glm::vec4 w(0.0f, 0.0f, 0.0f, 1.0f);
    return {Axis{"x", glm::mat4(x, y, z, w), linear(0xf0b89a)}, Axis{"y", glm::mat4(y, z, x, w), linear(0xf3e6c4)},
            Axis{"z", glm::mat4(z, x, y, w), linear(0xa9c9e6)}};
}

glm::vec3 block_corner(const glm::ivec3& block) {
    return cell * static_cast<float>(block_cells) * (glm::vec3(block) - 0.5f * glm::vec3(blocks));
}

void place_joints(SceneDesc& scene, std::size_t mesh, const glm::ivec3& block, int joint_cells) {
    const int parts = block_cells / joint_cells;
    for (int i = 0; i < parts * parts * parts; ++i) {
        const glm::vec3 part(cube_cell(i, parts));
        const glm::vec3 corner = block_corner(block) + cell * static_cast<float>(joint_cells) * part;
        place(scene, fmt::format("joints {} {} {} {}", block.x, block.y, block.z, i), mesh,
              glm::translate(glm::mat4(1.0f), corner));
    }
}

// Closes the beams along axis `a` where the lattice ends.
void place_lids(SceneDesc& scene, std::size_t mesh, const Axis& axis, int a, const glm::ivec3& block) {
    const glm::vec3 corner = block_corner(block);
    constexpr float length = cell * static_cast<float>(block_cells);
    if (block[a] == blocks[a] - 1) {
        glm::vec3 shift(0.0f);
        shift[a] = length;
        place(scene, fmt::format("lids +{} {} {} {}", axis.name, block.x, block.y, block.z), mesh,
              glm::translate(glm::mat4(1.0f), corner + shift));
    }
    if (block[a] == 0) {
        // The same lids, turned by half a turn about the middle of the face.
        const int b = (a + 1) % 3;
        glm::vec3 middle(0.0f);
        middle[b] = middle[(a + 2) % 3] = length / 2.0f;
        glm::vec3 about(0.0f);
        about[b] = 1.0f;
        place(scene, fmt::format("lids -{} {} {} {}", axis.name, block.x, block.y, block.z), mesh,
              glm::rotate(glm::translate(glm::mat4(1.0f), corner + middle), glm::pi<float>(), about) *
                  glm::translate(glm::mat4(1.0f), -middle));
    }
}

} // namespace

SceneDesc lattice() {
    SceneDesc scene;
    const std::size_t beam = add_painted_material(scene, paint("beam", 1024, 128, beam_colour));
    const std::size_t joint = add_painted_material(scene, paint("joint", 128, 128, joint_colour));
    constexpr int joint_cells = 2;
    const std::size_t joint_mesh = add_mesh(scene, joints(joint_cells).mesh("joints", joint));
    const std::array<Axis, 3> axes = lattice_axes();
    std::array<std::size_t, 3> beam_meshes{};
    std::array<std::size_t, 3> lid_meshes{};
    for (std::size_t a = 0; a < axes.size(); ++a) {
        beam_meshes[a] =
            add_mesh(scene, beams(axes[a].axes, axes[a].tint).mesh(fmt::format("beams along {}", axes[a].name), beam));
        lid_meshes[a] =
            add_mesh(scene, lids(axes[a].axes, axes[a].tint).mesh(fmt::format("lids along {}", axes[a].name), joint));
    }
    for (int i = 0; i < blocks.x * blocks.y * blocks.z; ++i) {
        const glm::ivec3 block{i % blocks.x, i / blocks.x % blocks.y, i / (blocks.x * blocks.y)};
        for (std::size_t a = 0; a < axes.size(); ++a) {
            place(scene, fmt::format("beams {} {} {} {}", axes[a].name, block.x, block.y, block.z), beam_meshes[a],
                  glm::translate(glm::mat4(1.0f), block_corner(block)));
            place_lids(scene, lid_meshes[a], axes[a], static_cast<int>(a), block);
        }
        place_joints(scene, joint_mesh, block, joint_cells);
    }
    return scene;
}

} // namespace content::generator
