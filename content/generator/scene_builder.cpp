#include "content/generator/scene_builder.h"

namespace content::generator {

std::size_t add_painted_material(SceneDesc& scene, Image image) {
    Material material;
    material.name = image.name;
    material.base_colour_image = scene.images.size();
    scene.images.push_back(std::move(image));
    scene.materials.push_back(std::move(material));
    return scene.materials.size() - 1;
}

std::size_t add_masked_material(SceneDesc& scene, Image image) {
    const std::size_t index = add_painted_material(scene, std::move(image));
    scene.materials[index].alpha_mode = AlphaMode::mask;
    scene.materials[index].double_sided = true;
    return index;
}

std::size_t add_plain_material(SceneDesc& scene, std::string name, const glm::vec3& base_colour) {
    Material material;
    material.name = std::move(name);
    material.base_colour = glm::vec4(base_colour, 1.0f);
    scene.materials.push_back(std::move(material));
    return scene.materials.size() - 1;
}

std::size_t add_glowing_material(SceneDesc& scene, std::string name, const glm::vec3& emission) {
    Material material;
    material.name = std::move(name);
    material.base_colour = glm::vec4(glm::vec3(0.0f), 1.0f);
    material.emission = emission;
    scene.materials.push_back(std::move(material));
    return scene.materials.size() - 1;
}

std::size_t add_mesh(SceneDesc& scene, Mesh mesh) {
    scene.meshes.push_back(std::move(mesh));
    return scene.meshes.size() - 1;
}

void place(SceneDesc& scene, std::string name, std::size_t mesh, const glm::mat4& world_from_mesh) {
    scene.instances.push_back({std::move(name), mesh, world_from_mesh});
}

void place(SceneDesc& scene, std::string name, const MeshBuilder& builder, std::size_t material) {
    if (builder.empty()) {
        return;
    }
    const std::size_t mesh = add_mesh(scene, builder.mesh(name, material));
    place(scene, std::move(name), mesh);
}

} // namespace content::generator
