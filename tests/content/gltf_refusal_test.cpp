#include "sim/bad_input.h"
#include "tests/content/gltf_samples.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using namespace samples;

namespace {

void check_refused(const Bytes& bytes, const std::string& field, const std::string& reason) {
    CHECK_THROWS_MATCHES(load(bytes), sim::BadInput,
                         MessageMatches(ContainsSubstring("sample.glb: " + field) && ContainsSubstring(reason)));
}

} // namespace

TEST_CASE("broken containers are refused") {
    Bytes bytes = samples::square_glb();
    bytes.resize(bytes.size() - 1);
    check_refused(bytes, "header.length", "truncated");
    bytes.resize(15);
    check_refused(bytes, "header", "truncated");
    bytes = samples::square_glb();
    bytes[4] = 1;
    check_refused(bytes, "header.version = 1", "only glTF 2");
    CHECK_THROWS_MATCHES(load_text(R"({"asset": {"version": "2.0")"), sim::BadInput,
                         MessageMatches(ContainsSubstring("of the JSON: the JSON is broken here")));
    CHECK_THROWS_MATCHES(load_text(std::string(100000, '[')), sim::BadInput,
                         MessageMatches(ContainsSubstring("nested more than 64 deep")));
    CHECK_THROWS_MATCHES(load_text(R"({"asset": {"version": "1.0"}})"), sim::BadInput,
                         MessageMatches(ContainsSubstring("asset.version = 1.0")));
    CHECK_THROWS_MATCHES(load_text(R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco"]})"),
                         sim::BadInput, MessageMatches(ContainsSubstring("extensionsRequired[0] = KHR_draco")));
    CHECK_THROWS_MATCHES(load_text(R"({"asset": {"version": "2.0"}, "nodes": [{"scale": [1, "2", 3]}]})"),
                         sim::BadInput, MessageMatches(ContainsSubstring("nodes[0].scale[1] = \"2\"")));
    CHECK_THROWS_MATCHES(load_text(R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": -2}]})"), sim::BadInput,
                         MessageMatches(ContainsSubstring("nodes[0].mesh = -2")));
}

TEST_CASE("node trees that are no trees are refused") {
    const auto with_nodes = [](const std::string& nodes) {
        return fmt::format(R"({{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}], "nodes": [{}]}})", nodes);
    };
    CHECK_THROWS_MATCHES(load_text(with_nodes(R"({"children": [1]}, {"children": [0]})")), sim::BadInput,
                         MessageMatches(ContainsSubstring("nodes[0]") && ContainsSubstring("its own ancestor")));
    CHECK_THROWS_MATCHES(load_text(with_nodes(R"({"children": [7]})")), sim::BadInput,
                         MessageMatches(ContainsSubstring("nodes[7]")));
    CHECK_THROWS_MATCHES(load_text(with_nodes(R"({"rotation": [0, 0, 0, 0]})")), sim::BadInput,
                         MessageMatches(ContainsSubstring("nodes[0].rotation")));
    CHECK_THROWS_MATCHES(load_text(with_nodes(R"({"matrix": [1, 2, 3]})")), sim::BadInput,
                         MessageMatches(ContainsSubstring("nodes[0].matrix = 3 numbers: must be 16")));
    CHECK_THROWS_MATCHES(load_text(with_nodes(R"({"translation": [1e39, 0, 0]})")), sim::BadInput,
                         MessageMatches(ContainsSubstring("nodes[0].translation[0] = 1e+39")));
}

TEST_CASE("numbers and indices that cannot be are refused with their place") {
    const std::string primitive = "meshes[0].primitives[0]";
    SECTION("NaN in a position") {
        GltfSample sample;
        const int positions = sample.floats({0, 0, 0, 1, NAN, 0, 0, 1, 0}, 3);
        check_refused(with_primitive(sample, fmt::format(R"("attributes": {{"POSITION": {}}})", positions)),
                      primitive + ".attributes.POSITION[1] = nan", "not a finite number");
    }
    SECTION("an index beyond the vertices") {
        GltfSample sample;
        const int positions = sample.floats(triangle, 3);
        const int indices = sample.indices({0, 1, 3});
        check_refused(with_primitive(sample, fmt::format(R"("attributes": {{"POSITION": {}}}, "indices": {})",
                                                         positions, indices)),
                      primitive + ".indices[2] = 3", "there are 3 vertices");
    }
    SECTION("an accessor beyond its view") {
        GltfSample sample;
        const int view = sample.view(triangle);
        const int positions = sample.accessor(view, 5126, 4, "VEC3");
        check_refused(with_primitive(sample, fmt::format(R"("attributes": {{"POSITION": {}}})", positions)),
                      "accessors[0].count = 4", "room for 3");
    }
    SECTION("an accessor that is not there") {
        GltfSample sample;
        sample.floats(triangle, 3);
        check_refused(with_primitive(sample, R"("attributes": {"POSITION": 9})"),
                      primitive + ".attributes.POSITION = 9", "there are 1");
    }
    SECTION("attributes of unequal length") {
        GltfSample sample;
        const int positions = sample.floats(triangle, 3);
        const int normals = sample.floats({0, 0, 1}, 3);
        check_refused(with_primitive(
                          sample, fmt::format(R"("attributes": {{"POSITION": {}, "NORMAL": {}}})", positions, normals)),
                      primitive + ".attributes.NORMAL = 1 elements", "POSITION has 3");
    }
    SECTION("a material that is not there") {
        GltfSample sample;
        const int positions = sample.floats(triangle, 3);
        check_refused(
            with_primitive(sample, fmt::format(R"("material": 0, "attributes": {{"POSITION": {}}})", positions)),
            primitive + ".material = 0", "there are 0");
    }
}

TEST_CASE("a damaged file is loaded or refused, never more") {
    // Every byte position and length in turn with fixed steps, so that each run tries the same 900 files.
    const Bytes whole = samples::square_glb();
    std::size_t loaded = 0;
    std::size_t refused = 0;
    const auto attempt = [&](const Bytes& bytes) {
        try {
            const auto scene = load(bytes);
            ++loaded;
            for (const auto& mesh : scene.meshes) {
                for (const auto index : mesh.indices) {
                    REQUIRE(index < mesh.vertices.size());
                }
            }
        } catch (const sim::BadInput&) {
            ++refused;
        }
    };
    for (std::size_t i = 0; i < 300; ++i) {
        Bytes cut = whole;
        cut.resize(i * whole.size() / 300);
        // With the length that the header must have then, so that what follows the header is reached.
        if (i % 2 == 1 && cut.size() >= 12) {
            const auto length = static_cast<std::uint32_t>(cut.size());
            std::memcpy(cut.data() + 8, &length, 4);
        }
        attempt(cut);
    }
    CHECK(loaded == 0);
    std::uint32_t random = 12345;
    for (int i = 0; i < 600; ++i) {
        random = random * 1664525U + 1013904223U;
        Bytes flipped = whole;
        flipped[(random >> 8U) % flipped.size()] ^= static_cast<std::uint8_t>(1U << (random >> 29U));
        attempt(flipped);
    }
    CHECK(loaded + refused == 900);
    CHECK(loaded > 0);
}

TEST_CASE("spectra that make no sense are refused by field and value") {
    const auto refused = [](const std::string& extras) {
        try {
            load(with_bytes().glb(R"("materials": [{"extras": {"rapidity": {)" + extras + "}}}]"));
        } catch (const sim::BadInput& error) {
            return std::string(error.what());
        }
        return std::string("nothing was refused");
    };
    CHECK_THAT(refused(R"("temperature_K": 0)"), ContainsSubstring("materials[0].extras.rapidity.temperature_K = 0"));
    CHECK_THAT(refused(R"("infrared_reflectance": 1.5)"), ContainsSubstring("infrared_reflectance = 1.5"));
    CHECK_THAT(refused(R"("temperature_K": -5)"), ContainsSubstring("temperature_K = -5"));
    CHECK_THAT(refused(R"("temperature_K": 1e30)"), ContainsSubstring("temperature_K = 1e+30"));
    CHECK_THAT(refused(R"("temperature_K": NaN)"), ContainsSubstring("of the JSON = NaN: the JSON is broken here"));
    CHECK_THAT(refused(R"("ultraviolet_reflectance": -0.5)"), ContainsSubstring("ultraviolet_reflectance = -0.5"));
    CHECK_THAT(refused(R"("reflectance_spectrum": [[400, 2]])"),
               ContainsSubstring("reflectance_spectrum[0][1] = 2: a reflectance must not be above 1"));
    CHECK_THAT(refused(R"("reflectance_spectrum": [[400, 1], [300, 1]])"),
               ContainsSubstring("reflectance_spectrum[1][0] = 300: wavelengths must rise"));
    CHECK_THAT(refused(R"("reflectance_spectrum": "missing.csv")"),
               ContainsSubstring("materials[0].extras.rapidity.reflectance_spectrum = missing.csv: there is no such"));
    CHECK_THAT(refused(R"("temperature_K": 3000, "infrared_emission": 0.5)"),
               ContainsSubstring("infrared_emission = 0.5: temperature_K says already"));
    CHECK_THAT(refused(R"("emission_spectrum": [[400, 1], [700, 1]], "ultraviolet_emission": 0.5)"),
               ContainsSubstring("ultraviolet_emission = 0.5: emission_spectrum says already"));
    CHECK_THAT(refused(R"("emission_spectrum": [[400, 1], [700, 1]], "temperature_K": 3000)"),
               ContainsSubstring("give either a spectrum or temperature_K"));
    CHECK_THAT(refused(R"("reflectance_spectrum": 7)"), ContainsSubstring("must be a list"));
    CHECK_THAT(refused(R"("reflectance_spectrum": [])"),
               ContainsSubstring("reflectance_spectrum = []: must be a list"));
    CHECK_THAT(refused(R"("emission_spectrum": [[500, 1], []])"),
               ContainsSubstring("emission_spectrum[1] = []: must be two numbers"));
    CHECK_THAT(refused(R"("infrared_reflectance": [])"), ContainsSubstring("infrared_reflectance = []"));
    CHECK_THAT(refused(R"("vegetation": {})"), ContainsSubstring("vegetation = {}"));
}

TEST_CASE("colours of too few numbers and reflectances above 1 are refused") {
    const auto refused = [](const std::string& material) {
        try {
            load(with_bytes().glb(R"("materials": [{)" + material + "}]"));
        } catch (const sim::BadInput& error) {
            return std::string(error.what());
        }
        return std::string("nothing was refused");
    };
    CHECK_THAT(refused(R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 1.5, 0.5, 1]})"),
               ContainsSubstring("materials[0].pbrMetallicRoughness.baseColorFactor[1] = 1.5: must be in 0 to 1"));
    CHECK_THAT(refused(R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 1]})"),
               ContainsSubstring("baseColorFactor = [0.5,0.5,1]: must be 4 numbers"));
    CHECK_THAT(refused(R"("emissiveFactor": [1, 1])"), ContainsSubstring("emissiveFactor = [1,1]: must be 3 numbers"));
}

TEST_CASE("what a lamp's spectrum may not be is refused by field and value") {
    const auto refused = [](const std::string& extras) {
        try {
            load(with_bytes().glb(
                R"("extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [)"
                R"({"type": "point", "extras": {"rapidity": {)" +
                extras +
                R"(}}}]}}, "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}}],)"
                R"( "scenes": [{"nodes": [0]}])"));
        } catch (const sim::BadInput& error) {
            return std::string(error.what());
        }
        return std::string("nothing was refused");
    };
    const std::string field = "extensions.KHR_lights_punctual.lights[0].extras.rapidity.";
    CHECK_THAT(refused(R"("temperature_K": 0)"), ContainsSubstring(field + "temperature_K = 0: must be in 100"));
    CHECK_THAT(refused(R"("spectrum": [[550, 1]])"), ContainsSubstring(field + "spectrum[0][0] = 550: a light of a"));
    CHECK_THAT(refused(R"("spectrum": [[400, 1], [700, 1]], "temperature_K": 3000)"),
               ContainsSubstring(field + "spectrum: give either a spectrum or temperature_K"));
}

TEST_CASE("spectra that a file names but that change nothing are noted") {
    const auto notes = [](const std::string& extras) {
        const auto scene = load(with_bytes().glb(R"("materials": [{"extras": {"rapidity": {)" + extras + "}}}]"));
        return scene.notes.empty() ? std::string("no note") : scene.notes.front();
    };
    CHECK_THAT(notes(R"("vegetaton": true)"),
               ContainsSubstring("materials[0].extras.rapidity.vegetaton is not used; what is known there is ") &&
                   ContainsSubstring("vegetation"));
    CHECK_THAT(notes(R"("temperature_K": 3000)"), ContainsSubstring("its emissiveFactor is 0: it is dark"));
    CHECK(notes(R"("vegetation": true)") == "no note");
}

TEST_CASE("spectra that are scaled or not used are noted") {
    const auto notes = [](const std::string& json) {
        const auto scene = load(with_bytes().glb(json));
        return scene.notes.empty() ? std::string("no note") : scene.notes.back();
    };
    const std::string spectrum =
        R"("extras": {"rapidity": {"reflectance_spectrum": [[370, 0.5], [410, 0.5], [450, 0.5],)"
        R"([500, 0.5], [550, 0.5], [600, 0.5], [650, 0.5], [700, 0.5], [740, 0.5]]}})";
    CHECK(notes(R"("materials": [{)" + spectrum + "}]") == "no note");
    CHECK_THAT(
        notes(R"("materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1]}, )" + spectrum + "}]"),
        ContainsSubstring("materials[0]: its reflectance spectrum is scaled by the luminance of its base colour, 0.5"));
    CHECK_THAT(notes(R"("materials": [{"extensions": {"KHR_materials_unlit": {}}, )" + spectrum + "}]"),
               ContainsSubstring("materials[0] is unlit: its reflectance beyond RGB is not used"));
    CHECK_THAT(notes(R"("extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [)"
                     R"({"type": "directional", "extras": {"rapidity": {"temperature_K": 3000}}}]}}, )"
                     R"("nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}}], "scenes": [{"nodes": [0]}])"),
               ContainsSubstring("lights[0]: a sun has no spectrum of its own"));
}
