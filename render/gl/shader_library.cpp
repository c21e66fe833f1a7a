#include "render/gl/shader_library.h"

#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace render {
namespace {

std::string file_text(const std::string& name) {
    if (const char* folder = std::getenv("RAPIDITY_SHADER_DIR"); folder != nullptr && *folder != '\0') {
        const std::filesystem::path path = std::filesystem::path(folder) / name;
        std::ifstream stream(path);
        std::ostringstream text;
        text << stream.rdbuf();
        if (!stream) {
            throw sim::BadInput(path.string(), "", "", "cannot be read (RAPIDITY_SHADER_DIR names the shader folder)");
        }
        return text.str();
    }
    const auto files = embedded_shaders();
    const auto found = std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; });
    if (found == files.end()) {
        throw sim::BadInput("shader " + name, "", "", "is not part of this program");
    }
    return std::string(found->text);
}

void append_with_includes(const std::string& name, std::set<std::string>& seen, std::string& result) {
    if (!seen.insert(name).second) {
        return;
    }
    constexpr std::string_view directive = "#include \"";
    std::istringstream lines(file_text(name));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(directive)) {
            const std::string rest = line.substr(directive.size());
            append_with_includes(rest.substr(0, rest.find('"')), seen, result);
        } else {
            result += line;
            result += '\n';
        }
    }
}

/// The compiler's first line of complaint.
std::string first_line(const std::string& log) {
    return log.substr(0, log.find('\n'));
}

Shader compile(GLenum stage, const std::string& name, const std::string& defines) {
    std::string text = shader_text(name);
    text.insert(text.find('\n') + 1, defines);
    Shader shader = Shader::create(stage);
    const char* pointer = text.c_str();
    glShaderSource(shader.name(), 1, &pointer, nullptr);
    glCompileShader(shader.name());
    GLint good = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good != GL_TRUE) {
        std::array<char, 4096> log{};
        glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw sim::BadInput("shader " + name, "", "", first_line(log.data()));
    }
    return shader;
}

} // namespace

std::string shader_text(const std::string& name) {
    std::set<std::string> seen;
    std::string result;
    append_with_includes(name, seen, result);
    return result;
}

Program make_program(const std::string& vertex_file, const std::string& fragment_file, const std::string& defines) {
    const Shader vertex = compile(GL_VERTEX_SHADER, vertex_file, defines);
    const Shader fragment = compile(GL_FRAGMENT_SHADER, fragment_file, defines);
    Program program = Program::create();
    glAttachShader(program.name(), vertex.name());
    glAttachShader(program.name(), fragment.name());
    glLinkProgram(program.name());
    glDetachShader(program.name(), vertex.name());
    glDetachShader(program.name(), fragment.name());
    GLint good = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good != GL_TRUE) {
        std::array<char, 4096> log{};
        glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw sim::BadInput("shader " + fragment_file, "", "", first_line(log.data()));
    }
    return program;
}

} // namespace render
