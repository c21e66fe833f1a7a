#include "content/generator/generate.h"
#include "content/generator/glb_writer.h"
#include "content/gltf.h"
#include "content/scenario.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

using content::Instance;
using content::Mesh;
using content::SceneDesc;
using content::generator::generate_model;
using content::generator::glb_bytes;
using content::generator::model_names;

namespace {

/// Painting takes a second, so that each model is made once for all tests.
const SceneDesc& model(const std::string& name) {
    static std::map<std::string, SceneDesc> made;
    const auto [entry, is_new] = made.try_emplace(name);
    if (is_new) {
        entry->second = generate_model(name);
    }
    return entry->second;
}

std::size_t triangle_count(const SceneDesc& scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        count += scene.meshes[instance.mesh].indices.size() / 3;
    }
    return count;
}

/// Triangles with the corners of an earlier one: they would flicker.
std::size_t doubled_triangles(const Mesh& mesh) {
    using Point = std::array<float, 3>;
    std::set<std::array<Point, 3>> seen;
    std::size_t doubled = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<Point, 3> corners;
        for (std::size_t j = 0; j < 3; ++j) {
            const glm::vec3 p = mesh.vertices[mesh.indices[i + j]].position;
            corners[j] = {p.x, p.y, p.z};
        }
        std::sort(corners.begin(), corners.end());
        doubled += seen.insert(corners).second ? 0 : 1;
    }
    return doubled;
}

} // namespace

TEST_CASE("a generated model's triangles are sound") {
    const std::string name = GENERATE(from_range(model_names()));
    INFO(name);
    const SceneDesc& scene = model(name);
    CHECK(triangle_count(scene) > 1000);
    CHECK(triangle_count(scene) < 100'000); // more would not be drawn fast enough without a GPU
    for (const Mesh& mesh : scene.meshes) {
        INFO(mesh.name);
        REQUIRE(mesh.material < scene.materials.size());
        REQUIRE(!mesh.indices.empty());
        REQUIRE(mesh.indices.size() % 3 == 0);
        REQUIRE(*std::max_element(mesh.indices.begin(), mesh.indices.end()) < mesh.vertices.size());
        std::size_t degenerate = 0;
        std::size_t turned_away = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const content::Vertex& a = mesh.vertices[mesh.indices[i]];
            const content::Vertex& b = mesh.vertices[mesh.indices[i + 1]];
            const content::Vertex& c = mesh.vertices[mesh.indices[i + 2]];
            const glm::vec3 area = glm::cross(b.position - a.position, c.position - a.position);
            // A square millimetre: nothing that is modelled is smaller.
            degenerate += glm::length(area) < 1e-6f ? 1 : 0;
            for (const content::Vertex& vertex : {a, b, c}) {
                turned_away += glm::dot(vertex.normal, area) <= 0.0f ? 1 : 0;
            }
        }
        CHECK(degenerate == 0);
        CHECK(turned_away == 0);
        CHECK(doubled_triangles(mesh) == 0);
        std::size_t not_unit = 0;
        std::size_t not_a_reflectance = 0;
        for (const content::Vertex& vertex : mesh.vertices) {
            // Five roundings of single precision in a normalisation.
            not_unit += std::abs(glm::length(vertex.normal) - 1.0f) < 5e-7f ? 0 : 1;
            const auto [low, high] = std::minmax({vertex.colour.r, vertex.colour.g, vertex.colour.b, vertex.colour.a});
            not_a_reflectance += low >= 0.0f && high <= 1.0f ? 0 : 1;
        }
        CHECK(not_unit == 0);
        CHECK(not_a_reflectance == 0);
    }
}

TEST_CASE("a generated model's parts have names of their own and lie where the model says") {
    const std::string name = GENERATE(from_range(model_names()));
    INFO(name);
    const SceneDesc& scene = model(name);
    std::set<std::string> names;
    glm::vec3 low(1e30f);
    glm::vec3 high(-1e30f);
    for (const Instance& instance : scene.instances) {
        INFO(instance.name);
        CHECK(names.insert(instance.name).second);
        REQUIRE(instance.mesh < scene.meshes.size());
        for (const content::Vertex& vertex : scene.meshes[instance.mesh].vertices) {
            const glm::vec3 position(instance.world_from_mesh * glm::vec4(vertex.position, 1.0f));
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
    }
    const glm::vec3 size = high - low;
    CHECK(std::min({size.x, size.y, size.z}) > 1.0f);
    CHECK(std::max({size.x, size.y, size.z}) < 1000.0f);
}

TEST_CASE("a generated model survives its file") {
    const std::string name = GENERATE(from_range(model_names()));
    INFO(name);
    const SceneDesc& made = model(name);
    const std::vector<std::uint8_t> bytes = glb_bytes(made);
    CHECK(bytes == glb_bytes(generate_model(name)));
    const SceneDesc read = content::load_gltf(bytes, name + ".glb", ".");
    CHECK(read.notes.empty());
    REQUIRE(read.instances.size() == made.instances.size());
    CHECK(triangle_count(read) == triangle_count(made));
    for (std::size_t i = 0; i < made.instances.size(); ++i) {
        CHECK(read.instances[i].name == made.instances[i].name);
        REQUIRE(read.instances[i].world_from_mesh == made.instances[i].world_from_mesh);
        const Mesh& a = made.meshes[made.instances[i].mesh];
        const Mesh& b = read.meshes[read.instances[i].mesh];
        REQUIRE(a.vertices.size() == b.vertices.size());
        REQUIRE(a.indices == b.indices);
        std::size_t changed = 0;
        for (std::size_t j = 0; j < a.vertices.size(); ++j) {
            const content::Vertex& before = a.vertices[j];
            const content::Vertex& after = b.vertices[j];
            changed += before.position == after.position && before.colour == after.colour &&
                               before.texture_coordinates == after.texture_coordinates
                           ? 0
                           : 1;
        }
        CHECK(changed == 0);
        const content::Material& of_made = made.materials[a.material];
        const content::Material& of_read = read.materials[b.material];
        CHECK(of_read.name == of_made.name);
        CHECK(of_read.base_colour == of_made.base_colour);
        CHECK(of_read.base_colour_image.has_value() == of_made.base_colour_image.has_value());
        if (of_made.base_colour_image) {
            CHECK(read.images[*of_read.base_colour_image].rgba == made.images[*of_made.base_colour_image].rgba);
        }
        CHECK(of_read.alpha_mode == of_made.alpha_mode);
        // The file keeps colour and strength apart: one rounding in the quotient, one in the product.
        CHECK(glm::length(of_read.emission - of_made.emission) <= 4e-7f * glm::length(of_made.emission));
    }
    REQUIRE(read.lamps.size() == made.lamps.size());
    for (std::size_t i = 0; i < made.lamps.size(); ++i) {
        CHECK(read.lamps[i].position == made.lamps[i].position);
        CHECK(glm::length(read.lamps[i].intensity - made.lamps[i].intensity) <=
              4e-7f * glm::length(made.lamps[i].intensity));
        CHECK(read.lamps[i].range == made.lamps[i].range);
    }
}

TEST_CASE("a model that is not generated is refused by name") {
    CHECK_THROWS_AS(generate_model("latice"), sim::BadInput);
}

TEST_CASE("every built-in scenario loads with its scene and its demonstration") {
    for (const content::Scenario& scenario : content::built_in_scenarios()) {
        INFO(scenario.name);
        CHECK(!scenario.title.empty());
        CHECK(!scenario.demonstration.empty());
        const SceneDesc scene = content::load_scene(scenario);
        CHECK((!scene.instances.empty() || scenario.stars));
    }
}
