#include "render/offline/reference.h"

#include "render/eye_ray.h"
#include "render/offline/rest_light.h"
#include "render/offline/seen_colour.h"

#include <limits>
#include <span>
#include <tbb/parallel_for.h>

namespace render {
namespace {

/// One ray's way from the picture into the world at rest.
class RayTracer {
  public:
    RayTracer(const content::SceneDesc& scene, const SceneryHits& scenery, const RenderFrame& frame)
        : scene_(scene), scenery_(scenery), frame_(frame),
          colour_(frame.mode, scene.light_temperature, sim::rapidity(frame.eye.world_from_head).value) {}

    glm::dvec3 radiance(double x, double y) const {
        const sim::SeenLight seen = seen_through(x, y);
        const std::optional<SurfaceHit> hit = scenery_.first(frame_.eye.position, seen.world_direction);
        const glm::dvec3 at_rest =
            hit ? surface_radiance(scene_, scenery_, *hit) : sky_radiance(scene_, seen.world_direction);
        return colour_.radiance(at_rest, seen.wavelength_ratio);
    }

    void layer(double x, double y, std::span<float> values) const {
        const sim::SeenLight seen = seen_through(x, y);
        if (frame_.layer == Layer::doppler) {
            values[0] = static_cast<float>(seen.wavelength_ratio);
        } else if (frame_.layer == Layer::direction) {
            for (int i = 0; i < 3; ++i) {
                values[static_cast<std::size_t>(i)] = static_cast<float>(seen.world_direction[i]);
            }
        } else {
            const std::optional<SurfaceHit> hit = scenery_.first(frame_.eye.position, seen.world_direction);
            if (frame_.layer == Layer::distance) {
                values[0] = hit ? static_cast<float>(hit->distance) : std::numeric_limits<float>::infinity();
            } else {
                values[0] = hit ? static_cast<float>(hit->instance) : -1.0f;
            }
        }
    }

  private:
    sim::SeenLight seen_through(double x, double y) const {
        return sim::see(frame_.eye.world_from_head, head_direction_from_pixel(frame_.eye, x, y));
    }

    const content::SceneDesc& scene_;
    const SceneryHits& scenery_;
    const RenderFrame& frame_;
    SeenColour colour_;
};

glm::dvec3 mean_radiance(const RayTracer& tracer, int column, int row, int samples_per_side) {
    glm::dvec3 sum(0.0);
    for (int j = 0; j < samples_per_side; ++j) {
        for (int i = 0; i < samples_per_side; ++i) {
            sum += tracer.radiance(column + (i + 0.5) / samples_per_side, row + (j + 0.5) / samples_per_side);
        }
    }
    return sum / (static_cast<double>(samples_per_side) * samples_per_side);
}

} // namespace

Picture ReferenceRenderer::render(const RenderFrame& frame, int samples_per_side) const {
    Picture picture;
    picture.width = frame.eye.width;
    picture.height = frame.eye.height;
    picture.channels = frame.layer == Layer::light || frame.layer == Layer::direction ? 3 : 1;
    const auto channels = static_cast<std::size_t>(picture.channels);
    const std::size_t row_values = static_cast<std::size_t>(picture.width) * channels;
    picture.values.resize(row_values * static_cast<std::size_t>(picture.height));
    const RayTracer tracer(scene_, scenery_, frame);
    tbb::parallel_for(0, picture.height, [&](int row) {
        const std::span<float> line(&picture.values[row_values * static_cast<std::size_t>(row)], row_values);
        for (int column = 0; column < picture.width; ++column) {
            const std::span<float> pixel = line.subspan(static_cast<std::size_t>(column) * channels, channels);
            if (frame.layer != Layer::light) {
                tracer.layer(column + 0.5, row + 0.5, pixel);
                continue;
            }
            const glm::dvec3 mean = mean_radiance(tracer, column, row, samples_per_side);
            for (int i = 0; i < 3; ++i) {
                pixel[static_cast<std::size_t>(i)] = static_cast<float>(mean[i]);
            }
        }
    });
    return picture;
}

} // namespace render
