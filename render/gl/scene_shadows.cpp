#include "render/cube_face.h"
#include "render/gl/scene_bindings.h"
#include "render/gl/scene_pass.h"
#include "render/gl/shader_library.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

/// The shadow maps of ScenePass: the sun's and the lamps'.
namespace render {

void ScenePass::draw_lamp_shadows(const content::SceneDesc& scene) {
    // 1.5 MB a lamp as long as they are few.
    constexpr std::size_t most_lamps = 340; // 2048 faces are what every OpenGL 4.5 has
    const std::size_t lamps = std::min(scene.lamps.size(), most_lamps);
    shadowed_lamps_ = static_cast<int>(lamps);
    lamp_shadow_texels_ = lamps <= 40 ? 256 : (lamps <= 160 ? 128 : 64);
    lamp_shadows_ = Texture::create(GLenum{GL_TEXTURE_CUBE_MAP_ARRAY});
    const GLuint map = lamp_shadows_.name();
    const int faces = 6 * shadowed_lamps_;
    glTextureStorage3D(map, 1, GL_DEPTH_COMPONENT32F, lamp_shadow_texels_, lamp_shadow_texels_, faces);
    glTextureParameteri(map, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(map, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(map, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(map, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL); // depth is reversed
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        kinds_[i].lamp_shadow = make_program("scene_layer.vert", "shadow.frag", data_defines(scene_.kinds[i]));
    }
    const Framebuffer framebuffer = Framebuffer::create();
    glNamedFramebufferDrawBuffer(framebuffer.name(), GL_NONE);
    use_reversed_depth();
    glDisable(GL_CULL_FACE); // what is open from behind still casts a shadow
    bind();
    const glm::dvec2 size(lamp_shadow_texels_);
    for (int face = 0; face < faces; ++face) {
        glNamedFramebufferTextureLayer(framebuffer.name(), GL_DEPTH_ATTACHMENT, map, 0, face);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, lamp_shadow_texels_, lamp_shadow_texels_);
        const float infinitely_far = 0.0f;
        glClearBufferfv(GL_DEPTH, 0, &infinitely_far);
        const glm::dvec3 position(scene.lamps[static_cast<std::size_t>(face / 6)].position);
        if (face % 6 == 0) {
            culler_.set_eye(position);
            for (const KindPrograms& kind : kinds_) {
                set_view(kind.lamp_shadow, position);
                glProgramUniform1f(kind.lamp_shadow.name(), near_plane, static_cast<float>(content::lamp_clearance));
            }
        }
        const glm::dvec3 axis = direction_from_face(face % 6, 0.0, 0.0);
        // Along the face's coordinates: differences of directions before they are made unit.
        const glm::dmat3 rows(std::sqrt(2.0) * direction_from_face(face % 6, 1.0, 0.0) - axis,
                              std::sqrt(2.0) * direction_from_face(face % 6, 0.0, 1.0) - axis, axis);
        const glm::dmat3 texel_rows(0.5 * size.x * (rows[0] + axis), 0.5 * size.y * (rows[1] + axis), axis);
        draw_chunks(culler_.visible(glm::transpose(texel_rows), size), glm::transpose(rows),
                    &KindPrograms::lamp_shadow);
    }
    leave_scene_state();
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
                       element_offset(chunk.first_index * sizeof(std::uint32_t)));
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    leave_scene_state();
}

} // namespace render
