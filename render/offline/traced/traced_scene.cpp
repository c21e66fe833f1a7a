#include "render/offline/traced/traced_scene.h"

#include "content/data_folders.h"
#include "content/spacetime_file.h"
#include "content/star_catalogue.h"
#include "render/offline/traced/bent_rays.h"
#include "render/offline/traced/hole_rays.h"
#include "render/offline/traced/table_rays.h"
#include "sim/bad_input.h"
#include "sim/spacetime/bundle.h"
#include "sim/spacetime/observer.h"
#include "sim/spacetime/spacetimes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace render {
namespace {

sim::ObserverKind sim_kind(content::ObserverKind kind) {
    switch (kind) {
    case content::ObserverKind::at_rest:
        return sim::ObserverKind::at_rest;
    case content::ObserverKind::zero_angular_momentum:
        return sim::ObserverKind::zero_angular_momentum;
    case content::ObserverKind::circular:
        return sim::ObserverKind::circular_orbit;
    case content::ObserverKind::free_falling:
        break;
    }
    return sim::ObserverKind::free_fall;
}

std::string text_of(const glm::dvec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

/// The camera's event and axes; throws where nobody can be or move so.
template <class Spacetime>
std::pair<sim::Components<double>, sim::Tetrad>
camera_frame(const Spacetime& spacetime, const content::TracedScenario& scenario, const CameraPose& pose) {
    const glm::dvec3& place = pose.position;
    const sim::Components<double> event{pose.time, place.x, place.y, place.z};
    if (spacetime.region(event) == sim::Region::singular) {
        throw sim::BadInput(scenario.name, "camera.position", text_of(place),
                            fmt::format("lies in a singularity or outside the chart of {}", scenario.spacetime.name));
    }
    const auto velocity = sim::observer_velocity(spacetime, event, sim_kind(scenario.camera.observer));
    if (!velocity) {
        throw sim::BadInput(scenario.name, "camera.observer", text_of(place),
                            "no observer of that kind can be there: at rest needs a place outside a horizon and an "
                            "ergosphere, a circular orbit one in the plane z = 0 outside the orbit of light");
    }
    const glm::dvec3 right = glm::cross(pose.look, pose.up);
    const sim::Tetrad rest = sim::camera_tetrad(spacetime, event, *velocity, pose.look, pose.up);
    const glm::dvec3 beta(glm::dot(pose.velocity, right), glm::dot(pose.velocity, pose.up),
                          -glm::dot(pose.velocity, pose.look));
    const sim::Tetrad tetrad = sim::boosted(rest, beta);
    for (const sim::Components<double>& leg : tetrad.legs) {
        if (!std::isfinite(leg.t + leg.x + leg.y + leg.z)) {
            throw sim::BadInput(scenario.name, "camera.position", text_of(place), "the metric is not finite there");
        }
    }
    return {event, tetrad};
}

/// Directions over the picture, even enough to judge a step by.
std::vector<glm::dvec3> pilot_directions(const CameraLens& lens) {
    constexpr int columns = 20;
    constexpr int rows = 12;
    std::vector<glm::dvec3> directions;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const glm::dvec2 point((column + 0.5) * lens.width / columns, (row + 0.5) * lens.height / rows);
            if (const auto direction = head_direction(lens, point)) {
                directions.push_back(*direction);
            }
        }
    }
    return directions;
}

/// What is left of bending where rays past matter count as straight, as a share of the wanted error.
constexpr double tail_share = 1e-2;

/// The largest step with which nine in ten rays of the picture that come from anywhere are known within the wanted
/// error; the others pass the photon ring, where every error grows without bound. Errors go with the fourth power of
/// the step, so a few measurements find it. `rays_at(step)`: rays followed with that step, `step` the first that is
/// tried.
template <class RaysAt>
double step_for(const CameraLens& lens, double wanted, double step, const RaysAt& rays_at) {
    constexpr int most_measurements = 12;
    constexpr double least_reduction = 0.8;
    constexpr double most_reduction = 0.6; // errors of steps far too long say little
    const std::vector<glm::dvec3> directions = pilot_directions(lens);
    std::vector<TracedRay> rays(directions.size());
    for (int i = 0; i < most_measurements; ++i) {
        rays_at(step)->trace(directions, rays, 1);
        std::vector<float> errors;
        for (const TracedRay& ray : rays) {
            if (is_sky(ray.fate) || ray.fate == RayFate::disk || ray.fate == RayFate::object) {
                errors.push_back(ray.error);
            } else if (is_undecided(ray.fate)) {
                errors.push_back(std::numeric_limits<float>::infinity());
            }
        }
        if (errors.empty()) {
            return 0.5 * step; // nothing is seen of infinity
        }
        const auto place = errors.begin() + static_cast<std::ptrdiff_t>(9 * (errors.size() - 1) / 10);
        std::nth_element(errors.begin(), place, errors.end());
        const auto error = static_cast<double>(*place);
        if (error <= wanted) {
            return step;
        }
        step *= glm::clamp(0.9 * std::pow(wanted / error, 0.25), most_reduction, least_reduction);
    }
    return step;
}

} // namespace

struct TracedScene::Parts {
    sim::AnySpacetime spacetime;
    std::optional<SkyLight> sky;
    std::optional<SkyLight> other_sky;
    std::optional<StarField> stars;
    std::optional<StarField> other_stars;
    std::optional<DiskLight> disk;
    std::optional<TracedObjects> objects;
    double clearance = 0.0; ///< chart length around the origin that no object can come into
};

namespace {

sim::AnySpacetime make_spacetime(const content::TracedScenario& scenario) {
    const sim::ParameterValues given(scenario.spacetime.parameters.begin(), scenario.spacetime.parameters.end());
    return content::spacetime_of(scenario.name + ": spacetime", scenario.spacetime.name, given);
}

std::optional<DiskLight> make_disk(const content::TracedScenario& scenario, const sim::AnySpacetime& spacetime,
                                   const TracedColour& colour) {
    if (!scenario.disk) {
        return std::nullopt;
    }
    if (const auto* kerr = std::get_if<sim::Kerr>(&spacetime)) {
        return DiskLight(*scenario.disk, kerr->mass, kerr->spin / kerr->mass, colour);
    }
    if (const auto* schwarzschild = std::get_if<sim::Schwarzschild>(&spacetime)) {
        return DiskLight(*scenario.disk, schwarzschild->mass, 0.0, colour);
    }
    throw sim::BadInput(scenario.name, "disk", scenario.spacetime.name,
                        "a disk turns around a hole: the spacetime must be kerr or schwarzschild");
}

/// Chart length around the origin that holds every object as a camera can see it.
double reach_of(const content::TracedScenario& scenario, const CameraPose& pose) {
    double reach = 0.0;
    for (const content::TracedSphere& sphere : scenario.spheres) {
        // What moves with v is seen from no further than its distance now over 1 - v, where space is flat.
        const glm::dvec3 now = sphere.centre + pose.time * sphere.velocity;
        const double distance = glm::length(now - pose.position) / (1.0 - glm::length(sphere.velocity));
        const bool moves = glm::length(sphere.velocity) > 0.0;
        reach = std::max(reach,
                         sphere.radius + (moves ? glm::length(pose.position) + distance : glm::length(sphere.centre)));
    }
    for (const content::TracedModel& model : scenario.models) {
        reach = std::max(reach, glm::length(model.position));
        for (const content::WorldLinePoint& point : model.path) {
            reach = std::max(reach, glm::length(point.position));
        }
    }
    return reach;
}

double clearance_of(const content::TracedScenario& scenario) {
    double clearance = std::numeric_limits<double>::infinity();
    for (const content::TracedSphere& sphere : scenario.spheres) {
        const bool moves = glm::length(sphere.velocity) > 0.0;
        clearance = std::min(clearance, moves ? 0.0 : glm::length(sphere.centre) - sphere.radius);
    }
    return scenario.models.empty() ? clearance : 0.0;
}

/// Where a ray counts as escaped at the earliest, beyond what the spacetime says itself.
template <class Spacetime>
double least_escape_radius(const Spacetime& spacetime, double error) {
    if constexpr (std::is_same_v<Spacetime, sim::Wormhole>) {
        // Beyond it light is bent by less than (b/R)^2, a tenth of the error; steps grow only so long.
        return 3.2 * spacetime.throat / std::sqrt(error);
    } else {
        return 0.0;
    }
}

/// Of the spacetime's own parameter: with it bundles' magnification is known to 1e-4, away from caustics.
constexpr double bundle_step = 0.2;

/// Well outside the orbits of light of a hole; 0 where there is none.
template <class Spacetime>
double lens_zone(const Spacetime& spacetime) {
    if constexpr (requires { spacetime.radii; }) {
        return 2.0 * spacetime.radii.photon_orbit;
    } else {
        return 0.0;
    }
}

} // namespace

TracedScene::TracedScene(content::TracedScenario scenario, const TraceAccuracy& accuracy)
    : scenario_(std::move(scenario)), accuracy_(accuracy), colour_(scenario_.light.temperature),
      parts_(std::make_unique<Parts>()) {
    parts_->spacetime = make_spacetime(scenario_);
    parts_->disk = make_disk(scenario_, parts_->spacetime, colour_);
    parts_->objects.emplace(scenario_, notes_);
    parts_->clearance = clearance_of(scenario_);
    parts_->sky.emplace(scenario_.sky, notes_);
    skies_.light = {&*parts_->sky, &*parts_->sky};
    if (scenario_.other_sky) {
        parts_->other_sky.emplace(*scenario_.other_sky, notes_);
        skies_.light[1] = &*parts_->other_sky;
    }
    const bool other_stars = scenario_.other_sky ? scenario_.other_sky->stars : scenario_.sky.stars;
    if (scenario_.sky.stars || other_stars) {
        const std::vector<content::Star> stars =
            content::load_star_catalogue(content::content_folder() / "data" / "stars.rstars");
        if (scenario_.sky.stars) {
            parts_->stars.emplace(stars, colour_, scenario_.sky.star_scale);
            skies_.stars[0] = &*parts_->stars;
        }
        if (other_stars && std::holds_alternative<sim::Wormhole>(parts_->spacetime)) {
            const content::TracedSky& sky = scenario_.other_sky ? *scenario_.other_sky : scenario_.sky;
            parts_->other_stars.emplace(stars, colour_, sky.star_scale);
            skies_.stars[1] = &*parts_->other_stars;
        }
    }
}

TracedScene::~TracedScene() = default;

std::unique_ptr<RaySource> TracedScene::rays(const CameraPose& pose, const CameraLens& lens) const {
    return std::visit(
        [&](const auto& spacetime) -> std::unique_ptr<RaySource> {
            using Spacetime = std::decay_t<decltype(spacetime)>;
            const auto [event, tetrad] = camera_frame(spacetime, scenario_, pose);
            refuse_within_objects(event);
            sim::RaySettings settings;
            TracedMatter matter;
            matter.colour = &colour_;
            if (!parts_->objects->empty()) {
                matter.objects = &*parts_->objects;
                settings.nothing_near_horizon = parts_->clearance > lens_zone(spacetime);
                settings.escape_radius =
                    std::max(std::is_same_v<Spacetime, sim::Wormhole> ? 0.0 : spacetime.flat_beyond(),
                             4.0 * (reach_of(scenario_, pose) + glm::length(pose.position)));
            }
            if (parts_->disk) {
                matter.disk = &*parts_->disk;
            }
            settings.escape_radius = std::max(settings.escape_radius, least_escape_radius(spacetime, accuracy_.error));
            const auto tracer_at = [&](double step) {
                settings.step = step;
                return sim::SkyTracer(parts_->spacetime, event, tetrad, settings);
            };
            const auto bent_at = [&](double step) {
                sim::RaySettings bent_settings = settings;
                bent_settings.step = step;
                bent_settings.tail_error = tail_share * accuracy_.error;
                return std::make_unique<BentRays<Spacetime>>(spacetime, event, tetrad, bent_settings, matter);
            };
            const auto bent = [&] { return bent_at(step_for(lens, accuracy_.error, 0.4, bent_at)); };
            const auto on_lanes_at = [&](double step) {
                return std::make_unique<LaneRays>(tracer_at(step), tracer_at(2.0 * step), matter.disk);
            };
            switch (way(event)) {
            case Way::table:
                return std::make_unique<TableRays>(sim::DeflectionTable(
                    parts_->spacetime, event, tetrad, settings, std::clamp(1e-3 * accuracy_.error, 1e-9, 1e-7)));
            case Way::mino:
            case Way::generic:
                return on_lanes_at(step_for(lens, accuracy_.error, 1.0, on_lanes_at));
            case Way::mino_past_objects: {
                const sim::MinoHole hole = *sim::mino_hole(parts_->spacetime);
                const sim::MinoEye eye = sim::mino_eye(parts_->spacetime, hole, event, tetrad);
                const std::shared_ptr<const RaySource> with_time =
                    HoleRays::needs_time(hole, settings, matter) ? bent() : nullptr;
                const auto past_objects_at = [&](double step) {
                    settings.step = step;
                    return std::make_unique<HoleRays>(parts_->spacetime, eye, settings, matter, with_time);
                };
                return past_objects_at(step_for(lens, accuracy_.error, 1.0, past_objects_at));
            }
            case Way::generic_past_matter:
                break;
            }
            return bent();
        },
        parts_->spacetime);
}

BundleMagnification TracedScene::magnification(const CameraPose& pose) const {
    return std::visit(
        [&](const auto& spacetime) -> BundleMagnification {
            const auto [event, tetrad] = camera_frame(spacetime, scenario_, pose);
            sim::RaySettings settings;
            settings.step = bundle_step;
            settings.escape_radius = least_escape_radius(spacetime, accuracy_.error);
            return [&spacetime, event, tetrad, settings](const glm::dvec3& direction) {
                const sim::RayBundle bundle = sim::trace_bundle(spacetime, event, tetrad, direction, settings);
                return bundle.ray.outcome == sim::RayOutcome::escaped ? bundle.magnification() : 0.0;
            };
        },
        parts_->spacetime);
}

TracedScene::Way TracedScene::way(const sim::Components<double>& event) const {
    if (accuracy_.tables && parts_->objects->empty() && !parts_->disk &&
        sim::DeflectionTable::fits(parts_->spacetime, event)) {
        return Way::table;
    }
    const std::optional<sim::MinoHole> hole = sim::mino_hole(parts_->spacetime);
    if (hole && sim::fits_mino(*hole, event)) {
        return parts_->objects->empty() ? Way::mino : Way::mino_past_objects;
    }
    return parts_->objects->empty() && !parts_->disk ? Way::generic : Way::generic_past_matter;
}

void TracedScene::refuse_within_objects(const sim::Components<double>& event) const {
    if (parts_->objects->covers(to_vector(event))) {
        throw sim::BadInput(scenario_.name, "camera.position", text_of(sim::space(event)), "lies within an object");
    }
}

std::string TracedScene::method(const CameraPose& pose) const {
    return std::visit(
        [&](const auto& spacetime) -> std::string {
            const auto [event, tetrad] = camera_frame(spacetime, scenario_, pose);
            refuse_within_objects(event);
            switch (way(event)) {
            case Way::table:
                return "a table of deflections";
            case Way::mino:
                return "Mino time on lanes";
            case Way::mino_past_objects:
                return "Mino time on lanes, objects met on the way";
            case Way::generic:
                return "Hamilton's equations on lanes";
            case Way::generic_past_matter:
                break;
            }
            return "Hamilton's equations on lanes, objects met on the way";
        },
        parts_->spacetime);
}

} // namespace render
