#include "render/gl/sky_cube.h"

#include "render/cube_face.h"
#include "render/panorama.h"

#include <array>
#include <cmath>
#include <future>
#include <glm/common.hpp>
#include <vector>

namespace render {
namespace {

std::vector<glm::vec3> face_of(const content::Panorama& panorama, int face, int size) {
    // Brighter than a half float holds only where the sun's disc is: its texels keep the largest number there is.
    constexpr double largest_half = 65504.0;
    std::vector<glm::vec3> texels;
    texels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::dvec3 direction =
                direction_from_face(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0);
            texels.emplace_back(glm::min(panorama_radiance(panorama, direction), glm::dvec3(largest_half)));
        }
    }
    return texels;
}

} // namespace

SkyCube::SkyCube(const content::Panorama& panorama)
    : size_(cube_face_size(panorama)), texture_(Texture::create(GLenum{GL_TEXTURE_CUBE_MAP})) {
    std::array<std::future<std::vector<glm::vec3>>, 6> faces;
    for (int face = 0; face < 6; ++face) {
        faces[static_cast<std::size_t>(face)] =
            std::async(std::launch::async, [&panorama, face, size = size_] { return face_of(panorama, face, size); });
    }
    const GLuint name = texture_.name();
    const int levels = 1 + static_cast<int>(std::log2(size_));
    glTextureStorage2D(name, levels, GL_RGBA16F, size_, size_);
    for (int face = 0; face < 6; ++face) {
        const std::vector<glm::vec3> texels = faces[static_cast<std::size_t>(face)].get();
        glTextureSubImage3D(name, 0, 0, 0, face, size_, size_, 1, GL_RGB, GL_FLOAT, texels.data());
    }
    glGenerateTextureMipmap(name);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

} // namespace render
