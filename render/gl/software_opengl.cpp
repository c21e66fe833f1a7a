#include "render/gl/software_opengl.h"

#include <epoxy/gl.h>

#include <array>

namespace render {

bool is_software_opengl(std::string_view renderer_name) {
    constexpr std::array<std::string_view, 5> known{"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                                    "Software Rasterizer"};
    for (const std::string_view name : known) {
        if (renderer_name.find(name) != std::string_view::npos) {
            return true;
        }
    }
    return false;
}

bool software_opengl() {
    const GLubyte* const name = glGetString(GL_RENDERER);
    return name != nullptr && is_software_opengl(reinterpret_cast<const char*>(name));
}

} // namespace render
