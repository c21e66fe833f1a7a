#include "render/cabin/comfort_pass.h"

#include "render/gl/shader_library.h"

namespace render {

ComfortPass::ComfortPass()
    : program_(make_program("fullscreen.vert", "comfort.frag")), no_attributes_(VertexArray::create()) {}

void ComfortPass::draw(const ViewTangents& tangents, const ComfortEffects& effects, unsigned target_framebuffer,
                       const Viewport& viewport) {
    if (effects.narrowing <= 0.0f && effects.fade <= 0.0f) {
        return;
    }
    glProgramUniform4f(program_.name(), 0, static_cast<float>(tangents.left), static_cast<float>(tangents.right),
                       static_cast<float>(tangents.down), static_cast<float>(tangents.up));
    glProgramUniform1f(program_.name(), 1, effects.narrowing);
    glProgramUniform1f(program_.name(), 2, effects.fade);
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glUseProgram(program_.name());
    glBindVertexArray(no_attributes_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
}

} // namespace render
