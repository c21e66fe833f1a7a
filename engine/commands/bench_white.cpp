#include "engine/commands/bench.h"

#include "engine/failure.h"
#include "render/colour/display.h"
#include "render/gl/egl_context.h"
#include "render/gl/gl_objects.h"
#include "render/gl/renderer.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/core.h>
#include <vector>

namespace engine {
namespace {

constexpr int columns = 32;
constexpr int rows = 16;
constexpr int cell = 20; // pixels

using Srgb = std::array<std::uint8_t, 3>;

/// Every grey byte, then a cube of colours.
std::vector<Srgb> chart_colours() {
    std::vector<Srgb> colours;
    for (int byte = 0; byte < 256; ++byte) {
        const auto grey = static_cast<std::uint8_t>(byte);
        colours.push_back({grey, grey, grey});
    }
    for (int i = 0; i < 216; ++i) {
        colours.push_back({static_cast<std::uint8_t>(51 * (i / 36)), static_cast<std::uint8_t>(51 * (i / 6 % 6)),
                           static_cast<std::uint8_t>(51 * (i % 6))});
    }
    return colours;
}

/// A chart that fills a view of 90 degrees from the origin towards -z: unlit squares, row by row from the top left.
content::SceneDesc chart(const std::vector<Srgb>& colours) {
    content::SceneDesc scene;
    scene.materials.emplace_back();
    scene.materials.back().unlit = true;
    content::Mesh mesh;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto left = -1.0f + 2.0f * static_cast<float>(i % columns) / columns;
        const std::size_t row = i / columns;
        const auto top = (1.0f - 2.0f * static_cast<float>(row) / rows) * rows / columns;
        const float side = 2.0f / columns;
        glm::vec4 colour(1.0f);
        for (int j = 0; j < 3; ++j) {
            colour[j] = render::linear_from_srgb(static_cast<float>(colours[i][static_cast<std::size_t>(j)]) / 255.0f);
        }
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::vec2& corner : {glm::vec2(0.0f), {0.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, 0.0f}}) {
            content::Vertex vertex;
            vertex.position = {left + side * corner.x, top - side * corner.y, -1.0f};
            vertex.normal = {0.0f, 0.0f, 1.0f};
            vertex.colour = colour;
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
            mesh.indices.push_back(first + corner);
        }
    }
    scene.meshes.push_back(std::move(mesh));
    scene.instances.emplace_back();
    return scene;
}

/// The largest difference in bytes between the chart's colours and what the renderer shows of them.
int largest_difference(const std::vector<Srgb>& colours, render::Method method) {
    constexpr int width = columns * cell;
    constexpr int height = rows * cell;
    render::RendererSettings settings;
    settings.method = method;
    render::Renderer renderer(chart(colours), settings);
    render::RenderFrame frame;
    frame.eye.width = width;
    frame.eye.height = height;
    frame.display.dither = false;
    const render::Texture texture = render::Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(texture.name(), 1, GL_RGBA8, width, height);
    const render::Framebuffer framebuffer = render::Framebuffer::create();
    glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, texture.name(), 0);
    renderer.draw(frame, framebuffer.name(), {0, 0, width, height});
    std::vector<std::uint8_t> shown(std::size_t{4} * width * height);
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(shown.size()), shown.data());

    int largest = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const std::size_t x = (i % columns) * cell + cell / 2;
        const std::size_t y = height - 1 - ((i / columns) * cell + cell / 2); // rows come from the bottom
        for (std::size_t j = 0; j < 3; ++j) {
            largest = std::max(largest, std::abs(shown[4 * (y * width + x) + j] - colours[i][j]));
        }
    }
    return largest;
}

void bench_white() {
    const render::EglContext context;
    const std::vector<Srgb> colours = chart_colours();
    int largest = 0;
    for (const auto& [method, name] :
         {std::pair(render::Method::plain, "plain"), std::pair(render::Method::texture, "texture"),
          std::pair(render::Method::ray, "ray")}) {
        const int difference = largest_difference(colours, method);
        fmt::print("{} sRGB colours at D = 1, exposure 1, linear curve, {} method: largest difference {}/255\n",
                   colours.size(), name, difference);
        largest = std::max(largest, difference);
    }
    if (largest > 1) {
        throw Failure(fmt::format("a colour changed by {}/255 where nothing moves; 1/255 is allowed", largest));
    }
}

} // namespace

void add_bench_white(CLI::App& bench) {
    bench.add_subcommand("white", "colours at rest: sRGB in against sRGB out")->callback(bench_white);
}

} // namespace engine
