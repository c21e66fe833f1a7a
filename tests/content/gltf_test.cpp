#include "content/gltf.h"
#include "sim/bad_input.h"
#include "tests/content/gltf_samples.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinRel;
using samples::Bytes;
using samples::GltfSample;
using samples::load;
using samples::load_text;
using samples::triangle;
using samples::with_primitive;

namespace {

// Single precision: coordinates up to 10 with a rotation given to 11 digits.
constexpr float tolerance = 1e-5f;

} // namespace

TEST_CASE("a node hierarchy places its meshes in the world") {
    const auto scene = load(samples::square_glb());
    REQUIRE(scene.instances.size() == 1);
    CHECK(scene.instances[0].name == "square");
    const auto& mesh = scene.meshes.at(scene.instances[0].mesh);
    REQUIRE(mesh.vertices.size() == 4);
    CHECK(mesh.indices == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
    // Scaled by (2, 3, 4), turned a quarter about +y (x to -z), moved by 10 along x.
    const glm::vec3 corner(scene.instances[0].world_from_mesh * glm::vec4(mesh.vertices[2].position, 1.0f));
    CHECK(glm::distance(corner, glm::vec3(10.0f, 3.0f, -2.0f)) < tolerance);
    CHECK(mesh.vertices[3].normal == glm::vec3(0.0f, 0.0f, 1.0f));
    CHECK(mesh.vertices[2].texture_coordinates == glm::vec2(1.0f, 0.0f));
    CHECK(mesh.vertices[3].colour == glm::vec4(0.25f, 1.0f, 1.0f, 1.0f));
}

TEST_CASE("a material keeps its colours, textures, emission and alpha") {
    const auto scene = load(samples::square_glb());
    const auto& material = scene.materials.at(scene.meshes.at(0).material);
    CHECK(material.name == "paint");
    CHECK(material.base_colour == glm::vec4(0.5f, 0.25f, 1.0f, 1.0f));
    CHECK(material.emission == glm::vec3(4.0f, 2.0f, 0.0f));
    CHECK(material.emission_temperature == 3000.0f);
    CHECK(material.alpha_mode == content::AlphaMode::mask);
    CHECK(material.alpha_cutoff == 0.25f);
    CHECK(material.double_sided);
    CHECK_FALSE(material.unlit);
    REQUIRE(material.base_colour_image);
    const auto& image = scene.images.at(*material.base_colour_image);
    CHECK(image.name == "four");
    CHECK(image.width == 2);
    CHECK(image.height == 2);
    CHECK(image.rgba == Bytes{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 188, 188, 188, 0});
}

TEST_CASE("lights and cameras stand where their nodes put them") {
    const auto scene = load(samples::square_glb());
    REQUIRE(scene.lamps.size() == 1);
    CHECK(scene.lamps[0].position == glm::vec3(1.0f, 2.0f, 3.0f));
    CHECK(scene.lamps[0].intensity == glm::vec3(8.0f, 4.0f, 2.0f));
    CHECK(scene.lamps[0].range == 20.0f);
    REQUIRE(scene.sun);
    // A light shines along -z; a quarter turn about -x carries that to -y: the sun stands overhead.
    CHECK(glm::distance(scene.sun->direction, glm::vec3(0.0f, 1.0f, 0.0f)) < tolerance);
    CHECK(scene.sun->irradiance == glm::vec3(3.0f));
    REQUIRE(scene.start_views.size() == 1);
    CHECK(scene.start_views[0].position == glm::dvec3(5.0, 6.0, 7.0));
    CHECK(scene.start_views[0].look == glm::dvec3(-1.0, 0.0, 0.0));
    CHECK(scene.start_views[0].up == glm::dvec3(0.0, 1.0, 0.0));
    // 60 degrees high and 1.5 times as wide: 2 atan(1.5 tan 30 degrees). The file gives the angle to 11 digits.
    CHECK(std::abs(scene.start_views[0].horizontal_field_of_view - 2.0 * std::atan(1.5 / std::sqrt(3.0))) < 1e-9);
}

TEST_CASE("strips and fans become triangles that all face one way") {
    const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    GltfSample sample;
    const int positions = sample.floats(square, 3);
    const int around = sample.indices({0, 1, 3, 2});
    const int mode = GENERATE_COPY(5, 6);
    const std::string indices = mode == 6 ? fmt::format(R"(, "indices": {})", around) : "";
    const auto scene = load(with_primitive(
        sample, fmt::format(R"("mode": {}, "attributes": {{"POSITION": {}}}{})", mode, positions, indices)));
    const auto& mesh = scene.meshes.at(0);
    REQUIRE(mesh.indices.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(mesh.vertices[mesh.indices[i]].normal == glm::vec3(0.0f, 0.0f, 1.0f));
    }
}

TEST_CASE("missing normals are those of the flat triangles") {
    GltfSample sample;
    const int positions = sample.floats({0, 0, 0, 0, 0, -1, 0, 1, 0, -1, 0, 0}, 3);
    const int indices = sample.indices({0, 1, 2, 0, 2, 3});
    const auto scene = load(
        with_primitive(sample, fmt::format(R"("attributes": {{"POSITION": {}}}, "indices": {})", positions, indices)));
    const auto& mesh = scene.meshes.at(0);
    REQUIRE(mesh.vertices.size() == 6);
    CHECK(mesh.vertices[mesh.indices[0]].normal == glm::vec3(1.0f, 0.0f, 0.0f));
    CHECK(mesh.vertices[mesh.indices[3]].normal == glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST_CASE("attributes may be strided, normalised, or sparse") {
    GltfSample sample;
    // Position and colour of each vertex beside one another: 12 + 4 bytes.
    std::vector<std::uint8_t> interleaved(48, 0);
    std::memcpy(interleaved.data() + 16, std::array<float, 3>{1, 0, 0}.data(), 12);
    std::memcpy(interleaved.data() + 32, std::array<float, 3>{0, 1, 0}.data(), 12);
    interleaved[28] = 255;
    interleaved[31] = 51;
    const int view = sample.view(interleaved, 16);
    const int positions = sample.accessor(view, 5126, 3, "VEC3");
    const int colours = sample.accessor(view, 5121, 3, "VEC4", R"("byteOffset": 12, "normalized": true)");
    // Without a view all texture coordinates are zero; the sparse part replaces the third.
    const int where = sample.view(std::vector<std::uint16_t>{2});
    const int what = sample.view(std::vector<std::uint16_t>{65535, 13107});
    const int coordinates = sample.accessor(
        -1, 5123, 3, "VEC2",
        fmt::format(
            R"("normalized": true, "sparse": {{"count": 1, "indices": {{"bufferView": {}, "componentType": 5123}},
                       "values": {{"bufferView": {}}}}})",
            where, what));
    const auto scene =
        load(with_primitive(sample, fmt::format(R"("attributes": {{"POSITION": {}, "COLOR_0": {}, "TEXCOORD_0": {}}})",
                                                positions, colours, coordinates)));
    const auto& vertices = scene.meshes.at(0).vertices;
    REQUIRE(vertices.size() == 3);
    CHECK(vertices[1].position == glm::vec3(1.0f, 0.0f, 0.0f));
    CHECK(vertices[1].colour == glm::vec4(1.0f, 0.0f, 0.0f, 0.2f));
    CHECK(vertices[1].texture_coordinates == glm::vec2(0.0f));
    CHECK(vertices[2].texture_coordinates == glm::vec2(1.0f, 0.2f));
}

TEST_CASE("indices of 8 and 32 bits") {
    GltfSample sample;
    const int positions = sample.floats(triangle, 3);
    const int bytes = sample.accessor(sample.view(std::vector<std::uint8_t>{2, 0, 1}), 5121, 3, "SCALAR");
    const int words = sample.accessor(sample.view(std::vector<std::uint32_t>{2, 0, 1}), 5125, 3, "SCALAR");
    const int normals = sample.floats({1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
    const int indices = GENERATE_COPY(bytes, words);
    const auto scene =
        load(with_primitive(sample, fmt::format(R"("attributes": {{"POSITION": {}, "NORMAL": {}}}, "indices": {})",
                                                positions, normals, indices)));
    CHECK(scene.meshes.at(0).indices == std::vector<std::uint32_t>{2, 0, 1});
}

TEST_CASE("a mirrored node keeps its triangles counter-clockwise in the world") {
    GltfSample sample;
    const int positions = sample.floats(triangle, 3);
    const auto scene = load(sample.glb(fmt::format(
        R"("nodes": [{{"mesh": 0}}, {{"mesh": 0, "scale": [-1, 1, 1]}}],
           "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}}}]}}])",
        positions)));
    REQUIRE(scene.instances.size() == 2);
    for (const auto& instance : scene.instances) {
        const auto& mesh = scene.meshes.at(instance.mesh);
        const auto corner = [&](std::size_t i) {
            return glm::vec3(instance.world_from_mesh * glm::vec4(mesh.vertices[mesh.indices[i]].position, 1.0f));
        };
        CHECK(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).z > 0.0f);
    }
}

TEST_CASE("texture coordinates follow KHR_texture_transform") {
    GltfSample sample;
    const int positions = sample.floats(triangle, 3);
    const int coordinates = sample.floats({0, 0, 1, 0, 0, 1}, 2);
    const auto scene = load(sample.glb(fmt::format(
        R"("nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{{"material": 0,
               "attributes": {{"POSITION": {}, "TEXCOORD_1": {}}}}}]}}],
           "materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0, "extensions": {{
               "KHR_texture_transform": {{"offset": [0.5, 0], "rotation": 1.5707963267948966, "scale": [2, 3],
                                          "texCoord": 1}}}}}}}}}}],
           "textures": [{{"source": 0}}], "images": [{{"uri": "{}"}}],
           "extensionsRequired": ["KHR_texture_transform"])",
        positions, coordinates, samples::png_data_uri)));
    const auto& vertices = scene.meshes.at(0).vertices;
    // A quarter turn counter-clockwise as seen with v downwards carries +u to -v and +v to +u.
    CHECK(glm::distance(vertices[1].texture_coordinates, glm::vec2(0.5f, -2.0f)) < tolerance);
    CHECK(glm::distance(vertices[2].texture_coordinates, glm::vec2(3.5f, 0.0f)) < tolerance);
}

TEST_CASE("what is not shown is named") {
    GltfSample sample;
    const int positions = sample.floats(triangle, 3);
    const auto scene = load(sample.glb(fmt::format(
        R"("nodes": [{{"mesh": 0, "extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}}],
           "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {0}}}, "material": 0}},
                                       {{"attributes": {{"POSITION": {0}}}, "mode": 1}}]}}],
           "materials": [{{"name": "glass", "alphaMode": "BLEND"}}],
           "extensions": {{"KHR_lights_punctual": {{"lights": [{{"type": "spot", "spot": {{}}}}]}}}})",
        positions)));
    const std::string notes = fmt::format("{}", fmt::join(scene.notes, "\n"));
    CHECK_THAT(notes, ContainsSubstring("meshes[0].primitives[1] has no triangles"));
    CHECK_THAT(notes, ContainsSubstring("\"glass\": blending is shown as a mask"));
    CHECK_THAT(notes, ContainsSubstring("the spot light shines in all directions"));
    CHECK(scene.lamps.size() == 1);
}

TEST_CASE("a .gltf finds its buffers and images beside it") {
    const auto folder = std::filesystem::temp_directory_path() / "rapidity gltf test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "points.bin", std::ios::binary)
        .write(reinterpret_cast<const char*>(triangle.data()), 9 * sizeof(float));
    std::ofstream(folder / "my picture.png", std::ios::binary)
        .write(reinterpret_cast<const char*>(samples::png.data()), samples::png.size());
    std::ofstream(folder / "scene.gltf") << R"({"asset": {"version": "2.0"},
        "buffers": [{"uri": "points.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": "my%20picture.png"}]})";
    const auto scene = content::load_gltf(folder / "scene.gltf");
    CHECK(scene.name == "scene");
    CHECK(scene.meshes.at(0).vertices.at(1).position == glm::vec3(1.0f, 0.0f, 0.0f));
    CHECK(scene.images.at(0).width == 2);

    std::filesystem::remove(folder / "my picture.png");
    CHECK_THROWS_MATCHES(content::load_gltf(folder / "scene.gltf"), sim::BadInput,
                         MessageMatches(ContainsSubstring("images[0].uri = my%20picture.png")));
    std::filesystem::resize_file(folder / "points.bin", 35);
    CHECK_THROWS_MATCHES(content::load_gltf(folder / "scene.gltf"), sim::BadInput,
                         MessageMatches(ContainsSubstring("buffers[0].byteLength = 36: points.bin has 35 bytes")));
    std::filesystem::remove(folder / "points.bin");
    CHECK_THROWS_MATCHES(content::load_gltf(folder / "scene.gltf"), sim::BadInput,
                         MessageMatches(ContainsSubstring("buffers[0].uri = points.bin: the file cannot be read")));
    std::filesystem::remove_all(folder);
    CHECK_THROWS_MATCHES(content::load_gltf(folder / "scene.gltf"), sim::BadInput,
                         MessageMatches(ContainsSubstring("there is no such file")));
}

TEST_CASE("materials and lamps bring spectra of their own") {
    const auto scene = load(samples::with_bytes().glb(
        R"("materials": [{"extras": {"rapidity": {"vegetation": true, "infrared_reflectance": 0.75,
              "emission_spectrum": [[500, 1], [600, 3]]}}},
            {"extras": {"rapidity": {"reflectance_spectrum": [[400, 0.25], [700, 1]], "ultraviolet_emission": 2}}}],
        "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}},
                  {"extensions": {"KHR_lights_punctual": {"light": 1}}}],
        "extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "point", "extras": {"rapidity": {"temperature_K": 2700}}},
            {"type": "point", "extras": {"rapidity": {"spectrum": [[588, 0], [589, 1], [590, 0]]}}}]}})"));
    const content::Material& leaf = scene.materials.at(0);
    CHECK(leaf.vegetation);
    CHECK(leaf.invisible_reflectance.infrared == 0.75f);
    CHECK_FALSE(leaf.invisible_reflectance.ultraviolet);
    CHECK(scene.materials.at(1).invisible_emission.ultraviolet == 2.0f);
    REQUIRE(leaf.emission_spectrum);
    CHECK_THAT(leaf.emission_spectrum->at(550.0), WithinRel(2.0 / 3.0, 1e-15)); // of the largest value
    REQUIRE(scene.materials.at(1).reflectance_spectrum);
    CHECK(scene.materials.at(1).reflectance_spectrum->at(1000.0) == 1.0);
    REQUIRE(scene.lamps.size() == 2);
    CHECK(scene.lamps[0].spectrum->black_body_kelvin() == 2700.0);
    CHECK(scene.lamps[1].spectrum->at(589.0) == 1.0);
}
