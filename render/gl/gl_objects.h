#pragma once

#include <epoxy/gl.h>

#include <bit>
#include <cstdint>
#include <utility>

/// Owners of OpenGL names: created with the object, deleted with it, moved but never copied. All need a current
/// OpenGL 4.5 context (direct state access), also when they are destroyed.
namespace render {

/// Owns one OpenGL name; `Kind` says how it is created and deleted.
template <class Kind>
class GlObject {
  public:
    /// No object: name 0.
    GlObject() = default;
    template <class... Arguments>
    static GlObject create(Arguments... arguments) {
        GlObject object;
        object.name_ = Kind::create(arguments...);
        return object;
    }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;
    ~GlObject() {
        if (name_ != 0) {
            Kind::destroy(name_);
        }
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    GLuint name_ = 0;
};

struct BufferKind {
    static GLuint create() {
        GLuint name = 0;
        glCreateBuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};

struct TextureKind {
    static GLuint create(GLenum target) {
        GLuint name = 0;
        glCreateTextures(target, 1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};

struct SamplerKind {
    static GLuint create() {
        GLuint name = 0;
        glCreateSamplers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteSamplers(1, &name); }
};

struct FramebufferKind {
    static GLuint create() {
        GLuint name = 0;
        glCreateFramebuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};

struct VertexArrayKind {
    static GLuint create() {
        GLuint name = 0;
        glCreateVertexArrays(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};

struct QueryKind {
    static GLuint create(GLenum target) {
        GLuint name = 0;
        glCreateQueries(target, 1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteQueries(1, &name); }
};

struct ShaderKind {
    static GLuint create(GLenum stage) { return glCreateShader(stage); }
    static void destroy(GLuint name) { glDeleteShader(name); }
};

struct ProgramKind {
    static GLuint create() { return glCreateProgram(); }
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

using Buffer = GlObject<BufferKind>;
using Texture = GlObject<TextureKind>;
using Sampler = GlObject<SamplerKind>;
using Framebuffer = GlObject<FramebufferKind>;
using VertexArray = GlObject<VertexArrayKind>;
using Query = GlObject<QueryKind>;
using Shader = GlObject<ShaderKind>;
using Program = GlObject<ProgramKind>;

/// Bytes from the start of the bound element buffer, as draw calls take them: in a pointer.
inline const void* element_offset(std::uintptr_t bytes) {
    return std::bit_cast<const void*>(bytes);
}

} // namespace render
