#include "engine/fly/loaded_scene.h"

#include <fmt/core.h>

namespace engine {

content::SceneDesc loaded_scene(const content::Scenario& scenario) {
    content::SceneDesc scene = content::load_scene(scenario);
    for (const std::string& note : scene.notes) {
        fmt::print(stderr, "rapidity: {}\n", note);
    }
    return scene;
}

} // namespace engine
