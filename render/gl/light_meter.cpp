#include "render/gl/light_meter.h"

#include "render/gl/shader_library.h"

#include <algorithm>
#include <glm/vec2.hpp>

namespace render {

LightMeter::LightMeter()
    : program_(make_program("fullscreen.vert", "light_meter.frag")), no_attributes_(VertexArray::create()),
      sampler_(Sampler::create()) {
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void LightMeter::resize(int columns, int rows) {
    if (columns == columns_ && rows == rows_) {
        return;
    }
    columns_ = columns;
    rows_ = rows;
    squares_ = Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(squares_.name(), 1, GL_RG32F, columns, rows);
    framebuffer_ = Framebuffer::create();
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, squares_.name(), 0);
}

MeteredLight LightMeter::meter(GLuint texture, int width, int height, double pre_exposure) {
    resize(std::max(width / 8, 1), std::max(height / 8, 1));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, columns_, rows_);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glProgramUniform2f(program_.name(), 0, 1.0f / static_cast<float>(width), 1.0f / static_cast<float>(height));
    glUseProgram(program_.name());
    glBindVertexArray(no_attributes_.name());
    glBindTextureUnit(0, texture);
    glBindSampler(0, sampler_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(0, 0);
    const std::size_t squares = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    std::vector<glm::vec2> values(squares);
    glGetTextureImage(squares_.name(), 0, GL_RG, GL_FLOAT, static_cast<GLsizei>(squares * sizeof(glm::vec2)),
                      values.data());
    MeteredLight light;
    for (const glm::vec2& value : values) {
        light.mean.push_back(static_cast<float>(static_cast<double>(value.x) / pre_exposure));
        light.brightest.push_back(static_cast<float>(static_cast<double>(value.y) / pre_exposure));
    }
    return light;
}

} // namespace render
