# cmake -DSHADER_DIR=... -DOUTPUT=... -P embed_shaders.cmake: writes every file below SHADER_DIR into one C++ source.
file(GLOB_RECURSE files RELATIVE ${SHADER_DIR} ${SHADER_DIR}/*)
list(SORT files)
set(entries "")
foreach(name IN LISTS files)
  file(READ ${SHADER_DIR}/${name} text)
  string(APPEND entries "    {\"${name}\", R\"shader_text(${text})shader_text\"},\n")
endforeach()
list(LENGTH files count)
file(WRITE ${OUTPUT} "// Generated from render/shaders by render/gl/embed_shaders.cmake.
#include \"render/gl/shader_library.h\"

#include <array>

namespace render {
namespace {
constexpr std::array<EmbeddedShader, ${count}> files{{
${entries}}};
} // namespace

std::span<const EmbeddedShader> embedded_shaders() {
    return files;
}

} // namespace render
")
