#include "content/gltf.h"

#include "content/file_bytes.h"
#include "content/gltf_document.h"
#include "content/gltf_material.h"
#include "content/gltf_mesh.h"
#include "content/gltf_spectra.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace content {
namespace {

glm::dmat4 world_from_parent_times_node(const GltfDocument& document, const glm::dmat4& parent,
                                        const tinygltf::Node& node, const std::string& field) {
    glm::dmat4 local(1.0);
    if (!node.matrix.empty()) {
        document.check_numbers(node.matrix, 16, field + ".matrix");
        for (int i = 0; i < 16; ++i) {
            local[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        }
        if (local[0][3] != 0.0 || local[1][3] != 0.0 || local[2][3] != 0.0 || local[3][3] != 1.0) {
            document.fail(field + ".matrix", "", "its last row must be 0, 0, 0, 1");
        }
        return parent * local;
    }
    if (!node.translation.empty()) {
        document.check_numbers(node.translation, 3, field + ".translation");
        local = glm::translate(local, {node.translation[0], node.translation[1], node.translation[2]});
    }
    if (!node.rotation.empty()) {
        document.check_numbers(node.rotation, 4, field + ".rotation");
        const glm::dquat turn(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        if (!(glm::length(turn) > 0.0)) {
            document.fail(field + ".rotation", "(0, 0, 0, 0)", "not a quaternion of length 1");
        }
        local = local * glm::mat4_cast(glm::normalize(turn));
    }
    if (!node.scale.empty()) {
        document.check_numbers(node.scale, 3, field + ".scale");
        local = glm::scale(local, {node.scale[0], node.scale[1], node.scale[2]});
    }
    return parent * local;
}

bool is_finite(const glm::mat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) {
                return false;
            }
        }
    }
    return true;
}

// Turns the triangles round, so that under a mirroring transform they are counter-clockwise again.
Mesh mirrored(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    return mesh;
}

/// Walks the node tree of one file and gathers what it places.
class SceneReader {
  public:
    explicit SceneReader(const GltfDocument& document) : document_(document), materials_(read_materials(document)) {}

    SceneDesc read() {
        const std::vector<int> roots = root_nodes();
        std::vector<std::pair<int, glm::dmat4>> waiting;
        const auto wait = [&](std::span<const int> of_nodes, const glm::dmat4& world_from_parent) {
            std::for_each(of_nodes.rbegin(), of_nodes.rend(),
                          [&](int node) { waiting.emplace_back(node, world_from_parent); });
        };
        wait(roots, glm::dmat4(1.0));
        std::set<int> seen;
        const auto& nodes = document_.model.nodes;
        while (!waiting.empty()) {
            const auto [index, parent] = waiting.back();
            waiting.pop_back();
            const std::string field = fmt::format("nodes[{}]", index);
            const tinygltf::Node& node = nodes[document_.checked_index(index, nodes.size(), field)];
            if (!seen.insert(index).second) {
                document_.fail(field, node.name, "the node has two parents or is its own ancestor");
            }
            const glm::dmat4 world_from_node = world_from_parent_times_node(document_, parent, node, field);
            if (!is_finite(glm::mat4(world_from_node))) {
                document_.fail(field, node.name, "its place in the world is beyond the range of numbers");
            }
            place(node, world_from_node, field);
            wait(node.children, world_from_node);
        }
        finish();
        return std::move(scene_);
    }

  private:
    std::vector<int> root_nodes() const {
        const auto& model = document_.model;
        if (model.defaultScene >= 0 || !model.scenes.empty()) {
            const std::size_t index =
                document_.checked_index(std::max(model.defaultScene, 0), model.scenes.size(), "scene");
            return model.scenes[index].nodes;
        }
        std::set<int> children;
        for (const tinygltf::Node& node : model.nodes) {
            children.insert(node.children.begin(), node.children.end());
        }
        std::vector<int> roots;
        for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) {
            if (children.count(i) == 0) {
                roots.push_back(i);
            }
        }
        return roots;
    }

    void place(const tinygltf::Node& node, const glm::dmat4& world_from_node, const std::string& field) {
        if (node.mesh >= 0) {
            place_mesh(node, world_from_node, field);
        }
        if (node.camera >= 0) {
            place_camera(node, world_from_node, field);
        }
        const auto light = node.extensions.find("KHR_lights_punctual");
        if (light != node.extensions.end()) {
            place_light(light->second.Get("light").GetNumberAsInt(), world_from_node, field);
        }
        if (node.skin >= 0) {
            scene_.notes.push_back(fmt::format("{}: skinning is not shown", field));
        }
    }

    void place_mesh(const tinygltf::Node& node, const glm::dmat4& world_from_node, const std::string& field) {
        const auto& meshes = document_.model.meshes;
        const std::size_t source = document_.checked_index(node.mesh, meshes.size(), field + ".mesh");
        const double determinant = glm::determinant(glm::dmat3(world_from_node));
        if (determinant == 0.0) {
            scene_.notes.push_back(fmt::format("{} is scaled to nothing and not shown", field));
            return;
        }
        const bool mirroring = determinant < 0.0;
        for (const std::size_t mesh : meshes_of(source, mirroring)) {
            scene_.instances.push_back(
                {node.name.empty() ? scene_.meshes[mesh].name : node.name, mesh, glm::mat4(world_from_node)});
        }
    }

    const std::vector<std::size_t>& meshes_of(std::size_t source, bool mirroring) {
        const auto known = meshes_.find({source, mirroring});
        if (known != meshes_.end()) {
            return known->second;
        }
        std::vector<std::size_t> indices;
        for (Mesh& mesh : read_mesh(document_, source, materials_, scene_.notes)) {
            indices.push_back(scene_.meshes.size());
            scene_.meshes.push_back(mirroring ? mirrored(std::move(mesh)) : std::move(mesh));
        }
        return meshes_[{source, mirroring}] = std::move(indices);
    }

    glm::dvec3 axis(const glm::dmat4& world_from_node, const glm::dvec3& local, const std::string& field) const {
        const glm::dvec3 world = glm::dmat3(world_from_node) * local;
        const double length = glm::length(world);
        if (!(length > 0.0)) {
            document_.fail(field, "", "is scaled to nothing, so that its light or camera has no direction");
        }
        return world / length;
    }

    void place_camera(const tinygltf::Node& node, const glm::dmat4& world_from_node, const std::string& field) {
        const auto& cameras = document_.model.cameras;
        const std::size_t index = document_.checked_index(node.camera, cameras.size(), field + ".camera");
        const tinygltf::Camera& camera = cameras[index];
        const std::string camera_field = fmt::format("cameras[{}]", index);
        StartView view;
        view.name = node.name.empty() ? camera.name : node.name;
        view.position = glm::dvec3(world_from_node[3]);
        view.look = axis(world_from_node, {0.0, 0.0, -1.0}, field);
        view.up = axis(world_from_node, {0.0, 1.0, 0.0}, field);
        if (camera.type == "perspective") {
            constexpr double pi = 3.14159265358979323846;
            const double vertical = camera.perspective.yfov;
            if (!(vertical > 0.0 && vertical < pi)) {
                document_.fail(camera_field + ".perspective.yfov", fmt::format("{}", vertical),
                               "must be between 0 and pi");
            }
            // Without a ratio of its own the picture's decides; the usual one stands for it.
            constexpr double usual_ratio = 16.0 / 9.0;
            const double declared = camera.perspective.aspectRatio;
            if (declared < 0.0) {
                document_.fail(camera_field + ".perspective.aspectRatio", fmt::format("{}", declared),
                               "must be positive");
            }
            const double ratio = declared > 0.0 ? declared : usual_ratio;
            view.horizontal_field_of_view = 2.0 * std::atan(ratio * std::tan(0.5 * vertical));
        } else {
            scene_.notes.push_back(
                fmt::format("{} is not a perspective camera: it is used with 90 degrees", camera_field));
        }
        scene_.start_views.push_back(view);
    }

    void place_light(int light_index, const glm::dmat4& world_from_node, const std::string& field) {
        const auto& lights = document_.model.lights;
        const std::size_t index =
            document_.checked_index(light_index, lights.size(), field + ".extensions.KHR_lights_punctual.light");
        const tinygltf::Light& light = lights[index];
        const std::string light_field = fmt::format("extensions.KHR_lights_punctual.lights[{}]", index);
        const glm::vec3 strength = light_strength(light, light_field);
        if (light.type == "directional") {
            if (scene_.sun) {
                scene_.notes.push_back(fmt::format("{}: one sun is shown, this second one is not", field));
                return;
            }
            if (lamp_spectrum(document_, light.extras, light_field, scene_.notes)) {
                scene_.notes.push_back(fmt::format(
                    "{}: a sun has no spectrum of its own: sun and sky have the scenario's light_temperature",
                    light_field));
            }
            // A light shines along its -z axis, so that the sun stands where +z points.
            scene_.sun = Sun{glm::vec3(axis(world_from_node, {0.0, 0.0, 1.0}, field)), strength};
            return;
        }
        if (light.type != "point" && light.type != "spot") {
            document_.fail(light_field + ".type", light.type, "must be directional, point or spot");
        }
        if (light.type == "spot") {
            scene_.notes.push_back(fmt::format("{}: the spot light shines in all directions", field));
        }
        if (!(light.range >= 0.0) || !std::isfinite(static_cast<float>(light.range))) {
            document_.fail(light_field + ".range", fmt::format("{}", light.range), "must be positive");
        }
        const std::string name = light.name.empty() ? field : light.name;
        std::optional<Spectrum> own = lamp_spectrum(document_, light.extras, light_field, scene_.notes);
        const glm::vec3 intensity = own ? glm::vec3(static_cast<float>(luminance_of(strength))) : strength;
        if (intensity != strength) {
            scene_.notes.push_back(
                fmt::format("{}: coloured by its own spectrum, and as bright as its color says", light_field));
        }
        scene_.lamps.push_back(
            {name, glm::vec3(world_from_node[3]), intensity, static_cast<float>(light.range), std::move(own)});
    }

    glm::vec3 light_strength(const tinygltf::Light& light, const std::string& field) const {
        glm::vec3 strength(1.0f);
        if (!light.color.empty()) {
            document_.check_numbers(light.color, 3, field + ".color");
            strength = {light.color[0], light.color[1], light.color[2]};
        }
        strength *= static_cast<float>(light.intensity);
        for (int c = 0; c < 3; ++c) {
            if (!(strength[c] >= 0.0f) || !std::isfinite(strength[c])) {
                document_.fail(field + ".intensity", fmt::format("{}", light.intensity),
                               "times its colour it must be finite and not negative");
            }
        }
        return strength;
    }

    void finish() {
        scene_.images = std::move(materials_.images);
        scene_.materials = std::move(materials_.materials);
        scene_.notes.insert(scene_.notes.end(), materials_.notes.begin(), materials_.notes.end());
        if (!document_.model.animations.empty()) {
            scene_.notes.emplace_back("animations are not played");
        }
        if (document_.model.scenes.size() > 1) {
            scene_.notes.push_back(
                fmt::format("{} scenes, only the default one is shown", document_.model.scenes.size()));
        }
    }

    const GltfDocument& document_;
    GltfMaterials materials_;
    SceneDesc scene_;
    std::map<std::pair<std::size_t, bool>, std::vector<std::size_t>> meshes_; // by mesh in the file, and mirrored
};

} // namespace

SceneDesc load_gltf(const std::filesystem::path& file) {
    SceneDesc scene = load_gltf(read_file_bytes(file), file.string(), file.parent_path());
    scene.name = file.stem().string();
    return scene;
}

SceneDesc load_gltf(std::span<const std::uint8_t> bytes, const std::string& source,
                    const std::filesystem::path& folder) {
    const GltfDocument document = parse_gltf(bytes, source, folder);
    return SceneReader(document).read();
}

} // namespace content
