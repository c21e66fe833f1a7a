#include "render/offline/scenery_hits.h"

#include "render/offline/surface.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <limits>
#include <vector>

namespace render {
namespace {

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct GeometryRelease {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using DeviceHandle = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using SceneHandle = std::unique_ptr<RTCSceneTy, SceneRelease>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, GeometryRelease>;

// Embree 3 (Debian 12) wants a context with each query, Embree 4 (Debian 13) none.
void intersect(RTCScene tree, RTCRayHit& query) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(tree, &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(tree, &context, &query);
#endif
}

bool occluded(RTCScene tree, RTCRay ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(tree, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(tree, &context, &ray);
#endif
    return ray.tfar < 0.0f;
}

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

bool is_cut_out(const content::SceneDesc& scene, const RTCFilterFunctionNArguments& arguments) {
    const double u = RTCHitN_u(arguments.hit, arguments.N, 0);
    const double v = RTCHitN_v(arguments.hit, arguments.N, 0);
    const TriangleView triangle(scene, RTCHitN_geomID(arguments.hit, arguments.N, 0),
                                RTCHitN_primID(arguments.hit, arguments.N, 0));
    return triangle.material.alpha_mode == content::AlphaMode::mask &&
           base_colour(scene, triangle, {1.0 - u - v, u, v}).a < triangle.material.alpha_cutoff;
}

// Whether the ray meets the back of a triangle that has none to show.
bool is_hidden_back(const content::SceneDesc& scene, const RTCFilterFunctionNArguments& arguments) {
    const unsigned geometry = RTCHitN_geomID(arguments.hit, arguments.N, 0);
    const content::Instance& instance = scene.instances[geometry];
    if (scene.materials[scene.meshes[instance.mesh].material].double_sided) {
        return false;
    }
    const float along_normal =
        RTCHitN_Ng_x(arguments.hit, arguments.N, 0) * RTCRayN_dir_x(arguments.ray, arguments.N, 0) +
        RTCHitN_Ng_y(arguments.hit, arguments.N, 0) * RTCRayN_dir_y(arguments.ray, arguments.N, 0) +
        RTCHitN_Ng_z(arguments.hit, arguments.N, 0) * RTCRayN_dir_z(arguments.ray, arguments.N, 0);
    const bool mirrored = glm::determinant(glm::mat3(instance.world_from_mesh)) < 0.0f;
    return mirrored ? along_normal < 0.0f : along_normal > 0.0f;
}

// Embree asks these for each hit it is about to take. Its packets hold one ray here.
void pass_unseen(const RTCFilterFunctionNArguments* arguments) {
    const auto& scene = *static_cast<const content::SceneDesc*>(arguments->geometryUserPtr);
    if (arguments->valid[0] != 0 && (is_hidden_back(scene, *arguments) || is_cut_out(scene, *arguments))) {
        arguments->valid[0] = 0;
    }
}
void pass_cut_outs(const RTCFilterFunctionNArguments* arguments) {
    const auto& scene = *static_cast<const content::SceneDesc*>(arguments->geometryUserPtr);
    if (arguments->valid[0] != 0 && is_cut_out(scene, *arguments)) {
        arguments->valid[0] = 0;
    }
}

} // namespace

class SceneryHits::Embree {
  public:
    explicit Embree(const content::SceneDesc& scene)
        : scene_(scene), device_(rtcNewDevice(nullptr)), tree_(rtcNewScene(device_.get())) {
        rtcSetSceneFlags(tree_.get(), RTC_SCENE_FLAG_ROBUST);
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

    bool blocked(const glm::dvec3& origin, const glm::dvec3& direction) const {
        return occluded(tree_.get(), ray_from(origin, direction));
    }

  private:
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
        const bool masked = material.alpha_mode == content::AlphaMode::mask;
        // Embree wants a mutable pointer and hands it back unchanged.
        rtcSetGeometryUserData(geometry.get(), const_cast<content::SceneDesc*>(&scene_));
        if (masked || !material.double_sided) {
            rtcSetGeometryIntersectFilterFunction(geometry.get(), &pass_unseen);
        }
        if (masked) {
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

SceneryHits::SceneryHits(const content::SceneDesc& scene) : embree_(std::make_unique<Embree>(scene)) {}
SceneryHits::~SceneryHits() = default;
SceneryHits::SceneryHits(SceneryHits&&) noexcept = default;
SceneryHits& SceneryHits::operator=(SceneryHits&&) noexcept = default;

std::optional<SurfaceHit> SceneryHits::first(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return embree_->first(origin, direction);
}

bool SceneryHits::blocked(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return embree_->blocked(origin, direction);
}

} // namespace render
