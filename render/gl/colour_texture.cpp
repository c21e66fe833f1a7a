#include "render/gl/colour_texture.h"

namespace render {

ColourTexture::ColourTexture(const SceneSpectra& spectra) : texture_(Texture::create(GLenum{GL_TEXTURE_1D_ARRAY})) {
    const GLuint name = texture_.name();
    glTextureStorage2D(name, 1, GL_RGBA32F, FrameColourTable::samples, FrameColourTable(spectra).layers());
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

void ColourTexture::upload(const FrameColourTable& table) {
    glTextureSubImage2D(texture_.name(), 0, 0, 0, FrameColourTable::samples, table.layers(), GL_RGBA, GL_FLOAT,
                        table.texels.data());
    scale_and_offset_ = {table.coordinate_scale, table.coordinate_offset};
}

} // namespace render
