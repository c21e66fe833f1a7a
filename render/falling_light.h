#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

/// How light falls on surfaces at rest: the shaders' own functions.
namespace render::shared {
using glm::clamp;
using glm::dot;
using glm::max;
using glm::sqrt;
using glm::vec3;
namespace {
#include "render/shaders/shared/surface_light.glsl"
}
} // namespace render::shared
