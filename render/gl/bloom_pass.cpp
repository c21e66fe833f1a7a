#include "render/gl/bloom_pass.h"

#include "render/gl/shader_library.h"

namespace render {
namespace {

constexpr GLint pixels_per_cell = 0;

} // namespace

BloomPass::BloomPass()
    : finest_(make_program("fullscreen.vert", "bloom_finest.frag")),
      level_(make_program("fullscreen.vert", "bloom_level.frag")), no_attributes_(VertexArray::create()) {}

void BloomPass::resize(const glm::ivec2& size) {
    if (size == size_) {
        return;
    }
    size_ = size;
    grid_ = BloomGrid(size);
    cells_.clear();
    framebuffers_.clear();
    for (int level = 1; level <= grid_.levels; ++level) {
        const glm::ivec2 count = grid_.cells(level);
        Texture& texture = cells_.emplace_back(Texture::create(GLenum{GL_TEXTURE_2D}));
        glTextureStorage2D(texture.name(), 1, GL_RGBA16F, count.x, count.y);
        glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        Framebuffer& framebuffer = framebuffers_.emplace_back(Framebuffer::create());
        glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, texture.name(), 0);
    }
}

void BloomPass::draw_level(const Program& program, GLuint source, std::size_t target) const {
    const glm::ivec2 count = grid_.cells(static_cast<int>(target) + 1);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[target].name());
    glViewport(0, 0, count.x, count.y);
    glUseProgram(program.name());
    glBindTextureUnit(0, source);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

GLuint BloomPass::scatter(GLuint light, const glm::ivec2& size) {
    resize(size);
    if (grid_.levels == 0) {
        return 0;
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(no_attributes_.name());
    glProgramUniform2f(finest_.name(), pixels_per_cell, static_cast<float>(size.x) / static_cast<float>(grid_.finest.x),
                       static_cast<float>(size.y) / static_cast<float>(grid_.finest.y));
    draw_level(finest_, light, 0);
    for (std::size_t level = 1; level < cells_.size(); ++level) {
        draw_level(level_, cells_[level - 1].name(), level);
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glBlendColor(0.0f, 0.0f, 0.0f, bloom_spread);
    for (std::size_t level = cells_.size() - 1; level > 0; --level) {
        if (level == 1) {
            glDisable(GL_BLEND); // the finest cells only hand on what the next level is
        }
        draw_level(level_, cells_[level].name(), level - 1);
    }
    return cells_.front().name();
}

} // namespace render
