#include "content/model_name.h"

#include "content/generator/generate.h"
#include "content/gltf.h"

namespace content {

SceneDesc load_model(const std::filesystem::path& model) {
    const std::string name = model.string();
    if (is_generated_model(name)) {
        return generator::generate_model(name.substr(generated_prefix.size()));
    }
    return load_gltf(model);
}

} // namespace content
