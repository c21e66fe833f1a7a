#include "content/generator/opening_paint.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/street_parts.h"
#include "content/generator/surface_paint.h"

namespace content::generator {

StreetMaterials add_street_materials(SceneDesc& scene) {
    const auto painted = [&scene](Image image) { return add_painted_material(scene, std::move(image)); };
    const std::size_t grass = painted(grass_image());
    scene.materials[grass].vegetation = true;
    return {.asphalt = painted(asphalt_image()),
            .road = painted(road_image()),
            .zebra = painted(zebra_image()),
            .paving = painted(paving_image()),
            .ashlar = painted(ashlar_image()),
            .stone = painted(stone_image()),
            .plaster = painted(plaster_image()),
            .brick = painted(brick_image()),
            .roof = painted(roof_image()),
            .openings = painted(opening_image()),
            .shops = painted(shop_image()),
            .church = painted(church_image()),
            .tree = add_tree_materials(scene),
            .car = add_plain_material(scene, "car body"),
            .metal = add_plain_material(scene, "cast iron", linear(0x3a4240)),
            .lantern = add_glowing_material(scene, "lantern", glm::vec3(3.2f, 2.3f, 1.3f)),
            .grass = grass};
}

} // namespace content::generator
