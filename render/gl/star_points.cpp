#include "render/gl/star_points.h"

#include "render/colour/star_photometry.h"
#include "render/eye_ray.h"
#include "render/gl/shader_library.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace render {
namespace {

struct StarVertex {
    glm::vec3 position;
    glm::vec3 position_remainder;
    glm::vec2 source; // ln strength, ln temperature
};

/// A double as the sum of two floats.
struct Split {
    explicit Split(const glm::dvec3& v) : rounded(v), remainder(v - glm::dvec3(rounded)) {}
    glm::vec3 rounded;
    glm::vec3 remainder;
};

constexpr int margin = 3; // pixels, half of star_footprint in shared/star.glsl

void attribute(GLuint vertex_array, GLuint location, GLint components, std::size_t offset) {
    glEnableVertexArrayAttrib(vertex_array, location);
    glVertexArrayAttribFormat(vertex_array, location, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(vertex_array, location, 0);
}

} // namespace

StarPoints::StarPoints(const content::SceneDesc& scene, const DopplerColour& colour)
    : count_(static_cast<GLsizei>(scene.stars.size())), program_(make_program("stars.vert", "stars.frag")),
      vertices_(Buffer::create()), vertex_array_(VertexArray::create()),
      black_bodies_(Texture::create(GLenum{GL_TEXTURE_1D})) {
    std::vector<StarVertex> vertices;
    vertices.reserve(scene.stars.size());
    for (const content::Star& star : scene.stars) {
        const Split position(star.position);
        const StarSource source = star_source(colour, star);
        vertices.push_back(
            {position.rounded, position.remainder, glm::vec2(glm::dvec2(source.ln_strength, source.ln_temperature))});
    }
    glNamedBufferStorage(vertices_.name(), static_cast<GLsizeiptr>(vertices.size() * sizeof(StarVertex)),
                         vertices.data(), 0);
    const GLuint array = vertex_array_.name();
    glVertexArrayVertexBuffer(array, 0, vertices_.name(), 0, sizeof(StarVertex));
    attribute(array, 0, 3, offsetof(StarVertex, position));
    attribute(array, 1, 3, offsetof(StarVertex, position_remainder));
    attribute(array, 2, 2, offsetof(StarVertex, source));

    const BlackBodyTexels table = black_body_texels(colour);
    coordinate_ = {table.coordinate_scale, table.coordinate_offset};
    const GLuint texture = black_bodies_.name();
    glTextureStorage1D(texture, 1, GL_RGBA32F, BlackBodyTexels::samples);
    glTextureSubImage1D(texture, 0, 0, BlackBodyTexels::samples, GL_RGBA, GL_FLOAT, table.texels.data());
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

void StarPoints::draw(const RenderFrame& frame, const sim::BoostAndRotation& eye, double pre_exposure) const {
    const Split position(frame.eye.position / frame.metres_per_light_year);
    const glm::vec3 along(eye.along);
    const glm::mat3 head_from_boosted(glm::transpose(eye.boosted_from_head));
    const glm::vec2 size(static_cast<float>(frame.eye.width), static_cast<float>(frame.eye.height));
    const auto focal_pixels = static_cast<float>(focal_length_pixels(frame.eye));
    const glm::vec2 axis(axis_pixel(frame.eye));
    const StarMode mode = star_mode(frame.mode);

    const GLuint program = program_.name();
    glProgramUniform3fv(program, 0, 1, glm::value_ptr(position.rounded));
    glProgramUniform3fv(program, 1, 1, glm::value_ptr(position.remainder));
    glProgramUniform3fv(program, 2, 1, glm::value_ptr(along));
    glProgramUniform1f(program, 3, static_cast<float>(std::exp(eye.xi.value)));
    glProgramUniformMatrix3fv(program, 4, 1, GL_FALSE, glm::value_ptr(head_from_boosted));
    glProgramUniform3f(program, 5, axis.x, size.y - axis.y, focal_pixels);
    glProgramUniform2f(program, 6, size.x, size.y);
    glProgramUniform2f(program, 7, static_cast<float>(mode.temperature_shift), static_cast<float>(mode.exponent));
    glProgramUniform2f(program, 8, coordinate_.x, coordinate_.y);
    glProgramUniform1f(program, 9, static_cast<float>(pre_exposure));
    glProgramUniform1f(program, 10, static_cast<float>(faintest_star_shown));

    glUseProgram(program);
    glBindVertexArray(vertex_array_.name());
    glBindTextureUnit(0, black_bodies_.name());
    glViewport(-margin, -margin, frame.eye.width + 2 * margin, frame.eye.height + 2 * margin);
    glPointSize(2.0f * margin);
    glDrawArrays(GL_POINTS, 0, count_);
}

} // namespace render
