#include "render/cabin/cabin_pass.h"

#include "render/cube_face.h"
#include "render/gl/scene_bindings.h"
#include "render/gl/shader_library.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cmath>

namespace render {
namespace {

/// Texels along each face of what is mirrored.
constexpr GLsizei around_side = 16;

/// Samples of a pixel, for the edges.
constexpr GLsizei sample_count = 4;

// Locations of cabin.vert, cabin.frag, cabin_screen.frag.
enum CabinLocation : GLint {
    eye_from_cabin = 0,
    eye_place = 1,
    view_tangents = 2,
    cabin_near = 3,
    cabin_exposure = 4,
    cabin_filmic = 5,
    cabin_brightest = 6,
};

struct ScreenVertex {
    glm::vec3 position;
    glm::vec2 place;
};

std::vector<ScreenVertex> screen_vertices(const std::vector<content::generator::PanelScreen>& screens) {
    std::vector<ScreenVertex> vertices;
    for (const content::generator::PanelScreen& screen : screens) {
        const auto corner = [&](double x, double y) {
            const glm::dvec2 share(0.5 + 0.5 * x, 0.5 - 0.5 * y);
            return ScreenVertex{glm::vec3(screen.centre + x * screen.right + y * screen.up),
                                glm::vec2(screen.low + share * (screen.high - screen.low))};
        };
        for (const auto& [x, y] :
             {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
            vertices.push_back(corner(x, y));
        }
    }
    return vertices;
}

void attribute(GLuint array, GLuint index, GLint components, GLuint binding, std::size_t offset) {
    glEnableVertexArrayAttrib(array, index);
    glVertexArrayAttribFormat(array, index, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, index, binding);
}

template <class Element>
void fill(const Buffer& buffer, const std::vector<Element>& elements) {
    glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(), 0);
}

} // namespace

CabinPass::CabinPass(const content::generator::Cabin& cabin)
    : cabin_program_(make_program("cabin.vert", "cabin.frag")),
      screen_program_(make_program("cabin.vert", "cabin.frag", "#define SCREEN\n")),
      cover_program_(make_program("fullscreen.vert", "cabin_cover.frag")), positions_(Buffer::create()),
      normals_(Buffer::create()), light_(Buffer::create()), indices_(Buffer::create()), screens_(Buffer::create()),
      cabin_array_(VertexArray::create()), screen_array_(VertexArray::create()), no_attributes_(VertexArray::create()),
      panel_sampler_(Sampler::create()), around_sampler_(Sampler::create()),
      around_(Texture::create(GLenum{GL_TEXTURE_CUBE_MAP})) {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    for (const content::Vertex& vertex : cabin.mesh.vertices) {
        positions.push_back(vertex.position);
        normals.push_back(vertex.normal);
    }
    fill(positions_, positions);
    fill(normals_, normals);
    fill(indices_, cabin.mesh.indices);
    index_count_ = static_cast<GLsizei>(cabin.mesh.indices.size());
    const std::vector<glm::vec4> dark(positions.size(), glm::vec4(0.0f));
    glNamedBufferStorage(light_.name(), static_cast<GLsizeiptr>(dark.size() * sizeof(glm::vec4)), dark.data(),
                         GL_DYNAMIC_STORAGE_BIT);
    glTextureStorage2D(around_.name(), 1, GL_RGBA32F, around_side, around_side);
    glVertexArrayVertexBuffer(cabin_array_.name(), 0, positions_.name(), 0, sizeof(glm::vec3));
    glVertexArrayVertexBuffer(cabin_array_.name(), 1, light_.name(), 0, sizeof(glm::vec4));
    glVertexArrayVertexBuffer(cabin_array_.name(), 2, normals_.name(), 0, sizeof(glm::vec3));
    glVertexArrayElementBuffer(cabin_array_.name(), indices_.name());
    attribute(cabin_array_.name(), 0, 3, 0, 0);
    attribute(cabin_array_.name(), 1, 4, 1, 0);
    attribute(cabin_array_.name(), 2, 3, 2, 0);

    const std::vector<ScreenVertex> corners = screen_vertices(cabin.screens);
    fill(screens_, corners);
    screen_count_ = static_cast<GLsizei>(corners.size());
    glVertexArrayVertexBuffer(screen_array_.name(), 0, screens_.name(), 0, sizeof(ScreenVertex));
    attribute(screen_array_.name(), 0, 3, 0, offsetof(ScreenVertex, position));
    attribute(screen_array_.name(), 1, 2, 0, offsetof(ScreenVertex, place));

    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glSamplerParameteri(around_sampler_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(around_sampler_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(panel_sampler_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(panel_sampler_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(panel_sampler_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(panel_sampler_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void CabinPass::set_light(const CabinLight& cabin, const LightFromAround& light) {
    const std::vector<glm::vec3> radiance = cabin.radiance(light);
    std::vector<glm::vec4> vertices;
    vertices.reserve(radiance.size());
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        vertices.emplace_back(radiance[i], cabin.openness()[i]);
    }
    glNamedBufferSubData(light_.name(), 0, static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec4)),
                         vertices.data());
    std::vector<glm::vec4> texels;
    for (int face = 0; face < 6; ++face) {
        for (int row = 0; row < around_side; ++row) {
            for (int column = 0; column < around_side; ++column) {
                const glm::dvec3 direction = direction_from_face(face, (2.0 * column + 1.0) / around_side - 1.0,
                                                                 (2.0 * row + 1.0) / around_side - 1.0);
                texels.emplace_back(light.radiance_from(glm::vec3(direction)), 1.0f);
            }
        }
    }
    glTextureSubImage3D(around_.name(), 0, 0, 0, 0, around_side, around_side, 6, GL_RGBA, GL_FLOAT, texels.data());
}

void CabinPass::resize(const glm::ivec2& size) {
    if (size == size_) {
        return;
    }
    size_ = size;
    samples_ = Texture::create(GLenum{GL_TEXTURE_2D_MULTISAMPLE});
    glTextureStorage2DMultisample(samples_.name(), sample_count, GL_RGBA8, size.x, size.y, GL_TRUE);
    depth_ = Texture::create(GLenum{GL_TEXTURE_2D_MULTISAMPLE});
    glTextureStorage2DMultisample(depth_.name(), sample_count, GL_DEPTH_COMPONENT32F, size.x, size.y, GL_TRUE);
    sampled_ = Framebuffer::create();
    glNamedFramebufferTexture(sampled_.name(), GL_COLOR_ATTACHMENT0, samples_.name(), 0);
    glNamedFramebufferTexture(sampled_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    smooth_ = Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(smooth_.name(), 1, GL_RGBA8, size.x, size.y);
    resolved_ = Framebuffer::create();
    glNamedFramebufferTexture(resolved_.name(), GL_COLOR_ATTACHMENT0, smooth_.name(), 0);
}

void CabinPass::draw(const CabinView& view, const CabinExposure& exposure, GLuint panel, unsigned target_framebuffer,
                     const Viewport& viewport) {
    resize({viewport.width, viewport.height});
    const glm::mat3 turn(glm::mat3_cast(glm::conjugate(view.cabin_from_eye)));
    const glm::vec3 eye(view.eye);
    for (const Program* program : {&cabin_program_, &screen_program_}) {
        const GLuint name = program->name();
        glProgramUniformMatrix3fv(name, eye_from_cabin, 1, GL_FALSE, glm::value_ptr(turn));
        glProgramUniform3fv(name, eye_place, 1, glm::value_ptr(eye));
        glProgramUniform4f(name, view_tangents, static_cast<float>(view.tangents.left),
                           static_cast<float>(view.tangents.right), static_cast<float>(view.tangents.down),
                           static_cast<float>(view.tangents.up));
        glProgramUniform1f(name, cabin_near, near_distance);
    }
    glProgramUniform1f(cabin_program_.name(), cabin_exposure, static_cast<float>(std::exp2(exposure.stops)));
    glProgramUniform1f(cabin_program_.name(), cabin_brightest, exposure.brightest);
    glProgramUniform1i(cabin_program_.name(), cabin_filmic, exposure.linear_curve ? 0 : 1);

    constexpr std::array<float, 4> nothing{0.0f, 0.0f, 0.0f, 0.0f};
    constexpr float infinitely_far = 0.0f; // depth is reversed
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
    glViewport(0, 0, viewport.width, viewport.height);
    use_reversed_depth();
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_DEPTH, 0, &infinitely_far);
    glUseProgram(cabin_program_.name());
    glBindVertexArray(cabin_array_.name());
    glBindTextureUnit(0, around_.name());
    glBindSampler(0, around_sampler_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    if (panel != 0) {
        glUseProgram(screen_program_.name());
        glBindTextureUnit(0, panel);
        glBindSampler(0, panel_sampler_.name());
        glBindVertexArray(screen_array_.name());
        glDrawArrays(GL_TRIANGLES, 0, screen_count_);
    }
    glBindSampler(0, 0);
    leave_scene_state();

    glBlitNamedFramebuffer(sampled_.name(), resolved_.name(), 0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    glDisable(GL_FRAMEBUFFER_SRGB); // colours are encoded already
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(cover_program_.name());
    glBindVertexArray(no_attributes_.name());
    glBindTextureUnit(0, smooth_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
}

} // namespace render
