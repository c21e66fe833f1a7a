#include "render/gl/scene_pass.h"

#include "render/gl/scene_bindings.h"
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

void integer_attribute(GLuint array, GLuint location, std::size_t offset) {
    glEnableVertexArrayAttrib(array, location);
    glVertexArrayAttribIFormat(array, location, 1, GL_UNSIGNED_INT, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, location, 0);
}

const char* rule_define(content::ReflectanceRule rule) {
    switch (rule) {
    case content::ReflectanceRule::five_terms:
        return "FIVE_TERMS";
    case content::ReflectanceRule::vegetation:
        return "VEGETATION";
    case content::ReflectanceRule::dominant_wavelength:
        return "DOMINANT_WAVELENGTH";
    case content::ReflectanceRule::own:
        return "OWN_SPECTRUM";
    case content::ReflectanceRule::three_primaries:
        break;
    }
    return "THREE_PRIMARIES";
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

ScenePass::ScenePass(const content::SceneDesc& scene, const SceneSpectra& spectra, int shadow_map_size)
    : spectra_(spectra), scene_(chunk_scene(scene, spectra)), culler_(scene_.nodes, scene_.chunks),
      sun_(scene.sun.has_value()), casters_(box_of_casters(scene_)), counts_(scene_.kinds.size()),
      first_indices_(scene_.kinds.size()) {
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
    if (!scene_.lamp_indices.empty()) {
        draw_lamp_shadows(scene);
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
    for (std::size_t i = 0; i < scene.lamps.size(); ++i) {
        const content::Lamp& lamp = scene.lamps[i];
        lamps.push_back({glm::vec4(lamp.position, lamp.range), glm::vec4(lamp.intensity * std::numbers::inv_pi_v<float>,
                                                                         static_cast<float>(spectra_.lamps()[i]))});
    }
    lamps_ = make_buffer(lamps);
    lamp_indices_ = make_buffer(scene_.lamp_indices);
    hue_wheel_ = make_buffer(spectra_.hue_wheel().steps());
}

void ScenePass::make_programs() {
    for (const ChunkKind& kind : scene_.kinds) {
        KindPrograms programs;
        programs.shadow = make_program("shadow.vert", "shadow.frag", data_defines(kind));
        const auto array_name = [&](int index) {
            return index >= 0 ? image_arrays_[static_cast<std::size_t>(index)].name() : 0u;
        };
        programs.base_colours = array_name(kind.base_colour_array);
        programs.emissions = array_name(kind.emission_array);
        kinds_.push_back(std::move(programs));
    }
}

void ScenePass::make_light_programs(Program KindPrograms::*program, bool shifted) {
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        if (kinds_[i].*program) {
            continue;
        }
        const ChunkKind& kind = scene_.kinds[i];
        const bool lit = !kind.unlit;
        const bool several_lights = lit && kind.near_lamps && spectra_.falling_lights() > 1;
        const bool own_spectrum = lit && kind.rule == content::ReflectanceRule::own;
        const bool emission_spectrum = lit && kind.emits && kind.emission_spectrum;
        Defines defines;
        defines.add(kind.base_colour_array >= 0, "TEXTURED");
        defines.add(kind.emission_array >= 0 && lit, "EMISSION_TEXTURED");
        defines.add(kind.masked, "MASKED");
        defines.add(kind.unlit, "UNLIT");
        defines.add(lit && kind.near_lamps, "NEAR_LAMPS");
        defines.add(sun_ && lit, "SUN");
        defines.add(shifted, "SHIFTED");
        defines.add(shifted || several_lights || own_spectrum || emission_spectrum, "TABLE");
        defines.add(true, rule_define(kind.rule));
        defines.add(lit && kind.invisible, "UV");
        defines.add(lit && kind.emits, "EMITS");
        defines.add(emission_spectrum, "EMISSION_SPECTRUM");
        defines.add(lit && kind.emission_invisible, "EMISSION_INVISIBLE");
        defines.add(true, "LIGHTS " + std::to_string(several_lights ? spectra_.falling_lights() : 1));
        defines.add(true, "LAYERS " + std::to_string(kind.layers));
        defines.add(true, "HUES " + std::to_string(spectra_.hue_wheel().hues()));
        defines.add(true, "SHADOWED_LAMPS " + std::to_string(shadowed_lamps_));
        defines.add(true, "LAMP_SHADOW_TEXELS " + std::to_string(lamp_shadow_texels_));
        kinds_[i].*program = make_program("scene.vert", "scene.frag", defines.text());
    }
}

void ScenePass::make_data_programs() {
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        if (!kinds_[i].data) {
            kinds_[i].data = make_program("scene_layer.vert", "scene_layer.frag", data_defines(scene_.kinds[i]));
        }
    }
}

void ScenePass::bind() const {
    glBindVertexArray(vertex_array_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, materials_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, lamps_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, lamp_indices_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, hue_wheel_.name());
    glBindTextureUnit(shadow_unit, shadow_map_.name());
    glBindTextureUnit(lamp_shadow_unit, lamp_shadows_.name());
}

void ScenePass::set_view(const Program& program, const glm::dvec3& eye) const {
    const glm::vec3 rounded(eye);
    const glm::vec3 remainder(eye - glm::dvec3(rounded));
    glProgramUniform3fv(program.name(), eye_position, 1, glm::value_ptr(rounded));
    glProgramUniform3fv(program.name(), eye_remainder, 1, glm::value_ptr(remainder));
    glProgramUniform1f(program.name(), near_plane, near_distance);
}

void ScenePass::set_light(const Program& program, const glm::dmat3& axis_from_world,
                          const SeenLightSettings& light) const {
    const GLuint name = program.name();
    glProgramUniform3fv(name, towards_sun, 1, glm::value_ptr(towards_sun_));
    glProgramUniformMatrix4x3fv(name, shadow_from_world, 1, GL_FALSE, glm::value_ptr(shadow_from_world_));
    glProgramUniform1f(name, shadow_offset, shadow_offset_);
    glProgramUniform3fv(name, sun_light, 1, glm::value_ptr(sun_light_));
    glProgramUniform1f(name, gain_factor, light.gain);
    glProgramUniform1f(name, coverage_alpha, light.coverage);
    if (light.shifted) {
        const glm::vec3 along(glm::transpose(axis_from_world)[2]);
        glProgramUniform3fv(name, along_motion, 1, glm::value_ptr(along));
        glProgramUniform1f(name, exp_rapidity, static_cast<float>(light.exp_rapidity));
    }
    glProgramUniform2fv(name, colour_scale_and_offset, 1, glm::value_ptr(light.colours->scale_and_offset()));
}

std::int64_t ScenePass::draw_light(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye,
                                   const SeenLightSettings& light) {
    Program KindPrograms::*const program = light.shifted ? &KindPrograms::shifted : &KindPrograms::light;
    make_light_programs(program, light.shifted);
    culler_.set_eye(eye);
    for (const KindPrograms& kind : kinds_) {
        set_view(kind.*program, eye);
        set_light(kind.*program, axis_from_world, light);
    }
    glBindTextureUnit(colour_table_unit, light.colours->name());
    return draw_tiles(plan, axis_from_world, program);
}

std::int64_t ScenePass::draw_data(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye) {
    make_data_programs();
    culler_.set_eye(eye);
    for (const KindPrograms& kind : kinds_) {
        set_view(kind.data, eye);
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
        glViewport(tile.atlas_corner.x, tile.atlas_corner.y, tile.size.x, tile.size.y);
        triangles += draw_chunks(culler_.visible(texels_from_world, glm::dvec2(tile.size)),
                                 picture_of_tile(tile, axis_from_world), program);
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
        first_indices_[chunk.kind].push_back(element_offset(chunk.first_index * sizeof(std::uint32_t)));
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
