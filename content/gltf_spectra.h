#pragma once

#include "content/gltf_document.h"
#include "content/scene_desc.h"

#include <optional>
#include <string>
#include <vector>

/// Spectra in a glTF file: members of extras.rapidity of materials and of lights. A spectrum is a list of [nm, value]
/// or the name of a CSV file (wavelength_nm, value) beside the model. Throws sim::BadInput naming the field.
namespace content {

/// Temperature `temperature_K`, 100 K to 1e9 K, for a light or an emission.
std::optional<double> temperature_of(const GltfDocument& document, const tinygltf::Value& extras,
                                     const std::string& field);

/// Reads ultraviolet_reflectance, infrared_reflectance, ultraviolet_emission, infrared_emission, reflectance_spectrum,
/// emission_spectrum and vegetation into `material`.
void read_material_spectra(const GltfDocument& document, const tinygltf::Value& extras, const std::string& field,
                           Material& material, std::vector<std::string>& notes);

/// A lamp's own light: temperature_K or spectrum.
std::optional<Spectrum> lamp_spectrum(const GltfDocument& document, const tinygltf::Value& extras,
                                      const std::string& field, std::vector<std::string>& notes);

} // namespace content
