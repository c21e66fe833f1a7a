#include "content/gltf_material.h"

#include "content/gltf_spectra.h"
#include "content/image_file.h"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace content {
namespace {

/// Reads one file's materials; keeps which images have been decoded already.
class MaterialReader {
  public:
    explicit MaterialReader(const GltfDocument& document) : document_(document) {}

    GltfMaterials read() {
        for (std::size_t i = 0; i < document_.model.materials.size(); ++i) {
            read_material(document_.model.materials[i], fmt::format("materials[{}]", i));
        }
        Material without;
        without.name = "default";
        result_.materials.push_back(without);
        result_.mappings.emplace_back();
        return std::move(result_);
    }

  private:
    void read_material(const tinygltf::Material& source, const std::string& field) {
        const auto& pbr = source.pbrMetallicRoughness;
        Material material;
        material.name = source.name.empty() ? field : source.name;
        const std::string colour_field = field + ".pbrMetallicRoughness.baseColorFactor";
        document_.check_numbers(pbr.baseColorFactor, 4, colour_field);
        for (int c = 0; c < 4; ++c) {
            material.base_colour[c] =
                fraction(pbr.baseColorFactor[static_cast<std::size_t>(c)], fmt::format("{}[{}]", colour_field, c));
        }
        material.base_colour_image =
            image_of(pbr.baseColorTexture.index, field + ".pbrMetallicRoughness.baseColorTexture");
        material.emission_image = image_of(source.emissiveTexture.index, field + ".emissiveTexture");
        material.emission = emission(source, field);
        if (const std::optional<double> kelvin = temperature_of(document_, source.extras, field)) {
            material.emission_temperature = static_cast<float>(*kelvin);
        }
        read_alpha(source, field, material);
        material.unlit = source.extensions.count("KHR_materials_unlit") != 0;
        read_material_spectra(document_, source.extras, field, material, result_.notes);
        material.double_sided = source.doubleSided;
        result_.materials.push_back(material);
        result_.mappings.push_back(mapping(source, material, field));
        if (source.normalTexture.index >= 0) {
            result_.notes.push_back(fmt::format("material \"{}\": its normal map is not shown", material.name));
        }
    }

    float fraction(double value, const std::string& field) const {
        if (!(value >= 0.0 && value <= 1.0)) {
            document_.fail(field, fmt::format("{}", value), "must be in 0 to 1");
        }
        return static_cast<float>(value);
    }

    glm::vec3 emission(const tinygltf::Material& source, const std::string& field) const {
        if (source.emissiveFactor.empty()) {
            return glm::vec3(0.0f);
        }
        document_.check_numbers(source.emissiveFactor, 3, field + ".emissiveFactor");
        double strength = 1.0;
        const auto extension = source.extensions.find("KHR_materials_emissive_strength");
        if (extension != source.extensions.end() && extension->second.Has("emissiveStrength")) {
            strength = extension->second.Get("emissiveStrength").GetNumberAsDouble();
        }
        glm::vec3 radiance(0.0f);
        for (int c = 0; c < 3; ++c) {
            const double component = source.emissiveFactor[static_cast<std::size_t>(c)] * strength;
            if (!(component >= 0.0) || !std::isfinite(static_cast<float>(component))) {
                document_.fail(fmt::format("{}.emissiveFactor[{}]", field, c), fmt::format("{}", component),
                               "with its strength it must be finite and not negative");
            }
            radiance[c] = static_cast<float>(component);
        }
        return radiance;
    }

    void read_alpha(const tinygltf::Material& source, const std::string& field, Material& material) {
        if (source.alphaMode == "MASK" || source.alphaMode == "BLEND") {
            material.alpha_mode = AlphaMode::mask;
        } else if (source.alphaMode != "OPAQUE") {
            document_.fail(field + ".alphaMode", source.alphaMode, "must be OPAQUE, MASK or BLEND");
        }
        if (source.alphaMode == "BLEND") {
            result_.notes.push_back(
                fmt::format("material \"{}\": blending is shown as a mask at alpha 0.5", material.name));
        } else {
            material.alpha_cutoff = fraction(source.alphaCutoff, field + ".alphaCutoff");
        }
    }

    std::optional<std::size_t> image_of(int texture_index, const std::string& field) {
        if (texture_index < 0) {
            return std::nullopt;
        }
        const auto& model = document_.model;
        const std::size_t index = document_.checked_index(texture_index, model.textures.size(), field + ".index");
        const tinygltf::Texture& texture = model.textures[index];
        if (texture.source < 0) {
            result_.notes.push_back(fmt::format("textures[{}] has no PNG or JPEG and is not shown", index));
            return std::nullopt;
        }
        note_sampler(texture, index);
        const auto source =
            document_.checked_index(texture.source, model.images.size(), fmt::format("textures[{}].source", index));
        const auto known = decoded_.find(source);
        if (known != decoded_.end()) {
            return known->second;
        }
        const tinygltf::Image& image = model.images[source];
        const std::string image_field = fmt::format("images[{}]", source);
        const auto bytes = image.bufferView >= 0 ? document_.view_bytes(image.bufferView, image_field + ".bufferView")
                                                 : std::span<const std::uint8_t>(image.image);
        const std::string shown = image.uri.empty() ? image_field : fmt::format("{}.uri = {}", image_field, image.uri);
        result_.images.push_back(decode_image(bytes, document_.source, shown));
        result_.images.back().name = image.name.empty() ? image_field : image.name;
        decoded_[source] = result_.images.size() - 1;
        return result_.images.size() - 1;
    }

    void note_sampler(const tinygltf::Texture& texture, std::size_t index) {
        if (texture.sampler < 0) {
            return;
        }
        const auto& samplers = document_.model.samplers;
        const tinygltf::Sampler& sampler = samplers[document_.checked_index(
            texture.sampler, samplers.size(), fmt::format("textures[{}].sampler", index))];
        if (sampler.wrapS != TINYGLTF_TEXTURE_WRAP_REPEAT || sampler.wrapT != TINYGLTF_TEXTURE_WRAP_REPEAT) {
            result_.notes.push_back(fmt::format("textures[{}]: clamping and mirroring are shown as repeating", index));
        }
    }

    TextureMapping mapping(const tinygltf::Material& source, const Material& material, const std::string& field) {
        const auto& base = source.pbrMetallicRoughness.baseColorTexture;
        const auto& emissive = source.emissiveTexture;
        const TextureMapping of_base = mapping_of(base, field + ".pbrMetallicRoughness.baseColorTexture");
        const TextureMapping of_emission = mapping_of(emissive, field + ".emissiveTexture");
        if (material.base_colour_image && material.emission_image &&
            (of_base.coordinate_set != of_emission.coordinate_set || of_base.transform != of_emission.transform)) {
            result_.notes.push_back(
                fmt::format("material \"{}\": its emission texture is placed as its base colour's", material.name));
        }
        return material.base_colour_image ? of_base : of_emission;
    }

    // KHR_texture_transform: scale first, then turn, then shift.
    TextureMapping mapping_of(const tinygltf::TextureInfo& texture, const std::string& field) const {
        TextureMapping result;
        result.coordinate_set = texture.texCoord;
        const auto extension = texture.extensions.find("KHR_texture_transform");
        if (extension == texture.extensions.end()) {
            return result;
        }
        const tinygltf::Value& values = extension->second;
        const std::string name = field + ".extensions.KHR_texture_transform";
        const glm::vec2 offset = pair(values, "offset", glm::vec2(0.0f), name);
        const glm::vec2 scale = pair(values, "scale", glm::vec2(1.0f), name);
        const auto angle = static_cast<float>(number(values, "rotation", 0.0, name));
        const float c = std::cos(angle);
        const float s = std::sin(angle);
        result.transform =
            glm::mat3(c * scale.x, -s * scale.x, 0.0f, s * scale.y, c * scale.y, 0.0f, offset.x, offset.y, 1.0f);
        if (values.Has("texCoord")) {
            result.coordinate_set = static_cast<int>(number(values, "texCoord", 0.0, name));
        }
        return result;
    }

    double number(const tinygltf::Value& values, const std::string& key, double otherwise,
                  const std::string& field) const {
        if (!values.Has(key)) {
            return otherwise;
        }
        return finite(values.Get(key), field + "." + key);
    }

    glm::vec2 pair(const tinygltf::Value& values, const std::string& key, const glm::vec2& otherwise,
                   const std::string& field) const {
        if (!values.Has(key)) {
            return otherwise;
        }
        const tinygltf::Value& value = values.Get(key);
        if (!value.IsArray() || value.ArrayLen() != 2) {
            document_.fail(field + "." + key, "", "must be two numbers");
        }
        return {finite(value.Get(0), field + "." + key), finite(value.Get(1), field + "." + key)};
    }

    double finite(const tinygltf::Value& value, const std::string& field) const {
        constexpr double largest = 1e6;
        if (!value.IsNumber() || !(std::abs(value.GetNumberAsDouble()) <= largest)) {
            document_.fail(field, "", fmt::format("must be a number in -{0} to {0}", largest));
        }
        return value.GetNumberAsDouble();
    }

    const GltfDocument& document_;
    GltfMaterials result_;
    std::map<std::size_t, std::size_t> decoded_; // index into the scene's images by index into the file's
};

} // namespace

GltfMaterials read_materials(const GltfDocument& document) {
    return MaterialReader(document).read();
}

} // namespace content
