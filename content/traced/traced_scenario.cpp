#include "content/traced/traced_scenario.h"

#include "content/data_folders.h"
#include "content/model_name.h"
#include "content/panorama.h"
#include "content/toml_file.h"
#include "content/traced/traced_fields.h"

#include <algorithm>
#include <system_error>

namespace content {
namespace {

std::filesystem::path built_in_folder() {
    return content_folder() / "scenarios" / "traced";
}

/// Puts the tables of one parsed file into a TracedScenario.
class TracedScenarioReader {
  public:
    explicit TracedScenarioReader(const std::filesystem::path& file)
        : source_(file.string()), folder_(file.parent_path()) {}

    TracedScenario read(const toml::table& root) {
        FieldReader f(source_, "", root);
        f("title", scenario_.title, "", "");
        if (const toml::table* table = required_table(f, "spacetime")) {
            read_spacetime(*table);
        }
        if (const toml::table* table = sub_table(f, "camera")) {
            read_camera(*table);
        }
        if (const toml::table* table = sub_table(f, "sky")) {
            scenario_.sky = read_sky(*table, "sky.");
        }
        if (const toml::table* table = sub_table(f, "other_sky")) {
            scenario_.other_sky = read_sky(*table, "other_sky.");
        }
        if (const toml::table* table = sub_table(f, "disk")) {
            read_disk(*table);
        }
        if (const toml::table* table = sub_table(f, "light")) {
            read_fields(*table, "light.", [&](auto& fields) { light_fields(fields, scenario_.light); });
        }
        if (const toml::table* table = sub_table(f, "exposure")) {
            read_fields(*table, "exposure.", [&](auto& fields) { exposure_fields(fields, scenario_); });
        }
        for_each_table(f, "sphere", [&](const toml::table& table, const std::string& prefix) {
            scenario_.spheres.push_back(read_sphere(table, prefix));
        });
        for_each_table(f, "model", [&](const toml::table& table, const std::string& prefix) {
            scenario_.models.push_back(read_model(table, prefix));
        });
        f.finish();
        return std::move(scenario_);
    }

  private:
    static const toml::table* sub_table(FieldReader& f, std::string_view name) {
        const toml::node* node = f.find(name);
        if (node != nullptr && !node->is_table()) {
            f.fail(name, *node, "must be a table");
        }
        return node == nullptr ? nullptr : node->as_table();
    }
    const toml::table* required_table(FieldReader& f, std::string_view name) const {
        const toml::table* table = sub_table(f, name);
        if (table == nullptr) {
            throw sim::BadInput(source_, std::string(name), "",
                                "this table is missing: a traced scenario names a "
                                "spacetime");
        }
        return table;
    }

    template <class Fields>
    void read_fields(const toml::table& table, const std::string& prefix, const Fields& fields) const {
        FieldReader f(source_, prefix, table);
        fields(f);
        f.finish();
    }
    template <class Work>
    void for_each_table(FieldReader& f, std::string_view name, const Work& work) const {
        const toml::node* node = f.find(name);
        if (node == nullptr) {
            return;
        }
        const toml::array* array = node->as_array();
        if (array == nullptr ||
            !std::all_of(array->begin(), array->end(), [](const auto& e) { return e.is_table(); })) {
            f.fail(name, *node, fmt::format("must be tables, each headed [[{}]]", name));
        }
        for (std::size_t i = 0; i < array->size(); ++i) {
            work(*array->get(i)->as_table(), fmt::format("{}[{}].", name, i));
        }
    }

    // The parameters belong to the spacetime, which checks their names.
    void read_spacetime(const toml::table& table) {
        FieldReader f(source_, "spacetime.", table);
        for (const auto& [key, node] : table) {
            const std::string name(key.str());
            if (name == "name") {
                scenario_.spacetime.name = f.text(name, node);
                if (scenario_.spacetime.name.ends_with(".toml")) {
                    scenario_.spacetime.name = existing_file(f, name, node, scenario_.spacetime.name).string();
                }
            } else {
                scenario_.spacetime.parameters[name] = f.number(name, node, any_number);
            }
        }
    }

    void read_camera(const toml::table& table) {
        FieldReader f(source_, "camera.", table);
        TracedCamera& camera = scenario_.camera;
        camera_fields(f, camera);
        if (!(glm::length(camera.velocity) < 1.0)) {
            f.fail("velocity", *f.find("velocity"), "must be slower than light");
        }
        if (camera.projection == Projection::perspective && camera.field_of_view >= 179.0 * radians_in_a_degree) {
            const toml::node* node = f.find("field_of_view");
            f.fail("field_of_view", node != nullptr ? *node : table,
                   "a plane screen must be narrower than 179 degrees; fisheye and equirectangular show more");
        }
        for_each_table(f, "path", [&](const toml::table& point, const std::string& prefix) {
            CameraMoment moment = camera.moment;
            read_fields(point, "camera." + prefix, [&](auto& fields) {
                fields("at", moment.at, "", "");
                camera_moment_fields(fields, moment);
            });
            if (!camera.path.empty() && moment.at <= camera.path.back().at) {
                throw sim::BadInput(source_, "camera." + prefix + "at", fmt::format("{}", moment.at),
                                    "must be later than the point before");
            }
            camera.path.push_back(moment);
        });
        f.finish();
    }

    TracedSky read_sky(const toml::table& table, const std::string& prefix) const {
        TracedSky sky;
        FieldReader f(source_, prefix, table);
        sky_fields(f, sky);
        if (const toml::node* node = f.find("panorama")) {
            const std::string name = f.text("panorama", *node);
            sky.panorama = is_studiolight(name) ? studiolight_file(name) : existing_file(f, "panorama", *node, name);
        }
        f.finish();
        return sky;
    }

    void read_disk(const toml::table& table) {
        TracedDisk disk;
        FieldReader f(source_, "disk.", table);
        disk_fields(f, disk);
        f.finish();
        if (disk.outer_radius <= disk.inner_radius) {
            throw sim::BadInput(source_, "disk.outer_radius", fmt::format("{}", disk.outer_radius),
                                "must be more than the inner radius");
        }
        scenario_.disk = disk;
    }

    TracedSphere read_sphere(const toml::table& table, const std::string& prefix) const {
        TracedSphere sphere;
        FieldReader f(source_, prefix, table);
        sphere_fields(f, sphere);
        if (!(glm::length(sphere.velocity) < 1.0)) {
            f.fail("velocity", *f.find("velocity"), "must be slower than light");
        }
        if (!sphere.texture.empty() && sphere.texture != "generated:planet") {
            sphere.texture = existing_file(f, "texture", *f.find("texture"), sphere.texture).string();
        }
        f.finish();
        return sphere;
    }

    TracedModel read_model(const toml::table& table, const std::string& prefix) const {
        TracedModel model;
        FieldReader f(source_, prefix, table);
        model_fields(f, model);
        const toml::node* file = f.find("file");
        if (file == nullptr) {
            throw sim::BadInput(source_, prefix + "file", "", "is missing: a .glb or .gltf, or generated:NAME");
        }
        const std::string name = f.text("file", *file);
        model.file = is_generated_model(name) ? std::filesystem::path(name) : existing_file(f, "file", *file, name);
        for_each_table(f, "path", [&](const toml::table& point, const std::string& point_prefix) {
            WorldLinePoint passing;
            read_fields(point, prefix + point_prefix, [&](auto& fields) { world_line_fields(fields, passing); });
            if (!model.path.empty() && passing.time <= model.path.back().time) {
                throw sim::BadInput(source_, prefix + point_prefix + "time", fmt::format("{}", passing.time),
                                    "must be later than the point before");
            }
            model.path.push_back(passing);
        });
        f.finish();
        return model;
    }

    std::filesystem::path existing_file(const FieldReader& f, std::string_view key, const toml::node& node,
                                        const std::string& name) const {
        std::filesystem::path file = std::filesystem::absolute(folder_ / name).lexically_normal();
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error)) {
            f.fail(key, node, fmt::format("there is no file {}", file.string()));
        }
        return file;
    }

    std::string source_;
    std::filesystem::path folder_;
    TracedScenario scenario_;
};

TracedScenario read_file(const std::filesystem::path& file) {
    TracedScenario scenario = TracedScenarioReader(file).read(read_toml(file));
    scenario.name = file.stem().string();
    scenario.file = std::filesystem::absolute(file).lexically_normal();
    return scenario;
}

} // namespace

TracedScenario load_traced_scenario(const std::string& name_or_file) {
    const std::filesystem::path file(name_or_file);
    if (file.extension() == ".toml") {
        return read_file(file);
    }
    std::vector<std::string> names;
    for (const std::filesystem::path& built_in : toml_files(built_in_folder())) {
        if (built_in.stem() == name_or_file) {
            return read_file(built_in);
        }
        names.push_back(built_in.stem().string());
    }
    throw sim::BadInput(name_or_file, "", "",
                        fmt::format("no traced scenario of that name, nor a .toml; did you mean {}?",
                                    nearest_name(name_or_file, names)));
}

std::vector<TracedScenario> built_in_traced_scenarios() {
    std::vector<TracedScenario> scenarios;
    for (const std::filesystem::path& file : toml_files(built_in_folder())) {
        scenarios.push_back(read_file(file));
    }
    return scenarios;
}

std::vector<std::string> traced_scenario_keys() {
    std::vector<std::string> lines{"title: one line about the picture",
                                   "spacetime.name: a name that `rapidity spacetimes` lists, or a .toml with a metric "
                                   "of your own; its other keys are its parameters"};
    const auto list = [&](const std::string& prefix, const auto& fields, auto value) {
        FieldLister lister(lines, prefix);
        fields(lister, value);
    };
    const auto say = [&](const std::string& line) { lines.push_back(line); };
    list(
        "camera.", [](auto& f, auto& v) { camera_fields(f, v); }, TracedCamera{});
    say("[[camera.path]] at, position, time, look: the camera at moments of a sequence, joined smoothly");
    say("sky.panorama: equirectangular sky: a .exr, .hdr, .png or .jpg, or studiolight:NAME.exr of blender-data");
    list(
        "sky.", [](auto& f, auto& v) { sky_fields(f, v); }, TracedSky{});
    say("other_sky: the same keys, for the sky beyond a wormhole");
    list(
        "disk.", [](auto& f, auto& v) { disk_fields(f, v); }, TracedDisk{});
    list(
        "[[sphere]] ", [](auto& f, auto& v) { sphere_fields(f, v); }, TracedSphere{});
    say("[[model]] file: a .glb or .gltf, or generated:NAME");
    list(
        "[[model]] ", [](auto& f, auto& v) { model_fields(f, v); }, TracedModel{});
    list(
        "[[model.path]] ", [](auto& f, auto& v) { world_line_fields(f, v); }, WorldLinePoint{});
    list(
        "light.", [](auto& f, auto& v) { light_fields(f, v); }, TracedLight{});
    list(
        "exposure.", [](auto& f, auto& v) { exposure_fields(f, v); }, TracedScenario{});
    return lines;
}

CameraMoment camera_at(const TracedCamera& camera, double moment) {
    const std::vector<CameraMoment>& path = camera.path;
    if (path.empty()) {
        return camera.moment;
    }
    if (moment <= path.front().at) {
        return path.front();
    }
    if (moment >= path.back().at) {
        return path.back();
    }
    std::size_t i = 0;
    while (path[i + 1].at < moment) {
        ++i;
    }
    const double span = path[i + 1].at - path[i].at;
    const double s = (moment - path[i].at) / span;
    const auto curve = [&](auto member) {
        const auto slope = [&](std::size_t k) {
            const std::size_t left = k == 0 ? 0 : k - 1;
            const std::size_t right = std::min(k + 1, path.size() - 1);
            return (span / (path[right].at - path[left].at)) * (member(path[right]) - member(path[left]));
        };
        const auto a = member(path[i]);
        const auto b = member(path[i + 1]);
        const auto rise = b - a;
        const auto slope_a = slope(i);
        const auto slope_b = slope(i + 1);
        return a + s * (slope_a + s * ((3.0 * rise - 2.0 * slope_a - slope_b) + s * (slope_a + slope_b - 2.0 * rise)));
    };
    return {moment, curve([](const CameraMoment& m) { return m.time; }),
            curve([](const CameraMoment& m) { return m.position; }),
            curve([](const CameraMoment& m) { return m.look; })};
}

} // namespace content
