#include "content/scenario.h"

#include "content/data_folders.h"
#include "content/gltf.h"
#include "content/model_name.h"
#include "content/nearest_name.h"
#include "content/panorama.h"
#include "content/scenario_file.h"
#include "content/star_catalogue.h"
#include "content/toml_file.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <system_error>

namespace content {
namespace {

bool is_model_file(const std::filesystem::path& file) {
    return file.extension() == ".glb" || file.extension() == ".gltf";
}

bool is_present(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

std::filesystem::path built_in_folder() {
    return content_folder() / "scenarios";
}

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

Box bounding_box(const SceneDesc& scene) {
    Box box;
    for (const Instance& instance : scene.instances) {
        for (const Vertex& vertex : scene.meshes[instance.mesh].vertices) {
            const glm::dvec3 point(instance.world_from_mesh * glm::vec4(vertex.position, 1.0f));
            box.low = glm::min(box.low, point);
            box.high = glm::max(box.high, point);
        }
    }
    return box;
}

void start_at(Scenario& scenario, const StartView& view) {
    scenario.start_position = view.position;
    scenario.start_look = view.look;
    scenario.start_heading = view.look;
    scenario.horizontal_field_of_view = view.horizontal_field_of_view;
}

// From outside, a little above, so far away that the whole box is in the picture.
StartView view_of(const Box& box) {
    StartView view;
    const glm::dvec3 middle = 0.5 * (box.low + box.high);
    const double radius = 0.5 * glm::length(box.high - box.low);
    view.look = glm::normalize(glm::dvec3(-0.4, -0.3, -1.0));
    // At twice the radius the enclosing sphere is 60 degrees wide, which a picture of 90 x 59 degrees just holds.
    view.position = middle - 2.0 * std::max(radius, 0.01) * view.look;
    return view;
}

// What a model says nothing about: a speed of light that its size makes worth flying, and a sky with a sun.
Scenario scenario_of_model(const std::filesystem::path& file) {
    const SceneDesc scene = load_gltf(file);
    Scenario scenario;
    scenario.name = file.stem().string();
    scenario.title = file.filename().string();
    scenario.model = std::filesystem::absolute(file).lexically_normal();
    const bool empty = scene.instances.empty();
    const Box box = empty ? Box{glm::dvec3(-1.0), glm::dvec3(1.0)} : bounding_box(scene);
    // Light crosses the model in four seconds.
    scenario.speed_of_light = std::max(0.25 * glm::length(box.high - box.low), 1.0);
    start_at(scenario, scene.start_views.empty() ? view_of(box) : scene.start_views.front());
    if (!scene.sun && scene.lamps.empty()) {
        scenario.sun.emplace();
    }
    scenario.ambient = {0.25f, 0.3f, 0.4f};
    scenario.vehicle.maximum_acceleration = glm::dvec3(1.0);
    scenario.vehicle.maximum_turn_rate = glm::dvec3(1.5);
    return scenario;
}

Scenario scenario_of_file(const std::filesystem::path& file) {
    ScenarioFile read = read_scenario_file(file);
    if (!read.has_start_position && !read.scenario.model.empty()) {
        const SceneDesc scene = load_model(read.scenario.model);
        if (!scene.start_views.empty()) {
            start_at(read.scenario, scene.start_views.front());
        }
    }
    return std::move(read.scenario);
}

void load_stars(SceneDesc& scene) {
    scene.stars = load_star_catalogue(content_folder() / "data" / "stars.rstars");
    const auto unknown =
        std::count_if(scene.stars.begin(), scene.stars.end(), [](const Star& star) { return !star.distance_known; });
    scene.notes.push_back(fmt::format("{} of {} stars are at no known distance and stand on a shell of {} light-years",
                                      unknown, scene.stars.size(), far_shell_light_years));
}

} // namespace

Scenario load_scenario(const std::string& name_or_file) {
    const std::filesystem::path file(name_or_file);
    if (is_model_file(file)) {
        return scenario_of_model(file);
    }
    if (file.extension() == ".toml") {
        return scenario_of_file(file);
    }
    std::vector<std::string> names;
    for (const std::filesystem::path& built_in : toml_files(built_in_folder())) {
        if (built_in.stem() == name_or_file) {
            return scenario_of_file(built_in);
        }
        names.push_back(built_in.stem().string());
    }
    throw sim::BadInput(name_or_file, "", "",
                        names.empty() ? "neither a .toml nor a .glb or .gltf"
                                      : fmt::format("no scenario of that name, nor a .toml, .glb or .gltf; did you "
                                                    "mean {}?",
                                                    nearest_name(name_or_file, names)));
}

SceneDesc load_scene(const Scenario& scenario) {
    SceneDesc scene;
    if (!scenario.model.empty()) {
        scene = load_model(scenario.model);
    }
    scene.name = scenario.name;
    if (scenario.sun) {
        scene.sun = scenario.sun;
    }
    scene.ambient = scenario.ambient;
    scene.gradient_sky = scenario.gradient_sky;
    scene.light_temperature = scenario.light_temperature;
    scene.reflectance_model = scenario.reflectance_model;
    scene.microwave_background = scenario.microwave_background;
    if (is_present(scenario.panorama)) {
        LoadedPanorama loaded = load_panorama(scenario.panorama);
        turn_and_scale(loaded.panorama, scenario.panorama_turn, scenario.panorama_scale);
        scene.panorama = std::move(loaded.panorama);
        scene.notes.insert(scene.notes.end(), loaded.notes.begin(), loaded.notes.end());
    }
    if (scenario.stars) {
        load_stars(scene);
    }
    const auto missing = missing_content(scenario);
    scene.notes.insert(scene.notes.end(), missing.begin(), missing.end());
    return scene;
}

std::vector<std::string> missing_content(const Scenario& scenario) {
    std::vector<std::string> missing;
    if (!scenario.panorama.empty() && !is_present(scenario.panorama)) {
        missing.push_back(fmt::format("the panorama {} is missing; ./fly fetches it (Debian's blender-data package); a "
                                      "plain sky stands in for it",
                                      scenario.panorama.filename().string()));
    }
    return missing;
}

std::vector<Scenario> built_in_scenarios() {
    std::vector<Scenario> scenarios;
    for (const std::filesystem::path& file : toml_files(built_in_folder())) {
        scenarios.push_back(read_scenario_file(file).scenario);
    }
    return scenarios;
}

} // namespace content
