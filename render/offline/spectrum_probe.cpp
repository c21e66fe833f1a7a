#include "render/offline/spectrum_probe.h"

#include "render/eye_ray.h"
#include "render/offline/rest_light.h"
#include "render/offline/seen_colour.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace render {
namespace {

constexpr double star_reach = 4.0; // pixels

} // namespace

struct SpectrumProbe::Spectra {
    explicit Spectra(const content::SceneDesc& scene) : of_scene(scene), colour(of_scene) {}
    SceneSpectra of_scene;
    SpectralColour colour;
};

double ProbedLight::received(double wavelength_nm) const {
    return emitted(wavelength_nm / wavelength_ratio) / std::pow(wavelength_ratio, 5.0);
}

SpectrumProbe::SpectrumProbe(const content::SceneDesc& scene)
    : scene_(scene), scenery_(scene), spectra_(std::make_shared<const Spectra>(scene)) {}

ProbedLight SpectrumProbe::at(const RenderFrame& frame, const glm::dvec2& pixel) const {
    const sim::SeenLight seen =
        sim::see(frame.eye.world_from_head, head_direction_from_pixel(frame.eye, pixel.x, pixel.y));
    const std::optional<SurfaceHit> hit = scenery_.first(frame.eye.position, seen.world_direction);
    if (!hit) {
        if (const std::optional<ProbedLight> found = star(frame, pixel)) {
            return *found;
        }
    }
    ProbedLight light;
    light.world_direction = seen.world_direction;
    light.wavelength_ratio = seen.wavelength_ratio;
    RestLight at_rest;
    if (hit) {
        const content::Instance& instance = scene_.instances[hit->instance];
        light.source = ProbedLight::Source::surface;
        light.object = instance.name;
        light.material = scene_.materials[scene_.meshes[instance.mesh].material].name;
        light.distance = hit->distance;
        at_rest = surface_light(scene_, spectra_->of_scene, scenery_, *hit);
    } else {
        at_rest = sky_light(scene_, spectra_->of_scene, seen.world_direction);
    }
    light.at_rest = spectra_->colour.seen(at_rest, 1.0);
    light.seen = spectra_->colour.seen(at_rest, seen.wavelength_ratio);
    light.emitted = [spectra = spectra_, at_rest](double nm) { return spectra->colour.emitted(at_rest, nm); };
    return light;
}

std::optional<ProbedLight> SpectrumProbe::star(const RenderFrame& frame, const glm::dvec2& pixel) const {
    const sim::BoostAndRotation eye = sim::split(frame.eye.world_from_head);
    const glm::dvec3 eye_light_years = frame.eye.position / frame.metres_per_light_year;
    const double focal_pixels = focal_length_pixels(frame.eye);
    const glm::dvec2 axis = axis_pixel(frame.eye);
    std::optional<ProbedLight> nearest;
    double nearest_off = star_reach;
    for (const content::Star& star : scene_.stars) {
        const glm::dvec3 offset = star.position - eye_light_years;
        const double distance = glm::length(offset);
        if (distance == 0.0) {
            continue;
        }
        const sim::SeenFrom from = sim::where_seen(eye, {offset / distance});
        const glm::dvec3& d = from.head_direction;
        if (d.z >= 0.0) {
            continue;
        }
        const double off = glm::distance(pixel, axis + focal_pixels / -d.z * glm::dvec2(d.x, -d.y));
        if (off < nearest_off) {
            nearest_off = off;
            nearest.emplace();
            nearest->source = ProbedLight::Source::star;
            nearest->distance = distance;
            nearest->star_temperature = static_cast<double>(star.temperature);
            nearest->world_direction = offset / distance;
            nearest->wavelength_ratio = from.wavelength_ratio;
        }
    }
    if (nearest) {
        const double temperature = nearest->star_temperature;
        nearest->emitted = [temperature, at_560 = content::black_body_radiance(560.0, temperature)](double nm) {
            return content::black_body_radiance(nm, temperature) / at_560;
        };
    }
    return nearest;
}

} // namespace render
