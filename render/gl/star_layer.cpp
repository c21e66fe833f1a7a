#include "render/gl/star_layer.h"

#include "render/gl/shader_library.h"
#include "render/gl/software_opengl.h"

namespace render {

StarLayer::StarLayer(const content::SceneDesc& scene, const DopplerColour& colour, Way way)
    : empty_(scene.stars.empty()) {
    if (empty_) {
        return;
    }
    if (way == Way::points || (way == Way::automatic && !software_opengl())) {
        points_.emplace(scene, colour);
        return;
    }
    sheet_.emplace(scene, colour);
    program_ = make_program("fullscreen.vert", "star_sheet.frag");
    no_attributes_ = VertexArray::create();
}

void StarLayer::draw(const RenderFrame& frame, const sim::BoostAndRotation& eye, double pre_exposure,
                     StereoShare* share) {
    if (empty_) {
        return;
    }
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    if (points_) {
        points_->draw(frame, eye, pre_exposure);
    } else {
        draw_sheet(frame, pre_exposure, share);
    }
    glDisable(GL_BLEND);
    glViewport(0, 0, frame.eye.width, frame.eye.height);
}

void StarLayer::draw_sheet(const RenderFrame& frame, double pre_exposure, StereoShare* share) {
    const glm::vec4* first = nullptr; // of the picture, rows from the top
    int row_length = frame.eye.width;
    if (share != nullptr && share->whole()) {
        const EyeView& whole = *share->whole();
        if (share->stars.empty()) {
            RenderFrame both = frame;
            both.eye = whole;
            sheet_->draw(both, pre_exposure, faintest_star_shown, share->stars);
        }
        const glm::ivec2 corner = share->corner(frame.eye);
        row_length = whole.width;
        first = &share->stars[static_cast<std::size_t>(whole.height - corner.y - frame.eye.height) *
                                  static_cast<std::size_t>(row_length) +
                              static_cast<std::size_t>(corner.x)];
    } else {
        sheet_->draw(frame, pre_exposure, faintest_star_shown, pixels_);
        first = pixels_.data();
    }
    if (frame.eye.width != width_ || frame.eye.height != height_) {
        width_ = frame.eye.width;
        height_ = frame.eye.height;
        texture_ = Texture::create(GLenum{GL_TEXTURE_2D});
        glTextureStorage2D(texture_.name(), 1, GL_RGBA32F, width_, height_);
        glTextureParameteri(texture_.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture_.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glPixelStorei(GL_UNPACK_ROW_LENGTH, row_length);
    glTextureSubImage2D(texture_.name(), 0, 0, 0, width_, height_, GL_RGBA, GL_FLOAT, first);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glViewport(0, 0, width_, height_);
    glUseProgram(program_.name());
    glBindVertexArray(no_attributes_.name());
    glBindTextureUnit(0, texture_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace render
