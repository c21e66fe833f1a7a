#include "render/gl/egl_context.h"
#include "render/gl/gl_objects.h"
#include "render/gl/shader_library.h"
#include "sim/bad_input.h"

#include <catch2/catch_test_macros.hpp>

#include <utility>

TEST_CASE("A context without a window has OpenGL 4.5 and compiles the embedded shaders") {
    const render::EglContext context;
    CHECK_NOTHROW(render::require_opengl_45());
    CHECK(render::shader_text("fullscreen.vert").starts_with("#version 450 core\n"));
    CHECK_THROWS_AS(render::shader_text("no_such.frag"), sim::BadInput);
}

TEST_CASE("GL objects move and leave nothing behind") {
    const render::EglContext context;
    render::Buffer first = render::Buffer::create();
    const GLuint name = first.name();
    render::Buffer second = std::move(first);
    CHECK(second.name() == name);
    CHECK(glIsBuffer(name) == GL_TRUE);
    second = render::Buffer();
    CHECK(glIsBuffer(name) == GL_FALSE);
}
