#pragma once

#include "content/scene_desc.h"

#include <filesystem>
#include <string_view>

namespace content {

/// How a scenario names a model that the program makes itself: generated:NAME.
inline constexpr std::string_view generated_prefix = "generated:";

inline bool is_generated_model(std::string_view name) {
    return name.starts_with(generated_prefix);
}

/// The scene of a scenario's model: made when it is generated:NAME, read from the glTF file otherwise. Throws
/// sim::BadInput.
SceneDesc load_model(const std::filesystem::path& model);

} // namespace content
