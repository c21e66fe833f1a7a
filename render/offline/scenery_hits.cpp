#include "render/offline/scenery_hits.h"

#include "render/offline/embree.h"
#include "render/offline/surface.h"
#include "render/raycast/packet_query.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace render {
namespace {

RTCRay ray_from(const glm::dvec3& origin, const glm::dvec3& direction) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(origin.x);
    ray.org_y = static_cast<float>(origin.y);
    ray.org_z = static_cast<float>(origin.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = 0.0f;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    return ray;
}

bool is_cut_out(const content::SceneDesc& scene, const RTCFilterFunctionNArguments& arguments, unsigned lane) {
    const double u = RTCHitN_u(arguments.hit, arguments.N, lane);
    const double v = RTCHitN_v(arguments.hit, arguments.N, lane);
    const TriangleView triangle(scene, RTCHitN_geomID(arguments.hit, arguments.N, lane),
                                RTCHitN_primID(arguments.hit, arguments.N, lane));
    return triangle.material.alpha_mode == content::AlphaMode::mask &&
           opacity(scene, triangle, {1.0 - u - v, u, v}) < triangle.material.alpha_cutoff;
}

// Whether the ray meets the back of a triangle that has none to show.
bool is_hidden_back(const RTCFilterFunctionNArguments& arguments, unsigned lane, bool mirrored) {
    const float along_normal =
        RTCHitN_Ng_x(arguments.hit, arguments.N, lane) * RTCRayN_dir_x(arguments.ray, arguments.N, lane) +
        RTCHitN_Ng_y(arguments.hit, arguments.N, lane) * RTCRayN_dir_y(arguments.ray, arguments.N, lane) +
        RTCHitN_Ng_z(arguments.hit, arguments.N, lane) * RTCRayN_dir_z(arguments.ray, arguments.N, lane);
    return mirrored ? along_normal < 0.0f : along_normal > 0.0f;
}

// Embree asks these for each hit it is about to take, for all rays of a packet at once; a geometry has one of them.
template <bool mirrored>
void pass_backs(const RTCFilterFunctionNArguments* arguments) {
    for (unsigned lane = 0; lane < arguments->N; ++lane) {
        if (is_hidden_back(*arguments, lane, mirrored)) {
            arguments->valid[lane] = 0;
        }
    }
}
void pass_cut_outs(const RTCFilterFunctionNArguments* arguments) {
    const auto& scene = *static_cast<const content::SceneDesc*>(arguments->geometryUserPtr);
    for (unsigned lane = 0; lane < arguments->N; ++lane) {
        if (arguments->valid[lane] != 0 && is_cut_out(scene, *arguments, lane)) {
            arguments->valid[lane] = 0;
        }
    }
}
template <bool mirrored>
void pass_backs_and_cut_outs(const RTCFilterFunctionNArguments* arguments) {
    pass_backs<mirrored>(arguments);
    pass_cut_outs(arguments);
}

RTCFilterFunctionN filter_of(const content::Material& material, bool mirrored) {
    const bool masked = material.alpha_mode == content::AlphaMode::mask;
    if (material.double_sided) {
        return masked ? &pass_cut_outs : nullptr;
    }
    if (masked) {
        return mirrored ? &pass_backs_and_cut_outs<true> : &pass_backs_and_cut_outs<false>;
    }
    return mirrored ? &pass_backs<true> : &pass_backs<false>;
}

} // namespace

class SceneryHits::Embree {
  public:
    Embree(const content::SceneDesc& scene, Edges edges)
        : scene_(scene), device_(rtcNewDevice(nullptr)), tree_(rtcNewScene(device_.get())) {
        rtcSetSceneFlags(tree_.get(), edges == Edges::watertight ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
        for (std::size_t i = 0; i < scene.instances.size(); ++i) {
            attach(i);
        }
        rtcCommitScene(tree_.get());
        if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) {
            throw sim::BadInput(scene.name, "scenery", "", "too large for the ray tracer's memory");
        }
    }

    std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const {
        RTCRayHit query{};
        query.ray = ray_from(origin, direction);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        intersect(tree_.get(), query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
            return std::nullopt;
        }
        return refined(query.hit.geomID, query.hit.primID, origin, direction);
    }

    bool blocked(const glm::dvec3& origin, const glm::dvec3& direction, double distance) const {
        RTCRay ray = ray_from(origin, direction);
        ray.tfar = static_cast<float>(distance);
        return occluded(tree_.get(), ray);
    }

    void first(const glm::vec3& origin, const Lanes3& directions, PacketHits& hits) const {
        Lanes unlimited;
        for (int i = 0; i < lane_count; ++i) {
            unlimited[i] = std::numeric_limits<float>::infinity();
        }
        RTCRayHit16 query = rays_from(origin, directions, unlimited);
        intersect(tree_.get(), all_valid.lanes.data(), query);
        for (int i = 0; i < lane_count; ++i) {
            hits.distance[i] = query.ray.tfar[i];
            hits.normal.x[i] = query.hit.Ng_x[i];
            hits.normal.y[i] = query.hit.Ng_y[i];
            hits.normal.z[i] = query.hit.Ng_z[i];
            hits.u[i] = query.hit.u[i];
            hits.v[i] = query.hit.v[i];
            hits.triangle[i] = query.hit.primID[i];
            hits.instance[i] = query.hit.geomID[i];
        }
    }

    LaneMask blocked(const Lanes3& origins, const glm::vec3& direction, LaneMask wanted) const {
        RTCRay16 query;
        for (int i = 0; i < lane_count; ++i) {
            query.dir_x[i] = direction.x;
            query.dir_y[i] = direction.y;
            query.dir_z[i] = direction.z;
            query.tfar[i] = std::numeric_limits<float>::infinity();
        }
        return blocked(query, origins, wanted);
    }

    LaneMask blocked_towards(const Lanes3& origins, const glm::vec3& point, float clearance, LaneMask wanted) const {
        RTCRay16 query;
        LaneMask far = 0;
        for (int i = 0; i < lane_count; ++i) {
            const glm::vec3 offset = point - glm::vec3(origins.x[i], origins.y[i], origins.z[i]);
            const float distance = std::sqrt(glm::dot(offset, offset));
            const glm::vec3 direction = offset / (distance > 0.0f ? distance : 1.0f);
            query.dir_x[i] = direction.x;
            query.dir_y[i] = direction.y;
            query.dir_z[i] = direction.z;
            query.tfar[i] = distance - clearance;
            far |= distance > clearance ? 1u << static_cast<unsigned>(i) : 0u;
        }
        return blocked(query, origins, wanted & far);
    }

  private:
    /// Which of the wanted rays meet something before their ends; their directions and ends are in the query already.
    LaneMask blocked(RTCRay16& query, const Lanes3& origins, LaneMask wanted) const {
        alignas(64) std::array<int, lane_count> valid;
        for (int i = 0; i < lane_count; ++i) {
            valid[static_cast<std::size_t>(i)] = has(wanted, i) ? -1 : 0;
            query.org_x[i] = origins.x[i];
            query.org_y[i] = origins.y[i];
            query.org_z[i] = origins.z[i];
            query.tnear[i] = 0.0f;
            query.time[i] = 0.0f;
            query.mask[i] = ~0u;
            query.flags[i] = 0;
        }
        occlude(tree_.get(), valid.data(), query);
        LaneMask found = 0;
        for (int i = 0; i < lane_count; ++i) {
            found |= query.tfar[i] < 0.0f ? 1u << static_cast<unsigned>(i) : 0u;
        }
        return found & wanted;
    }

    void attach(std::size_t index) {
        const content::Instance& instance = scene_.instances[index];
        const content::Mesh& mesh = scene_.meshes[instance.mesh];
        const GeometryHandle geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0,
                                                                            RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                                                                            mesh.indices.size() / 3));
        if (positions == nullptr || indices == nullptr) {
            throw sim::BadInput(scene_.name, "mesh", mesh.name, "too large for the ray tracer's memory");
        }
        const glm::dmat4 world_from_mesh(instance.world_from_mesh);
        for (const content::Vertex& vertex : mesh.vertices) {
            const glm::dvec4 world = world_from_mesh * glm::dvec4(glm::dvec3(vertex.position), 1.0);
            for (int axis = 0; axis < 3; ++axis) {
                *positions++ = static_cast<float>(world[axis]);
            }
        }
        std::copy_n(mesh.indices.begin(), mesh.indices.size() / 3 * 3, indices);
        const content::Material& material = scene_.materials[mesh.material];
        const bool mirrored = glm::determinant(glm::mat3(instance.world_from_mesh)) < 0.0f;
        // Embree wants a mutable pointer and hands it back unchanged.
        rtcSetGeometryUserData(geometry.get(), const_cast<content::SceneDesc*>(&scene_));
        rtcSetGeometryIntersectFilterFunction(geometry.get(), filter_of(material, mirrored));
        if (material.alpha_mode == content::AlphaMode::mask) {
            rtcSetGeometryOccludedFilterFunction(geometry.get(), &pass_cut_outs);
        }
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(tree_.get(), geometry.get(), static_cast<unsigned>(index));
    }

    // The plane's equation solved again in double, with the vertices as the scene has them.
    SurfaceHit refined(std::size_t instance, std::uint32_t primitive, const glm::dvec3& origin,
                       const glm::dvec3& direction) const {
        const TriangleView triangle(scene_, instance, primitive);
        const glm::dvec3 first = triangle.world_position(0);
        const glm::dvec3 along_u = triangle.world_position(1) - first;
        const glm::dvec3 along_v = triangle.world_position(2) - first;
        const glm::dvec3 area = glm::cross(along_u, along_v);
        const glm::dvec3 towards = first - origin;
        const double scale = 1.0 / glm::dot(area, direction);
        const glm::dvec3 moment = glm::cross(direction, towards);
        SurfaceHit hit;
        hit.instance = instance;
        hit.triangle = primitive;
        hit.distance = glm::dot(area, towards) * scale;
        hit.position = origin + hit.distance * direction;
        hit.facing = (scale < 0.0 ? 1.0 : -1.0) * glm::normalize(area);
        const double u = -glm::dot(along_v, moment) * scale;
        const double v = glm::dot(along_u, moment) * scale;
        hit.barycentric = {1.0 - u - v, u, v};
        return hit;
    }

    const content::SceneDesc& scene_;
    DeviceHandle device_;
    SceneHandle tree_;
};

SceneryHits::SceneryHits(const content::SceneDesc& scene, Edges edges)
    : embree_(std::make_unique<Embree>(scene, edges)) {}
SceneryHits::~SceneryHits() = default;
SceneryHits::SceneryHits(SceneryHits&&) noexcept = default;
SceneryHits& SceneryHits::operator=(SceneryHits&&) noexcept = default;

std::optional<SurfaceHit> SceneryHits::first(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return embree_->first(origin, direction);
}

bool SceneryHits::blocked(const glm::dvec3& origin, const glm::dvec3& direction, double distance) const {
    return embree_->blocked(origin, direction, distance);
}

void SceneryHits::first(const glm::vec3& origin, const Lanes3& directions, PacketHits& hits) const {
    embree_->first(origin, directions, hits);
}

LaneMask SceneryHits::blocked(const Lanes3& origins, const glm::vec3& direction, LaneMask wanted) const {
    return embree_->blocked(origins, direction, wanted);
}

LaneMask SceneryHits::blocked_towards(const Lanes3& origins, const glm::vec3& point, float clearance,
                                      LaneMask wanted) const {
    return embree_->blocked_towards(origins, point, clearance, wanted);
}

} // namespace render
