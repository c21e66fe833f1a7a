#include "content/generator/generate.h"

#include "content/generator/models.h"
#include "sim/bad_input.h"

#include <array>
#include <functional>

namespace content::generator {
namespace {

struct Generator {
    const char* name;
    SceneDesc (*make)();
};

constexpr std::array generators = {
    Generator{"lattice", lattice},
    Generator{"corridor", corridor},
    Generator{"street", street},
    Generator{"square", square},
    Generator{"ship", ship},
};

} // namespace

std::vector<std::string> model_names() {
    std::vector<std::string> names;
    names.reserve(generators.size());
    for (const Generator& generator : generators) {
        names.emplace_back(generator.name);
    }
    return names;
}

SceneDesc generate_model(const std::string& name) {
    std::string known;
    for (const Generator& generator : generators) {
        if (name == generator.name) {
            SceneDesc scene = generator.make();
            scene.name = name;
            return scene;
        }
        known += std::string(known.empty() ? "" : ", ") + generator.name;
    }
    throw sim::BadInput("generated model", "", name, "there is none of that name; known: " + known);
}

} // namespace content::generator
