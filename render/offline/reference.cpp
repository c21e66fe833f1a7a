#include "render/offline/reference.h"

#include "render/eye_ray.h"
#include "render/moving/ship_rays.h"
#include "render/offline/reference_stars.h"
#include "render/offline/rest_light.h"
#include "render/offline/seen_colour.h"

#include <limits>
#include <memory>
#include <span>
#include <tbb/parallel_for.h>

namespace render {
namespace {

/// What one ray, or the mean of several, brings.
struct Sample {
    glm::dvec3 radiance{0.0};
    double sky_share = 0.0; ///< 1 where nothing stands before the sky
};

/// One ray's way from the picture into the world at rest.
class RayTracer {
  public:
    RayTracer(const content::SceneDesc& scene, const SceneSpectra& spectra, const SceneryHits& scenery,
              const RenderFrame& frame, SpectralSums sums)
        : scene_(scene), spectra_(spectra), scenery_(scenery), frame_(frame),
          ships_(frame.moving.ships.empty() ? nullptr : std::make_unique<const Ships>(frame, scene)),
          eye_(sim::split(frame.eye.world_from_head)),
          colour_(scene, spectra, frame.layer == Layer::light ? frame.mode : Mode::geometry, eye_.xi.value, sums) {}

    Sample light(double x, double y) const {
        const sim::SeenLight seen = seen_through(x, y);
        const std::optional<SurfaceHit> hit = scenery_.first(frame_.eye.position, seen.world_direction);
        if (const std::optional<ShipHit> ship = ship_before(hit, seen.world_direction)) {
            return {ship->radiance, 0.0};
        }
        const RestLight at_rest =
            hit ? surface_light(scene_, spectra_, scenery_, *hit) : sky_light(scene_, spectra_, seen.world_direction);
        return {colour_.radiance(at_rest, seen.wavelength_ratio), hit ? 0.0 : 1.0};
    }

    void layer(double x, double y, std::span<float> values) const {
        const sim::SeenLight seen = seen_through(x, y);
        if (frame_.layer == Layer::direction) {
            for (int i = 0; i < 3; ++i) {
                values[static_cast<std::size_t>(i)] = static_cast<float>(seen.world_direction[i]);
            }
            return;
        }
        if (frame_.layer == Layer::doppler && !ships_) {
            values[0] = static_cast<float>(seen.wavelength_ratio);
            return;
        }
        const std::optional<SurfaceHit> hit = scenery_.first(frame_.eye.position, seen.world_direction);
        const std::optional<ShipHit> ship = ship_before(hit, seen.world_direction);
        if (frame_.layer == Layer::doppler) {
            values[0] = static_cast<float>(ship ? ship->wavelength_ratio : seen.wavelength_ratio);
        } else {
            values[0] = ship  ? static_cast<float>(ship->distance)
                        : hit ? static_cast<float>(hit->distance)
                              : std::numeric_limits<float>::infinity();
        }
    }

    /// The objects through the centres of sixteen pixels, 4 x 4 from (left, top).
    LaneIndices objects(int left, int top) const {
        Lanes3 directions;
        for (int i = 0; i < lane_count; ++i) {
            const glm::vec3 direction(seen_through(left + (i & 3) + 0.5, top + (i >> 2) + 0.5).world_direction);
            directions.x[i] = direction.x;
            directions.y[i] = direction.y;
            directions.z[i] = direction.z;
        }
        PacketHits hits;
        scenery_.first(glm::vec3(frame_.eye.position), directions, hits);
        for (int i = 0; ships_ && i < lane_count; ++i) {
            const std::optional<ShipHit> ship =
                ships_->rays.first(seen_through(left + (i & 3) + 0.5, top + (i >> 2) + 0.5).world_direction);
            if (ship && ship->distance < static_cast<double>(hits.distance[i])) {
                hits.instance[i] = static_cast<std::uint32_t>(ship->object);
            }
        }
        return hits.instance;
    }

  private:
    /// What only pictures with ships need.
    struct Ships {
        Ships(const RenderFrame& frame, const content::SceneDesc& scene)
            : surroundings(scene), colour(scene.light_temperature), rays(frame, surroundings, colour) {}
        Surroundings surroundings;
        DopplerColour colour;
        ShipRays rays;
    };

    sim::SeenLight seen_through(double x, double y) const {
        return sim::see(eye_, head_direction_from_pixel(frame_.eye, x, y));
    }

    std::optional<ShipHit> ship_before(const std::optional<SurfaceHit>& hit, const glm::dvec3& direction) const {
        if (!ships_) {
            return std::nullopt;
        }
        const std::optional<ShipHit> ship = ships_->rays.first(direction);
        return ship && (!hit || ship->distance < hit->distance) ? ship : std::nullopt;
    }

    const content::SceneDesc& scene_;
    const SceneSpectra& spectra_;
    const SceneryHits& scenery_;
    const RenderFrame& frame_;
    std::unique_ptr<const Ships> ships_; ///< none where no ship is
    sim::BoostAndRotation eye_;
    SeenColour colour_;
};

Sample mean_light(const RayTracer& tracer, int column, int row, int samples_per_side) {
    Sample sum;
    for (int j = 0; j < samples_per_side; ++j) {
        for (int i = 0; i < samples_per_side; ++i) {
            const Sample sample =
                tracer.light(column + (i + 0.5) / samples_per_side, row + (j + 0.5) / samples_per_side);
            sum.radiance += sample.radiance;
            sum.sky_share += sample.sky_share;
        }
    }
    const double weight = 1.0 / (static_cast<double>(samples_per_side) * samples_per_side);
    return {weight * sum.radiance, weight * sum.sky_share};
}

Picture blank_picture(const EyeView& eye, int channels) {
    Picture picture;
    picture.width = eye.width;
    picture.height = eye.height;
    picture.channels = channels;
    picture.values.resize(static_cast<std::size_t>(eye.width) * static_cast<std::size_t>(eye.height) *
                          static_cast<std::size_t>(channels));
    return picture;
}

/// Calls work(column, row, pixel's index) for every pixel, rows in parallel.
template <class Work>
void for_each_pixel(const EyeView& eye, const Work& work) {
    tbb::parallel_for(0, eye.height, [&](int row) {
        for (int column = 0; column < eye.width; ++column) {
            work(column, row,
                 static_cast<std::size_t>(row) * static_cast<std::size_t>(eye.width) +
                     static_cast<std::size_t>(column));
        }
    });
}

Picture light_picture(const content::SceneDesc& scene, const RayTracer& tracer, const RenderFrame& frame,
                      int samples_per_side) {
    Picture picture = blank_picture(frame.eye, 3);
    std::vector<float> sky_shares(picture.values.size() / 3);
    for_each_pixel(frame.eye, [&](int column, int row, std::size_t pixel) {
        const Sample mean = mean_light(tracer, column, row, samples_per_side);
        for (int i = 0; i < 3; ++i) {
            picture.values[3 * pixel + static_cast<std::size_t>(i)] = static_cast<float>(mean.radiance[i]);
        }
        sky_shares[pixel] = static_cast<float>(mean.sky_share);
    });
    add_stars(scene, frame, sky_shares, picture);
    return picture;
}

/// The layer that needs no more than which triangle is hit: sixteen rays at a time.
Picture object_picture(const RayTracer& tracer, const EyeView& eye) {
    Picture picture = blank_picture(eye, 1);
    tbb::parallel_for(0, (eye.height + 3) / 4, [&](int band) {
        for (int left = 0; left < eye.width; left += 4) {
            const LaneIndices objects = tracer.objects(left, 4 * band);
            for (int i = 0; i < lane_count; ++i) {
                const int column = left + (i & 3);
                const int row = 4 * band + (i >> 2);
                if (column < eye.width && row < eye.height) {
                    picture.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(eye.width) +
                                   static_cast<std::size_t>(column)] =
                        objects[i] == PacketHits::nothing ? -1.0f : static_cast<float>(objects[i]);
                }
            }
        }
    });
    return picture;
}

} // namespace

Picture ReferenceRenderer::render(const RenderFrame& frame, int samples_per_side, SpectralSums sums) const {
    const RayTracer tracer(scene_, spectra_, scenery_, frame, sums);
    if (frame.layer == Layer::light) {
        return light_picture(scene_, tracer, frame, samples_per_side);
    }
    if (frame.layer == Layer::object) {
        return object_picture(tracer, frame.eye);
    }
    Picture picture = blank_picture(frame.eye, frame.layer == Layer::direction ? 3 : 1);
    const auto channels = static_cast<std::size_t>(picture.channels);
    for_each_pixel(frame.eye, [&](int column, int row, std::size_t pixel) {
        tracer.layer(column + 0.5, row + 0.5, std::span(picture.values).subspan(pixel * channels, channels));
    });
    return picture;
}

} // namespace render
