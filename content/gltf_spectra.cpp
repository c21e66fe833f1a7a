#include "content/gltf_spectra.h"

#include "content/reflectance.h"
#include "content/spectrum_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace content {
namespace {

/// extras.rapidity, if there; its keys are of the types that gltf_structure.cpp asks for.
const tinygltf::Value* rapidity_of(const tinygltf::Value& extras) {
    return extras.IsObject() && extras.Has("rapidity") ? &extras.Get("rapidity") : nullptr;
}

std::optional<double> number(const GltfDocument& document, const tinygltf::Value& values, const std::string& key,
                             const std::string& field, double least, double most) {
    if (!values.Has(key)) {
        return std::nullopt;
    }
    const tinygltf::Value& value = values.Get(key);
    const double x = value.GetNumberAsDouble();
    if (!(x >= least && x <= most)) {
        document.fail(field + ".extras.rapidity." + key, fmt::format("{}", x),
                      std::isfinite(most) ? fmt::format("must be in {} to {}", least, most)
                                          : fmt::format("must be a number of at least {}", least));
    }
    return x;
}

std::optional<float> band(const GltfDocument& document, const tinygltf::Value& values, const std::string& key,
                          const std::string& field, double most) {
    const std::optional<double> x = number(document, values, key, field, 0.0, most);
    return x ? std::optional(static_cast<float>(*x)) : std::nullopt;
}

std::optional<Spectrum> spectrum(const GltfDocument& document, const tinygltf::Value& values, const std::string& key,
                                 const std::string& field, SpectrumUse use, std::vector<std::string>& notes) {
    if (!values.Has(key)) {
        return std::nullopt;
    }
    const tinygltf::Value& value = values.Get(key);
    const std::string name = field + ".extras.rapidity." + key;
    if (value.IsString()) {
        const auto& file = value.Get<std::string>();
        if (!std::filesystem::is_regular_file(document.folder / file)) {
            document.fail(name, file, "there is no such file");
        }
        return read_spectrum(document.folder / file, use, notes);
    }
    std::vector<std::pair<double, double>> samples;
    for (int i = 0; i < static_cast<int>(value.ArrayLen()); ++i) {
        const tinygltf::Value& pair = value.Get(i);
        samples.emplace_back(pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble());
    }
    return checked_spectrum(samples, use, document.source, name, notes);
}

void note_unknown_keys(const GltfDocument& document, const tinygltf::Value& values, const std::string& field,
                       const std::vector<std::string>& known, std::vector<std::string>& notes) {
    for (const std::string& key : values.Keys()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            notes.push_back(fmt::format("{}: {}.extras.rapidity.{} is not used; what is known there is {}",
                                        document.source, field, key, fmt::join(known, ", ")));
        }
    }
}

/// A spectrum or a temperature says all about the emission.
void refuse_two_emissions(const GltfDocument& document, const tinygltf::Value& values, const std::string& field,
                          const Material& material) {
    if (material.emission_spectrum && material.emission_temperature) {
        document.fail(field + ".extras.rapidity.emission_spectrum", "", "give either a spectrum or temperature_K");
    }
    for (const char* band : {"ultraviolet_emission", "infrared_emission"}) {
        if (values.Has(band) && (material.emission_spectrum || material.emission_temperature)) {
            document.fail(fmt::format("{}.extras.rapidity.{}", field, band),
                          fmt::format("{}", values.Get(band).GetNumberAsDouble()),
                          fmt::format("{} says already what is emitted there",
                                      material.emission_spectrum ? "emission_spectrum" : "temperature_K"));
        }
    }
}

/// Notes what is given and makes no difference, or another than one may think.
void note_idle_spectra(const GltfDocument& document, const tinygltf::Value& values, const std::string& field,
                       const Material& material, std::vector<std::string>& notes) {
    if ((material.emission_spectrum || material.emission_temperature) && material.emission == glm::vec3(0.0f)) {
        notes.push_back(fmt::format("{}: {} has the spectrum of an emission, but its emissiveFactor is 0: it is dark",
                                    document.source, field));
    }
    if (material.unlit && (material.reflectance_spectrum || values.Has("ultraviolet_reflectance") ||
                           values.Has("infrared_reflectance"))) {
        notes.push_back(fmt::format("{}: {} is unlit: its reflectance beyond RGB is not used", document.source, field));
    }
    const double brightness = luminance_of(glm::dvec3(material.base_colour));
    if (material.reflectance_spectrum && brightness < 1.0 - 1e-6) {
        notes.push_back(
            fmt::format("{}: {}: its reflectance spectrum is scaled by the luminance of its base colour, {:.3g}",
                        document.source, field, brightness));
    }
}

} // namespace

std::optional<double> temperature_of(const GltfDocument& document, const tinygltf::Value& extras,
                                     const std::string& field) {
    const tinygltf::Value* values = rapidity_of(extras);
    return values != nullptr ? number(document, *values, "temperature_K", field, 100.0, 1e9) : std::nullopt;
}

void read_material_spectra(const GltfDocument& document, const tinygltf::Value& extras, const std::string& field,
                           Material& material, std::vector<std::string>& notes) {
    const tinygltf::Value* values = rapidity_of(extras);
    if (values == nullptr) {
        return;
    }
    note_unknown_keys(document, *values, field,
                      {"temperature_K", "ultraviolet_reflectance", "infrared_reflectance", "ultraviolet_emission",
                       "infrared_emission", "vegetation", "reflectance_spectrum", "emission_spectrum"},
                      notes);
    constexpr double brightest = 1e6;
    material.invisible_reflectance = {band(document, *values, "ultraviolet_reflectance", field, 1.0),
                                      band(document, *values, "infrared_reflectance", field, 1.0)};
    material.invisible_emission = {band(document, *values, "ultraviolet_emission", field, brightest),
                                   band(document, *values, "infrared_emission", field, brightest)};
    material.reflectance_spectrum =
        spectrum(document, *values, "reflectance_spectrum", field, SpectrumUse::reflectance, notes);
    material.emission_spectrum = spectrum(document, *values, "emission_spectrum", field, SpectrumUse::light, notes);
    if (values->Has("vegetation")) {
        material.vegetation = values->Get("vegetation").Get<bool>();
    }
    refuse_two_emissions(document, *values, field, material);
    note_idle_spectra(document, *values, field, material, notes);
    const InvisibleBands& bands = material.invisible_reflectance;
    if (material.reflectance_spectrum && (bands.ultraviolet || bands.infrared)) {
        document.fail(field + ".extras.rapidity.reflectance_spectrum", "",
                      "give either a spectrum or reflectances of the invisible bands");
    }
}

std::optional<Spectrum> lamp_spectrum(const GltfDocument& document, const tinygltf::Value& extras,
                                      const std::string& field, std::vector<std::string>& notes) {
    const tinygltf::Value* values = rapidity_of(extras);
    if (values == nullptr) {
        return std::nullopt;
    }
    note_unknown_keys(document, *values, field, {"temperature_K", "spectrum"}, notes);
    std::optional<Spectrum> own = spectrum(document, *values, "spectrum", field, SpectrumUse::light, notes);
    if (const std::optional<double> kelvin = temperature_of(document, extras, field)) {
        if (own) {
            document.fail(field + ".extras.rapidity.spectrum", "", "give either a spectrum or temperature_K");
        }
        own = Spectrum(BlackBody{*kelvin});
    }
    return own;
}

} // namespace content
