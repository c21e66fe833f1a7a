#include "render/offline/traced/traced_objects.h"

#include "content/file_bytes.h"
#include "content/image_file.h"
#include "content/model_name.h"
#include "render/offline/rest_light.h"
#include "render/offline/surface.h"
#include "render/offline/traced/curve_search.h"
#include "render/offline/traced/planet_paint.h"
#include "render/offline/traced/traced_sky.h"
#include "sim/bad_input.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace render {
namespace {

// A chord's departure from the curve, in object radii. The hit itself is then refined on the curve.
constexpr double straightness = 1e-4;

// Columns: two axes across and the axis itself, so that matrix^T takes chart components to the texture's.
glm::dmat3 axes_about(const glm::dvec3& axis, double turn) {
    const glm::dvec3 north = glm::normalize(axis);
    const glm::dvec3 helper = std::abs(north.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 first = glm::normalize(helper - glm::dot(helper, north) * north);
    const glm::dvec3 second = glm::cross(north, first);
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    return {c * first + s * second, c * second - s * first, north};
}

glm::dvec3 equirectangular_colour(const content::Image& image, const glm::dvec3& direction) {
    const double longitude = std::atan2(direction.y, direction.x);
    const double colatitude = std::atan2(std::hypot(direction.x, direction.y), direction.z);
    return {texture_colour(image, {0.5 + 0.5 * std::numbers::inv_pi * longitude, std::numbers::inv_pi * colatitude})};
}

/// A scene that holds one plain material and nothing else: what spheres are made of.
content::SceneDesc plain_material(double light_temperature) {
    content::SceneDesc scene;
    scene.light_temperature = static_cast<float>(light_temperature);
    scene.materials.emplace_back();
    return scene;
}

} // namespace

class TracedObjects::Sphere {
  public:
    Sphere(const content::TracedSphere& sphere, const content::TracedLight& light)
        : sphere_(sphere), light_(light), axes_(axes_about(sphere.axis, sphere.turn)) {
        light_.direction = glm::normalize(light_.direction);
        motion_.centre_at_zero = sphere.centre;
        motion_.velocity = sphere.velocity;
        if (!sphere.texture.empty() && sphere.texture != "generated:planet") {
            const std::vector<std::uint8_t> bytes = content::read_file_bytes(sphere.texture);
            image_ = std::make_shared<content::Image>(content::decode_image(bytes, sphere.texture, ""));
        }
    }

    std::optional<double> meets(const RayCurve& curve) const {
        const auto meet = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return meet_ball(from, to, sphere_.radius);
        };
        const auto s = first_on_curve(motion_.at_rest(curve), sphere_.radius, straightness * sphere_.radius, meet);
        return s ? std::optional(refined(curve, *s)) : std::nullopt;
    }

    ObjectHit light_at(const RayCurve& curve, double s, const SceneSpectra& spectra) const {
        const glm::dvec3 normal = glm::normalize(motion_.at_rest(curve.at(s)));
        ObjectHit hit;
        hit.s = s;
        hit.coordinate_velocity = sphere_.velocity;
        hit.temperature = sphere_.temperature;
        const double cosine = std::max(0.0, glm::dot(normal, light_.direction));
        const glm::dvec3 on_white = light_.ambient + (std::numbers::inv_pi * cosine) * light_.irradiance;
        const MaterialTerms& material = spectra.materials().front();
        hit.light.parts.push_back({material.reflected, spectra.reflected(material, reflectance(normal), on_white)});
        hit.light.parts.push_back({material.emitted, spectra.emitted(material, sphere_.emission)});
        return hit;
    }

    bool moves() const { return sphere_.velocity != glm::dvec3(0.0); }
    sim::WatchedBall bound() const { return {sphere_.centre, sphere_.velocity, sphere_.radius}; }
    bool covers(const glm::dvec4& event) const { return glm::length(motion_.at_rest(event)) < sphere_.radius; }

  private:
    // Newton's steps on |x(s)|^2 - R^2 from the chord's answer.
    double refined(const RayCurve& curve, double s) const {
        for (int i = 0; i < 3; ++i) {
            constexpr double h = 1e-6;
            const glm::dvec3 here = motion_.at_rest(curve.at(s));
            const glm::dvec3 slope = (motion_.at_rest(curve.at(s + h)) - motion_.at_rest(curve.at(s - h))) / (2.0 * h);
            const double rate = 2.0 * glm::dot(here, slope);
            const double step = (glm::dot(here, here) - sphere_.radius * sphere_.radius) / rate;
            if (!(std::abs(step) < 0.1)) {
                break; // a grazing ray: the chord's answer is as good
            }
            s = glm::clamp(s - step, 0.0, 1.0);
        }
        return s;
    }

    glm::dvec3 reflectance(const glm::dvec3& normal) const {
        const glm::dvec3 own = glm::transpose(axes_) * normal;
        if (image_) {
            return sphere_.reflectance * equirectangular_colour(*image_, own);
        }
        if (!sphere_.texture.empty()) {
            return planet_reflectance(own);
        }
        if (sphere_.checkerboard > 0.0) {
            const double latitude = std::atan2(own.z, std::hypot(own.x, own.y));
            return sphere_.reflectance *
                   (0.2 + 0.8 * checkerboard_share(std::atan2(own.y, own.x), latitude, sphere_.checkerboard, 0.0, 0.0));
        }
        return sphere_.reflectance;
    }

    content::TracedSphere sphere_;
    content::TracedLight light_;
    glm::dmat3 axes_;
    InertialPiece motion_;
    std::shared_ptr<content::Image> image_;
};

class TracedObjects::Model {
  public:
    Model(const content::TracedModel& model, const content::TracedLight& light, std::vector<std::string>& notes)
        : scale_(model.scale), scene_(std::make_unique<content::SceneDesc>(content::load_model(model.file))) {
        notes.insert(notes.end(), scene_->notes.begin(), scene_->notes.end());
        const glm::dvec3 back = -glm::normalize(model.look);
        glm::dvec3 right = glm::cross(model.up, back);
        if (!(glm::length(right) > 1e-9)) {
            throw sim::BadInput("[[model]]", "up", model.name, "must not lie along look");
        }
        right = glm::normalize(right);
        chart_from_model_ = {right, glm::cross(back, right), back};
        const glm::dmat3 model_from_chart = glm::transpose(chart_from_model_);
        scene_->sun.emplace();
        scene_->sun->direction = glm::vec3(glm::normalize(model_from_chart * light.direction));
        scene_->sun->irradiance = glm::vec3(light.irradiance);
        scene_->ambient = glm::vec3(light.ambient);
        scene_->light_temperature = static_cast<float>(light.temperature);
        colour_ = std::make_unique<SceneColour>(*scene_);
        scenery_ = std::make_unique<SceneryHits>(*scene_);
        for (const content::Instance& instance : scene_->instances) {
            for (const content::Vertex& vertex : scene_->meshes[instance.mesh].vertices) {
                const glm::dvec4 place =
                    glm::dmat4(instance.world_from_mesh) * glm::dvec4(glm::dvec3(vertex.position), 1.0);
                reach_ = std::max(reach_, glm::length(glm::dvec3(place)));
            }
        }
        make_world_line(model);
    }

    void add_bounds(std::vector<sim::WatchedBall>& bounds) const {
        for (const InertialPiece& piece : world_line_) {
            bounds.push_back({piece.centre_at_zero, piece.velocity, scale_ * reach_});
        }
    }

    std::optional<ObjectHit> first(const RayCurve& curve) const {
        std::optional<ObjectHit> nearest;
        for (const InertialPiece& piece : world_line_) {
            if (!piece.overlaps(curve)) {
                continue;
            }
            RestCurve rest = piece.at_rest(curve);
            const glm::dmat3 model_from_chart = glm::transpose(chart_from_model_) / scale_;
            for (glm::dvec4& point : rest) {
                point = glm::dvec4(model_from_chart * glm::dvec3(point), point.w);
            }
            std::optional<SurfaceHit> surface;
            const auto meet = [&](const glm::dvec3& from, const glm::dvec3& to) -> std::optional<double> {
                const double length = glm::length(to - from);
                if (!(length > 0.0)) {
                    return std::nullopt;
                }
                const auto hit = scenery_->first(from, (to - from) / length);
                if (!hit || hit->distance > length) {
                    return std::nullopt;
                }
                surface = hit;
                return hit->distance / length;
            };
            const auto s = first_on_curve(rest, reach_, straightness * reach_, meet);
            if (s && piece.exists_at(curve.at(*s).x) && (!nearest || *s < nearest->s)) {
                nearest = ObjectHit{*s, 0, piece.velocity,
                                    surface_light(*scene_, colour_->spectra(), *scenery_, *surface), 0.0};
            }
        }
        return nearest;
    }

    bool moves() const { return world_line_.size() > 1; }
    const SceneColour& colour() const { return *colour_; }

  private:
    void make_world_line(const content::TracedModel& model) {
        if (model.path.empty()) {
            world_line_.push_back({model.position, glm::dvec3(0.0)});
            return;
        }
        const auto& path = model.path;
        constexpr double forever = std::numeric_limits<double>::infinity();
        world_line_.push_back({path.front().position, glm::dvec3(0.0), -forever, path.front().time});
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const glm::dvec3 velocity = (path[i + 1].position - path[i].position) / (path[i + 1].time - path[i].time);
            if (!(glm::length(velocity) < 1.0)) {
                throw sim::BadInput("[[model]]", fmt::format("path[{}]", i + 1),
                                    fmt::format("{:.6g} c", glm::length(velocity)),
                                    "is reached only faster than light");
            }
            world_line_.push_back(
                {path[i].position - path[i].time * velocity, velocity, path[i].time, path[i + 1].time});
        }
        world_line_.push_back({path.back().position, glm::dvec3(0.0), path.back().time, forever});
    }

    double scale_;
    double reach_ = 0.0; ///< metres: all of the model lies within it of its origin
    glm::dmat3 chart_from_model_{1.0};
    std::unique_ptr<content::SceneDesc> scene_;
    std::unique_ptr<SceneryHits> scenery_;
    std::unique_ptr<SceneColour> colour_;
    std::vector<InertialPiece> world_line_;
};

TracedObjects::TracedObjects(const content::TracedScenario& scenario, std::vector<std::string>& notes) {
    if (!scenario.spheres.empty()) {
        sphere_colour_.emplace(plain_material(scenario.light.temperature));
    }
    for (const content::TracedSphere& sphere : scenario.spheres) {
        spheres_.emplace_back(sphere, scenario.light);
    }
    for (const content::TracedModel& model : scenario.models) {
        models_.emplace_back(model, scenario.light, notes);
    }
    for (const Sphere& sphere : spheres_) {
        if (sphere.moves()) {
            moving_bounds_.push_back(sphere.bound());
        }
    }
    for (const Model& model : models_) {
        if (model.moves()) {
            model.add_bounds(moving_bounds_);
        }
    }
}
TracedObjects::~TracedObjects() = default;
TracedObjects::TracedObjects(TracedObjects&&) noexcept = default;
TracedObjects& TracedObjects::operator=(TracedObjects&&) noexcept = default;

bool TracedObjects::empty() const {
    return spheres_.empty() && models_.empty();
}

std::vector<sim::WatchedBall> TracedObjects::bounds() const {
    std::vector<sim::WatchedBall> bounds;
    for (const Sphere& sphere : spheres_) {
        bounds.push_back(sphere.bound());
    }
    for (const Model& model : models_) {
        model.add_bounds(bounds);
    }
    return bounds;
}

bool TracedObjects::may_meet_moving(const RayCurve& curve) const {
    return std::ranges::any_of(moving_bounds_, [&](const sim::WatchedBall& ball) {
        RestCurve offset = InertialPiece{ball.centre_at_zero}.at_rest(curve);
        const double speed2 = glm::dot(ball.velocity, ball.velocity);
        for (glm::dvec4& point : offset) {
            if (speed2 > 0.0) {
                const double along = glm::dot(glm::dvec3(point), ball.velocity) / speed2;
                point -= glm::dvec4(along * ball.velocity, 0.0);
            }
        }
        constexpr double slack = 0.01;
        const double radius = (1.0 + slack) * ball.radius;
        const auto meet = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return glm::length(from) < radius ? std::optional(0.0) : meet_ball(from, to, radius);
        };
        return first_on_curve(offset, radius, slack * ball.radius, meet).has_value();
    });
}

std::optional<ObjectHit> TracedObjects::first(const RayCurve& curve) const {
    std::optional<ObjectHit> nearest;
    for (std::size_t i = 0; i < spheres_.size(); ++i) {
        if (spheres_[i].moves() && !curve.has_time) {
            continue;
        }
        const std::optional<double> s = spheres_[i].meets(curve);
        if (s && (!nearest || *s < nearest->s)) {
            nearest = spheres_[i].light_at(curve, *s, sphere_colour_->spectra());
            nearest->object = i;
        }
    }
    for (std::size_t i = 0; i < models_.size(); ++i) {
        if (models_[i].moves() && !curve.has_time) {
            continue;
        }
        std::optional<ObjectHit> hit = models_[i].first(curve);
        if (hit && (!nearest || hit->s < nearest->s)) {
            nearest = hit;
            nearest->object = spheres_.size() + i;
        }
    }
    return nearest;
}

glm::dvec3 TracedObjects::seen(const ObjectHit& hit, double wavelength_ratio) const {
    const bool is_sphere = hit.object < spheres_.size();
    const SceneColour& colour = is_sphere ? *sphere_colour_ : models_[hit.object - spheres_.size()].colour();
    glm::dvec3 sum(0.0);
    for (const RestLight::Part& part : hit.light.parts) {
        sum += colour.seen(part.group, part.weights, Mode::full, std::log(wavelength_ratio));
    }
    return sum;
}

bool TracedObjects::covers(const glm::dvec4& event) const {
    return std::any_of(spheres_.begin(), spheres_.end(), [&](const Sphere& sphere) { return sphere.covers(event); });
}

} // namespace render
