#include "render/raycast/ship_hits.h"
#include "render/raycast/packet_query.h"

#include "render/offline/embree.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace render {

class ShipHits::Embree {
  public:
    explicit Embree(std::vector<SeenShip> ships)
        : ships_(std::move(ships)), device_(rtcNewDevice(nullptr)), tree_(rtcNewScene(device_.get())) {
        for (std::size_t i = 0; i < ships_.size(); ++i) {
            attach(i);
        }
        rtcCommitScene(tree_.get());
        if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) {
            throw sim::BadInput("ship", "", "", "too large for the ray tracer's memory");
        }
    }

    void first(const Lanes3& directions, const Lanes& limit, PacketShips& found) const {
        found.seen = 0;
        if (!near_any(directions)) {
            return;
        }
        RTCRayHit16 query = rays_from(glm::vec3(0.0f), directions, limit);
        intersect(tree_.get(), all_valid.lanes.data(), query);
        for (int i = 0; i < lane_count; ++i) {
            if (query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) {
                found.distance[i] = query.ray.tfar[i];
                take(query, i, found);
            }
        }
    }

  private:
    static void pass_backs(const RTCFilterFunctionNArguments* arguments) {
        for (unsigned lane = 0; lane < arguments->N; ++lane) {
            const float along =
                RTCHitN_Ng_x(arguments->hit, arguments->N, lane) * RTCRayN_dir_x(arguments->ray, arguments->N, lane) +
                RTCHitN_Ng_y(arguments->hit, arguments->N, lane) * RTCRayN_dir_y(arguments->ray, arguments->N, lane) +
                RTCHitN_Ng_z(arguments->hit, arguments->N, lane) * RTCRayN_dir_z(arguments->ray, arguments->N, lane);
            if (along > 0.0f) {
                arguments->valid[lane] = 0;
            }
        }
    }

    void attach(std::size_t index) {
        const SeenShip& ship = ships_[index];
        const GeometryHandle geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), ship.vertices.size()));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0,
                                                                            RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                                                                            ship.indices.size() / 3));
        if (positions == nullptr || indices == nullptr) {
            throw sim::BadInput("ship", "", "", "too large for the ray tracer's memory");
        }
        for (const SeenShip::Vertex& vertex : ship.vertices) {
            for (int axis = 0; axis < 3; ++axis) {
                *positions++ = vertex.from_eye[axis];
            }
        }
        std::copy(ship.indices.begin(), ship.indices.end(), indices);
        rtcSetGeometryIntersectFilterFunction(geometry.get(), &pass_backs);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(tree_.get(), geometry.get(), static_cast<unsigned>(index));
    }

    /// Whether a ray of the packet comes near a ship: most packets end here.
    bool near_any(const Lanes3& directions) const {
        for (const SeenShip& ship : ships_) {
            const float distance2 = glm::dot(ship.centre, ship.centre);
            const float radius2 = ship.radius * ship.radius;
            if (distance2 <= radius2) {
                return true;
            }
            const float least = std::sqrt(distance2 - radius2); // cosine times distance at the rim
            for (int i = 0; i < lane_count; ++i) {
                if (directions.x[i] * ship.centre.x + directions.y[i] * ship.centre.y +
                        directions.z[i] * ship.centre.z >
                    0.99999f * least) {
                    return true;
                }
            }
        }
        return false;
    }

    void take(const RTCRayHit16& query, int lane, PacketShips& found) const {
        const SeenShip& ship = ships_[query.hit.geomID[lane]];
        const std::uint32_t* corner = &ship.indices[3 * std::size_t{query.hit.primID[lane]}];
        const float u = query.hit.u[lane];
        const float v = query.hit.v[lane];
        const std::array<const SeenShip::Vertex*, 3> vertices{&ship.vertices[corner[0]], &ship.vertices[corner[1]],
                                                              &ship.vertices[corner[2]]};
        const glm::vec3 radiance =
            (1.0f - u - v) * vertices[0]->radiance + u * vertices[1]->radiance + v * vertices[2]->radiance;
        found.radiance.x[lane] = radiance.x;
        found.radiance.y[lane] = radiance.y;
        found.radiance.z[lane] = radiance.z;
        found.wavelength_ratio[lane] = (1.0f - u - v) * vertices[0]->wavelength_ratio +
                                       u * vertices[1]->wavelength_ratio + v * vertices[2]->wavelength_ratio;
        found.object[lane] = vertices[0]->object;
        found.seen |= LaneMask{1} << static_cast<unsigned>(lane);
    }

    std::vector<SeenShip> ships_;
    DeviceHandle device_;
    SceneHandle tree_;
};

ShipHits::ShipHits(std::vector<SeenShip> ships) : embree_(std::make_unique<Embree>(std::move(ships))) {}
ShipHits::~ShipHits() = default;
ShipHits::ShipHits(ShipHits&&) noexcept = default;
ShipHits& ShipHits::operator=(ShipHits&&) noexcept = default;

void ShipHits::first(const Lanes3& directions, const Lanes& limit, PacketShips& found) const {
    embree_->first(directions, limit, found);
}

} // namespace render
