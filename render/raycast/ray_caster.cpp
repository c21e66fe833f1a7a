#include "render/raycast/ray_caster.h"

#include "render/colour/frame_colour_table.h"
#include "render/gl/boosted_view.h"
#include "render/offline/scenery_hits.h"
#include "render/raycast/packet_colour.h"
#include "render/raycast/packet_rays.h"
#include "render/raycast/packet_stars.h"
#include "render/raycast/ship_hits.h"
#include "render/raycast/sky_map.h"
#include "render/raycast/surface_light.h"
#include "render/star_sheet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <tbb/parallel_for.h>
#include <vector>

namespace render {
namespace {

/// Pixels along each side of the block that one thread works on.
constexpr int block_side = 32;

/// One sample of each pixel: where from the pixel's centre, in pixels, and how many there are along each of its sides.
struct PixelSample {
    float right = 0.0f;
    float up = 0.0f;
    int per_side = 1;
};

/// What all packets of a frame share.
struct FrameOfRays {
    explicit FrameOfRays(const RenderFrame& frame, const BoostedView& view, const PixelSample& sample = {})
        : screen(screen_rays(view)), eye(frame.eye.position), width(view.width), height(view.height),
          focal_pixels(0.5 * sample.per_side * view.width / view.half_extent.x) {
        screen.origin += sample.right * screen.right + sample.up * screen.up;
    }

    ScreenRays screen;
    glm::vec3 eye;
    int width;
    int height;
    double focal_pixels; ///< samples a unit tangent: textures are filtered over a sample, not a pixel
};

/// Calls work(left, bottom) for every packet of the picture, blocks of them on all processors.
template <class Work>
void for_each_packet(int width, int height, const Work& work) {
    const int columns = (width + block_side - 1) / block_side;
    const int rows = (height + block_side - 1) / block_side;
    tbb::parallel_for(0, columns * rows, [&](int block) {
        const int left = block % columns * block_side;
        const int bottom = block / columns * block_side;
        for (int y = bottom; y < std::min(bottom + block_side, height); y += packet_side) {
            for (int x = left; x < std::min(left + block_side, width); x += packet_side) {
                work(x, y);
            }
        }
    });
}

/// Calls put(lane, pixel's index) for the lanes that are inside the picture; rows from the bottom or from the top.
template <class Put>
void for_each_lane(const FrameOfRays& frame, int left, int bottom, bool from_top, const Put& put) {
    const int columns = std::min(packet_side, frame.width - left);
    const int rows = std::min(packet_side, frame.height - bottom);
    for (int row = 0; row < rows; ++row) {
        const int y = from_top ? frame.height - 1 - (bottom + row) : bottom + row;
        const std::size_t first =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(left);
        for (int column = 0; column < columns; ++column) {
            put(packet_side * row + column, first + static_cast<std::size_t>(column));
        }
    }
}

} // namespace

class RayCaster::Implementation {
  public:
    Implementation(const content::SceneDesc& scene, const SceneColour& colour)
        : scene_(scene), colour_(colour), scenery_(scene, Edges::fast), surfaces_(scene, colour.spectra(), scenery_),
          stars_(scene, colour.doppler()) {
        if (scene.panorama) {
            sky_.emplace(*scene.panorama);
        }
    }

    /// `Pixels`: what store() takes.
    template <class Pixels>
    void light(const RenderFrame& render_frame, double pre_exposure, Pixels& pixels, const PixelSample& sample = {},
               StereoShare* share = nullptr, std::span<float> depths = {}) const {
        const BoostedView view = boosted_view(render_frame.eye);
        const FrameOfRays frame(render_frame, view, sample);
        StereoShare* const far = share != nullptr && share->whole() ? share : nullptr;
        std::optional<FrameColourTable> own_table;
        std::optional<FrameColourTable>& kept = far != nullptr ? far->colours : own_table;
        if (!kept) {
            kept = colours_of(far != nullptr ? boosted_view(*far->whole()) : view, render_frame.mode, pre_exposure);
        }
        const FrameColourTable& table = *kept;
        const std::optional<ShipHits> ships = ships_of(render_frame);
        for_each_packet(frame.width, frame.height, [&](int left, int bottom) {
            SeenPacket seen;
            see_packet(frame.screen, left, bottom, seen);
            PacketHits hits;
            scenery_.first(frame.eye, seen.direction, hits);
            PacketShips of_ships;
            if (ships) {
                ships->first(seen.direction, hits.distance, of_ships);
            }
            const LaneMask found = lanes_with_hits(hits) & ~of_ships.seen;
            const LaneMask covered = found | of_ships.seen;
            Lanes3 light{};
            StereoShare::Sky* const sky =
                far != nullptr && covered != all_lanes ? &far->sky(render_frame.eye, left, bottom) : nullptr;
            if (sky != nullptr && covered == 0 &&
                sky->known == all_lanes) { // nothing but sky that the other eye has seen
                light = sky->light;
                far->sky_reused.fetch_add(lane_count, std::memory_order_relaxed);
            } else {
                add_light(frame, seen, hits, found, covered, table, far, sky, light);
            }
            add_ship_light(of_ships, static_cast<float>(pre_exposure), light);
            store(frame, left, bottom, covered, light, pixels);
            if (!depths.empty()) {
                for_each_lane(frame, left, bottom, false, [&](int lane, std::size_t pixel) {
                    const float distance = (has(of_ships.seen, lane) ? of_ships.distance : hits.distance)[lane];
                    const float z = distance / std::sqrt(seen.ray_length2[lane]);
                    depths[pixel] = has(covered, lane) ? static_cast<float>(nearest_depth) / z : 0.0f;
                });
            }
        });
    }

    void add_stars(const RenderFrame& frame, double pre_exposure, LightPackets& packets, StereoShare* share) const {
        if (!stars_.empty()) {
            render::add_stars(stars_, frame, pre_exposure, share, packets);
        }
    }

    Picture picture(const RenderFrame& frame, int samples_per_side) const {
        return frame.layer == Layer::light ? light_picture(frame, samples_per_side) : layer_picture(frame);
    }

  private:
    /// The mean over samples_per_side^2 pictures, each through another point of the pixels.
    std::vector<glm::vec4> mean_light(const RenderFrame& frame, int samples_per_side) const {
        const std::size_t count =
            static_cast<std::size_t>(frame.eye.width) * static_cast<std::size_t>(frame.eye.height);
        std::vector<glm::vec4> sum(count);
        std::vector<glm::vec4> one(count);
        std::span<glm::vec4> pixels(one);
        const auto from_centre = [&](int index) {
            return (static_cast<float>(index) + 0.5f) / static_cast<float>(samples_per_side) - 0.5f;
        };
        const float weight = 1.0f / static_cast<float>(samples_per_side * samples_per_side);
        for (int row = 0; row < samples_per_side; ++row) {
            for (int column = 0; column < samples_per_side; ++column) {
                light(frame, 1.0, pixels, {from_centre(column), from_centre(row), samples_per_side});
                for (std::size_t i = 0; i < count; ++i) {
                    sum[i] += weight * one[i];
                }
            }
        }
        return sum;
    }

    Picture light_picture(const RenderFrame& frame, int samples_per_side) const {
        const std::vector<glm::vec4> pixels = mean_light(frame, samples_per_side);
        const std::size_t count = pixels.size();
        std::vector<glm::vec4> stars;
        if (!stars_.empty()) {
            stars_.draw(frame, 1.0, 0.0, stars);
        }
        Picture picture{frame.eye.width, frame.eye.height, 3, {}};
        picture.values.reserve(3 * count);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::vec4 light = stars.empty() ? pixels[i] : pixels[i] + pixels[i].w * stars[i];
            picture.values.insert(picture.values.end(), {light.x, light.y, light.z});
        }
        return picture;
    }

    Picture layer_picture(const RenderFrame& render_frame) const {
        const BoostedView view = boosted_view(render_frame.eye);
        const FrameOfRays frame(render_frame, view);
        const Layer layer = render_frame.layer;
        const std::optional<ShipHits> ships = layer == Layer::direction ? std::nullopt : ships_of(render_frame);
        const std::size_t channels = layer == Layer::direction ? 3 : 1;
        Picture picture{frame.width, frame.height, static_cast<int>(channels), {}};
        picture.values.resize(channels * static_cast<std::size_t>(frame.width) *
                              static_cast<std::size_t>(frame.height));
        for_each_packet(frame.width, frame.height, [&](int left, int bottom) {
            SeenPacket seen;
            see_packet(frame.screen, left, bottom, seen);
            PacketHits hits;
            PacketShips of_ships;
            if (layer == Layer::distance || layer == Layer::object || ships) {
                scenery_.first(frame.eye, seen.direction, hits);
            }
            if (ships) {
                ships->first(seen.direction, hits.distance, of_ships);
            }
            for_each_lane(frame, left, bottom, true, [&](int lane, std::size_t pixel) {
                float* const value = &picture.values[channels * pixel];
                if (layer == Layer::direction) {
                    value[0] = seen.direction.x[lane];
                    value[1] = seen.direction.y[lane];
                    value[2] = seen.direction.z[lane];
                } else if (layer == Layer::doppler) {
                    *value = has(of_ships.seen, lane) ? of_ships.wavelength_ratio[lane] : seen.wavelength_ratio[lane];
                } else if (layer == Layer::distance) {
                    *value = has(of_ships.seen, lane) ? of_ships.distance[lane] : hits.distance[lane];
                } else if (has(of_ships.seen, lane)) {
                    *value = of_ships.object[lane];
                } else {
                    *value =
                        hits.instance[lane] == PacketHits::nothing ? -1.0f : static_cast<float>(hits.instance[lane]);
                }
            });
        });
        return picture;
    }

    /// None where no ship is.
    std::optional<ShipHits> ships_of(const RenderFrame& frame) const {
        if (frame.moving.ships.empty()) {
            return std::nullopt;
        }
        return ShipHits(see_ships(frame, Surroundings(scene_), colour_.doppler()));
    }

    static void add_ship_light(const PacketShips& ships, float pre_exposure, Lanes3& light) {
        for (LaneMask rest = ships.seen; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            light.x[i] += pre_exposure * ships.radiance.x[i];
            light.y[i] += pre_exposure * ships.radiance.y[i];
            light.z[i] += pre_exposure * ships.radiance.z[i];
        }
    }

    /// Adds what a packet sees besides ships: scenery where it is found, the sky where nothing covers it, `sky` of both
    /// eyes' if there is one.
    void add_light(const FrameOfRays& frame, const SeenPacket& seen, const PacketHits& hits, LaneMask found,
                   LaneMask covered, const FrameColourTable& table, StereoShare* far, StereoShare::Sky* sky,
                   Lanes3& light) const {
        const PacketColours colours{table, places_of(table, seen.wavelength_ratio)};
        if (found != 0) {
            PacketRays rays;
            rays.origin = frame.eye;
            rays.direction = seen.direction;
            spread_of(seen, static_cast<float>(frame.focal_pixels), rays.spread);
            surfaces_.add_seen_light(rays, hits, found, colours, light);
        }
        if (sky != nullptr) {
            add_shared_sky(frame, seen, all_lanes & ~covered, colours, light, *far, *sky);
        } else if (covered != all_lanes) {
            add_sky_light(frame, seen, all_lanes & ~covered, colours, light);
        }
    }

    /// What D makes of light, over all that a view shows.
    FrameColourTable colours_of(const BoostedView& view, Mode mode, double pre_exposure) const {
        const RatioRange range = ratio_range(view, glm::dvec2(0.0), glm::dvec2(view.width, view.height));
        return frame_colour_table(colour_, mode, range.least, range.most, pre_exposure);
    }

    /// The same as add_sky_light; what the other eye has seen of it is taken over.
    void add_shared_sky(const FrameOfRays& frame, const SeenPacket& seen, LaneMask wanted, const PacketColours& colours,
                        Lanes3& light, StereoShare& share, StereoShare::Sky& sky) const {
        const LaneMask missing = wanted & ~sky.known;
        if (missing != 0) {
            Lanes3 fresh{};
            add_sky_light(frame, seen, missing, colours, fresh);
            add_lanes(fresh, missing, sky.light);
            sky.known |= missing;
        }
        add_lanes(sky.light, wanted, light);
        share.sky_cast.fetch_add(std::popcount(missing), std::memory_order_relaxed);
        share.sky_reused.fetch_add(std::popcount(wanted & ~missing), std::memory_order_relaxed);
    }

    /// Puts the wanted lanes of one into another, which has nothing there.
    static void add_lanes(const Lanes3& from, LaneMask wanted, Lanes3& to) {
        for (LaneMask rest = wanted; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            to.x[i] = from.x[i];
            to.y[i] = from.y[i];
            to.z[i] = from.z[i];
        }
    }

    /// Adds the sky as the moving eye sees it to the wanted lanes.
    void add_sky_light(const FrameOfRays& frame, const SeenPacket& seen, LaneMask wanted, const PacketColours& colours,
                       Lanes3& light) const {
        Lanes3 at_rest{};
        sky_light(frame, seen, wanted, at_rest);
        add_radiance(colours, 0, at_rest, light);
        if (const auto& microwaves = colour_.spectra().microwave_background()) {
            Lanes share;
            for (int i = 0; i < lane_count; ++i) {
                share[i] = has(wanted, i) ? 1.0f : 0.0f;
            }
            add_term(colours, colours.table.first_layer[*microwaves], 0, share, light);
        }
    }

    /// The sky at rest into the wanted lanes.
    void sky_light(const FrameOfRays& frame, const SeenPacket& seen, LaneMask wanted, Lanes3& light) const {
        if (!sky_) {
            add_gradient_sky(scene_.gradient_sky, seen, wanted, light);
            return;
        }
        Lanes levels;
        sky_levels(sky_->texels_per_pixel(frame.focal_pixels), seen, levels);
        for (LaneMask rest = wanted; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            const glm::vec3 radiance =
                sky_->radiance({seen.direction.x[i], seen.direction.y[i], seen.direction.z[i]}, levels[i]);
            light.x[i] = radiance.x;
            light.y[i] = radiance.y;
            light.z[i] = radiance.z;
        }
    }

    static void store(const FrameOfRays& frame, int left, int bottom, LaneMask found, const Lanes3& light,
                      const std::span<glm::vec4>& pixels) {
        for_each_lane(frame, left, bottom, true, [&](int lane, std::size_t pixel) {
            pixels[pixel] = {light.x[lane], light.y[lane], light.z[lane], has(found, lane) ? 0.0f : 1.0f};
        });
    }

    static void store(const FrameOfRays& /*frame*/, int left, int bottom, LaneMask found, const Lanes3& light,
                      LightPackets& packets) {
        const std::size_t packet = packets.packet(left, bottom);
        packets.light[packet] = light;
        packets.sky[packet] = all_lanes & ~found;
    }

    const content::SceneDesc& scene_;
    const SceneColour& colour_;
    SceneryHits scenery_;
    SurfaceLight surfaces_;
    StarSheet stars_;
    std::optional<SkyMap> sky_;
};

RayCaster::RayCaster(const content::SceneDesc& scene, const SceneColour& colour)
    : implementation_(std::make_unique<Implementation>(scene, colour)) {}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;

void RayCaster::light(const RenderFrame& frame, double pre_exposure, std::span<glm::vec4> pixels) const {
    implementation_->light(frame, pre_exposure, pixels);
}

void RayCaster::light(const RenderFrame& frame, double pre_exposure, LightPackets& packets, StereoShare* share,
                      std::span<float> depths) const {
    packets.resize(frame.eye.width, frame.eye.height);
    implementation_->light(frame, pre_exposure, packets, {}, share, depths);
}

void RayCaster::add_stars(const RenderFrame& frame, double pre_exposure, LightPackets& packets,
                          StereoShare* share) const {
    implementation_->add_stars(frame, pre_exposure, packets, share);
}

Picture RayCaster::picture(const RenderFrame& frame, int samples_per_side) const {
    return implementation_->picture(frame, samples_per_side);
}

} // namespace render
