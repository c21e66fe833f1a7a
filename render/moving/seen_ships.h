#pragma once

#include "render/moving/hull_light.h"
#include "render/render_frame.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace render {

/// A ship's shape as the light that meets at the eye paints it in the world: each vertex where its own light left it.
/// A scene at rest of that shape, seen by the same eye, is the same picture (PHYSICS 6), so every method that draws
/// the world at rest draws it. Between vertices shape and light are linear.
struct SeenShip {
    struct Vertex {
        glm::vec3 from_eye{0.0f};      ///< scene metres, world axes
        glm::vec3 radiance{0.0f};      ///< linear RGB as the eye sees it
        float wavelength_ratio = 1.0f; ///< D, ship to eye
        float object = 0.0f;           ///< number for Layer::object
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< three a triangle, counter-clockwise seen from outside
    glm::vec3 centre{0.0f};             ///< of a sphere about all vertices, from the eye
    float radius = 0.0f;
};

/// The ships of a frame, those that have a body. `colour`: of the scene.
std::vector<SeenShip> see_ships(const RenderFrame& frame, const Surroundings& surroundings,
                                const DopplerColour& colour);

} // namespace render
