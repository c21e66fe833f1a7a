#include "content/generator/facade.h"

namespace content::generator {
namespace {

std::array<glm::vec3, 4> corners(const Rectangle& r, float z) {
    return {{{r.low, z}, {r.high.x, r.low.y, z}, {r.high, z}, {r.low.x, r.high.y, z}}};
}

} // namespace

void upright(MeshBuilder& builder, const Rectangle& area, float z) {
    if (area.high.x > area.low.x && area.high.y > area.low.y) {
        builder.quad(corners(area, z));
    }
}

void frame(MeshBuilder& builder, const Rectangle& outer, const Rectangle& inner, float z) {
    upright(builder, {outer.low, {inner.low.x, outer.high.y}}, z);
    upright(builder, {{inner.high.x, outer.low.y}, outer.high}, z);
    upright(builder, {{inner.low.x, outer.low.y}, {inner.high.x, inner.low.y}}, z);
    upright(builder, {{inner.low.x, inner.high.y}, {inner.high.x, outer.high.y}}, z);
}

void reveals(MeshBuilder& builder, const Rectangle& hole, float depth) {
    const glm::vec2 a = hole.low;
    const glm::vec2 b = hole.high;
    const float in = -depth;
    builder.quad({{{a.x, a.y, 0.0f}, {a.x, a.y, in}, {a.x, b.y, in}, {a.x, b.y, 0.0f}}});
    builder.quad({{{b.x, a.y, in}, {b.x, a.y, 0.0f}, {b.x, b.y, 0.0f}, {b.x, b.y, in}}});
    builder.quad({{{a.x, a.y, 0.0f}, {b.x, a.y, 0.0f}, {b.x, a.y, in}, {a.x, a.y, in}}});
    builder.quad({{{a.x, b.y, in}, {b.x, b.y, in}, {b.x, b.y, 0.0f}, {a.x, b.y, 0.0f}}});
}

void picture(MeshBuilder& builder, const Rectangle& area, float z, const TextureArea& texture) {
    builder.quad(corners(area, z), texture);
}

} // namespace content::generator
