#pragma once

#include <string_view>

namespace render {

/// Whether an OpenGL renderer of that name draws on the processor: Mesa's llvmpipe, softpipe or swrast, or ANGLE's
/// SwiftShader.
bool is_software_opengl(std::string_view renderer_name);

/// The same of the current context.
bool software_opengl();

} // namespace render
