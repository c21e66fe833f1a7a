#include "render/gl/scene_pass.h"

#include "render/gl/shader_library.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace render {
namespace {

constexpr float near_distance = 0.01f; // metres; depth is reversed and float, so small costs nothing

/// Bindings that the scene's shaders share.
enum Location : GLint {
    picture_from_world = 0,
    eye_position = 1,
    eye_remainder = 2,
    near_plane = 3,
    towards_sun = 4,
    shadow_from_world = 5,
    shadow_offset = 6,
    sun_light = 7,
    gain_factor = 8,
    coverage_alpha = 9,
};
constexpr GLuint base_colour_unit = 0;
constexpr GLuint emission_unit = 1;
constexpr GLuint shadow_unit = 2;

template <class Value>
Buffer make_buffer(const std::vector<Value>& values) {
    Buffer buffer = Buffer::create();
    if (!values.empty()) {
        glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), 0);
    }
    return buffer;
}

void float_attribute(GLuint array, GLuint location, GLint components, GLenum type, GLboolean normalised,
                     std::size_t offset) {
    glEnableVertexArrayAttrib(array, location);
    glVertexArrayAttribFormat(array, location, components, type, normalised, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, location, 0);
}

void integer_attribute(GLuint array, GLuint location, std::size_t offset) {
    glEnableVertexArrayAttrib(array, location);
    glVertexArrayAttribIFormat(array, location, 1, GL_UNSIGNED_INT, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, location, 0);
}

std::string defines_of(const ChunkKind& kind, bool sun) {
    std::string defines;
    const auto add = [&](bool condition, const char* name) {
        if (condition) {
            defines += std::string("#define ") + name + "\n";
        }
    };
    add(kind.base_colour_array >= 0, "TEXTURED");
    add(kind.emission_array >= 0 && !kind.unlit, "EMISSION_TEXTURED");
    add(kind.masked, "MASKED");
    add(kind.unlit, "UNLIT");
    add(kind.near_lamps, "NEAR_LAMPS");
    add(sun && !kind.unlit, "SUN");
    return defines;
}

/// Depth state for pictures with reversed depth: nearer is greater.
void use_reversed_depth() {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
}

void leave_scene_state() {
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBindVertexArray(0);
}

/// The ground plan of what throws shadows, over the scene's whole height: all but the ground itself, taken as what
/// stays within the lowest hundredth of the height. Wide land would spread the map's texels where no shadow falls.
Box box_of_casters(const ChunkedScene& scene) {
    if (scene.chunks.empty()) {
        return {};
    }
    const Box& all = scene.nodes.front().box;
    const float ground = all.low.y + 0.01f * (all.high.y - all.low.y);
    Box casters{all.high, all.low};
    for (const SceneVertex& vertex : scene.vertices) {
        if (vertex.position.y > ground) {
            casters.low = glm::min(casters.low, vertex.position);
            casters.high = glm::max(casters.high, vertex.position);
        }
    }
    casters.low.y = all.low.y;
    const bool flat = casters.low.x > casters.high.x;
    return flat ? all : casters;
}

} // namespace

ScenePass::ScenePass(const content::SceneDesc& scene, int shadow_map_size)
    : scene_(chunk_scene(scene)), culler_(scene_.nodes, scene_.chunks), sun_(scene.sun.has_value()),
      casters_(box_of_casters(scene_)), counts_(scene_.kinds.size()), first_indices_(scene_.kinds.size()) {
    upload_geometry();
    upload_images(scene);
    upload_lamps(scene);
    if (sun_) {
        towards_sun_ = glm::normalize(scene.sun->direction);
        sun_light_ = scene.sun->irradiance * std::numbers::inv_pi_v<float>;
    }
    make_programs();
    if (sun_ && !scene_.chunks.empty()) {
        draw_shadow_map(shadow_map_size);
    }
}

void ScenePass::upload_geometry() {
    vertices_ = make_buffer(scene_.vertices);
    indices_ = make_buffer(scene_.indices);
    materials_ = make_buffer(scene_.materials);
    vertex_array_ = VertexArray::create();
    const GLuint array = vertex_array_.name();
    glVertexArrayVertexBuffer(array, 0, vertices_.name(), 0, sizeof(SceneVertex));
    glVertexArrayElementBuffer(array, indices_.name());
    float_attribute(array, 0, 3, GL_FLOAT, GL_FALSE, offsetof(SceneVertex, position));
    float_attribute(array, 1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, offsetof(SceneVertex, normal));
    float_attribute(array, 2, 2, GL_FLOAT, GL_FALSE, offsetof(SceneVertex, texture_coordinates));
    float_attribute(array, 3, 4, GL_UNSIGNED_SHORT, GL_TRUE, offsetof(SceneVertex, colour));
    float_attribute(array, 4, 3, GL_HALF_FLOAT, GL_FALSE, offsetof(SceneVertex, light));
    integer_attribute(array, 5, offsetof(SceneVertex, material));
    integer_attribute(array, 6, offsetof(SceneVertex, lamps));
    integer_attribute(array, 7, offsetof(SceneVertex, object));
    // Only the tree, the chunks and the kinds are needed from here on.
    scene_.vertices = {};
    scene_.indices = {};
    scene_.materials = {};
}

void ScenePass::upload_images(const content::SceneDesc& scene) {
    for (const ImageArray& array : scene_.image_arrays) {
        Texture texture = Texture::create(GLenum{GL_TEXTURE_2D_ARRAY});
        const int levels = 1 + static_cast<int>(std::floor(std::log2(std::max(array.width, array.height))));
        glTextureStorage3D(texture.name(), levels, GL_SRGB8_ALPHA8, array.width, array.height,
                           static_cast<GLsizei>(array.images.size()));
        for (std::size_t layer = 0; layer < array.images.size(); ++layer) {
            glTextureSubImage3D(texture.name(), 0, 0, 0, static_cast<GLint>(layer), array.width, array.height, 1,
                                GL_RGBA, GL_UNSIGNED_BYTE, scene.images[array.images[layer]].rgba.data());
        }
        glGenerateTextureMipmap(texture.name());
        glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        image_arrays_.push_back(std::move(texture));
    }
}

void ScenePass::upload_lamps(const content::SceneDesc& scene) {
    std::vector<std::array<glm::vec4, 2>> lamps;
    for (const content::Lamp& lamp : scene.lamps) {
        lamps.push_back(
            {glm::vec4(lamp.position, lamp.range), glm::vec4(lamp.intensity * std::numbers::inv_pi_v<float>, 0.0f)});
    }
    lamps_ = make_buffer(lamps);
    lamp_indices_ = make_buffer(scene_.lamp_indices);
}

void ScenePass::make_programs() {
    for (const ChunkKind& kind : scene_.kinds) {
        KindPrograms programs;
        const std::string defines = defines_of(kind, sun_);
        programs.light = make_program("scene.vert", "scene.frag", defines);
        programs.data = make_program("scene_layer.vert", "scene_layer.frag", defines);
        programs.shadow = make_program("shadow.vert", "shadow.frag", defines);
        const auto array_name = [&](int index) {
            return index >= 0 ? image_arrays_[static_cast<std::size_t>(index)].name() : 0u;
        };
        programs.base_colours = array_name(kind.base_colour_array);
        programs.emissions = array_name(kind.emission_array);
        kinds_.push_back(std::move(programs));
    }
}

void ScenePass::draw_shadow_map(int size) {
    // Orthographic along the sun's rays: as wide as what throws shadows, as deep as all that is there.
    const glm::vec3 helper = std::abs(towards_sun_.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 across = glm::normalize(glm::cross(helper, towards_sun_));
    const std::array<glm::vec3, 3> axes{across, glm::cross(towards_sun_, across), -towards_sun_};
    glm::mat3 rows(0.0f);
    glm::vec3 shift(0.0f);
    float widest = 0.0f;
    for (glm::length_t i = 0; i < 3; ++i) {
        const glm::vec3& axis = axes.at(static_cast<std::size_t>(i));
        const Box& box = i < 2 ? casters_ : scene_.nodes.front().box;
        const glm::vec3 centre = 0.5f * (box.low + box.high);
        const glm::vec3 half = 0.5f * (box.high - box.low);
        const float reach = glm::dot(glm::abs(axis), half) * 1.001f + 0.01f;
        rows[i] = axis / (2.0f * reach);
        shift[i] = 0.5f - glm::dot(rows[i], centre);
        widest = i < 2 ? std::max(widest, 2.0f * reach) : widest;
    }
    shadow_from_world_ = glm::mat4x3(glm::transpose(rows));
    shadow_from_world_[3] = shift;
    shadow_offset_ = 0.8f * widest / static_cast<float>(size);

    shadow_map_ = Texture::create(GLenum{GL_TEXTURE_2D});
    const GLuint map = shadow_map_.name();
    glTextureStorage2D(map, 1, GL_DEPTH_COMPONENT32F, size, size);
    glTextureParameteri(map, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(map, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    const std::array<float, 4> beyond_everything{2.0f, 2.0f, 2.0f, 2.0f}; // outside the map the sun shines
    glTextureParameteri(map, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTextureParameteri(map, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTextureParameterfv(map, GL_TEXTURE_BORDER_COLOR, beyond_everything.data());
    glTextureParameteri(map, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(map, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    const Framebuffer framebuffer = Framebuffer::create();
    glNamedFramebufferTexture(framebuffer.name(), GL_DEPTH_ATTACHMENT, map, 0);
    glNamedFramebufferDrawBuffer(framebuffer.name(), GL_NONE);

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glViewport(0, 0, size, size);
    use_reversed_depth();
    glDepthFunc(GL_LESS);
    glDisable(GL_CULL_FACE); // what is open from behind still casts a shadow
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0f, 1.0f);
    const float farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    bind();
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        counts_[kind].clear();
        first_indices_[kind].clear();
    }
    for (const Chunk& chunk : scene_.chunks) {
        const GLuint program = kinds_[chunk.kind].shadow.name();
        glProgramUniformMatrix4x3fv(program, shadow_from_world, 1, GL_FALSE, glm::value_ptr(shadow_from_world_));
        glUseProgram(program);
        glBindTextureUnit(base_colour_unit, kinds_[chunk.kind].base_colours);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(chunk.index_count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(chunk.first_index * sizeof(std::uint32_t)));
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    leave_scene_state();
}

void ScenePass::bind() const {
    glBindVertexArray(vertex_array_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, materials_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, lamps_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, lamp_indices_.name());
    glBindTextureUnit(shadow_unit, shadow_map_.name());
}

void ScenePass::set_view(const Program& program, const glm::dvec3& eye, float gain, float coverage) const {
    const glm::vec3 rounded(eye);
    const glm::vec3 remainder(eye - glm::dvec3(rounded));
    glProgramUniform3fv(program.name(), eye_position, 1, glm::value_ptr(rounded));
    glProgramUniform3fv(program.name(), eye_remainder, 1, glm::value_ptr(remainder));
    glProgramUniform1f(program.name(), near_plane, near_distance);
    glProgramUniform3fv(program.name(), towards_sun, 1, glm::value_ptr(towards_sun_));
    glProgramUniformMatrix4x3fv(program.name(), shadow_from_world, 1, GL_FALSE, glm::value_ptr(shadow_from_world_));
    glProgramUniform1f(program.name(), shadow_offset, shadow_offset_);
    glProgramUniform3fv(program.name(), sun_light, 1, glm::value_ptr(sun_light_));
    glProgramUniform1f(program.name(), gain_factor, gain);
    glProgramUniform1f(program.name(), coverage_alpha, coverage);
}

std::int64_t ScenePass::draw_light(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye,
                                   float gain, float coverage) {
    culler_.set_eye(eye);
    for (const KindPrograms& kind : kinds_) {
        set_view(kind.light, eye, gain, coverage);
    }
    return draw_tiles(plan, axis_from_world, &KindPrograms::light);
}

std::int64_t ScenePass::draw_data(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye) {
    culler_.set_eye(eye);
    for (const KindPrograms& kind : kinds_) {
        set_view(kind.data, eye, 1.0f, 1.0f);
    }
    return draw_tiles(plan, axis_from_world, &KindPrograms::data);
}

std::int64_t ScenePass::draw_tiles(const TilePlan& plan, const glm::dmat3& axis_from_world,
                                   Program KindPrograms::*program) {
    std::int64_t triangles = 0;
    use_reversed_depth();
    bind();
    for (const Tile& tile : plan.tiles) {
        const glm::dmat3 texels_from_world = tile.texels_from_axis * axis_from_world;
        const glm::dvec2 size(tile.size);
        glm::dmat3 rows = glm::transpose(texels_from_world);
        rows[0] = rows[0] * (2.0 / size.x) - rows[2];
        rows[1] = rows[1] * (2.0 / size.y) - rows[2];
        glViewport(tile.atlas_corner.x, tile.atlas_corner.y, tile.size.x, tile.size.y);
        triangles += draw_chunks(culler_.visible(texels_from_world, size), glm::transpose(rows), program);
    }
    leave_scene_state();
    return triangles;
}

std::int64_t ScenePass::draw_chunks(const std::vector<std::uint32_t>& chunks, const glm::dmat3& picture,
                                    Program KindPrograms::*program) {
    std::int64_t triangles = 0;
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        counts_[kind].clear();
        first_indices_[kind].clear();
    }
    for (const std::uint32_t index : chunks) {
        const Chunk& chunk = scene_.chunks[index];
        counts_[chunk.kind].push_back(static_cast<GLsizei>(chunk.index_count));
        first_indices_[chunk.kind].push_back(reinterpret_cast<const void*>(chunk.first_index * sizeof(std::uint32_t)));
        triangles += chunk.index_count / 3;
    }
    const glm::mat3 matrix(picture);
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        if (counts_[kind].empty()) {
            continue;
        }
        const GLuint name = (kinds_[kind].*program).name();
        glUseProgram(name);
        glUniformMatrix3fv(picture_from_world, 1, GL_FALSE, glm::value_ptr(matrix));
        glBindTextureUnit(base_colour_unit, kinds_[kind].base_colours);
        glBindTextureUnit(emission_unit, kinds_[kind].emissions);
        glMultiDrawElements(GL_TRIANGLES, counts_[kind].data(), GL_UNSIGNED_INT, first_indices_[kind].data(),
                            static_cast<GLsizei>(counts_[kind].size()));
    }
    return triangles;
}

} // namespace render
