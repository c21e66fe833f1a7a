#include "render/offline/traced/hole_rays.h"

#include <cmath>

namespace render {
namespace {

/// The part of a piece of ray within a distance; `end`: the share of the piece at which it leaves it. Nothing where
/// none is within.
struct NearPart {
    RestCurve curve;
    double end;
};

std::optional<NearPart> part_within(const RestCurve& curve, double distance) {
    const double least_weight = 1.0 / distance; // w = u = 1/r
    if (!(curve[0].w > least_weight)) {
        return std::nullopt;
    }
    if (curve[3].w > least_weight) {
        return NearPart{curve, 1.0};
    }
    // Where it is cut beyond matters little.
    const RayCurve weight = RayCurve::timeless(curve);
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 10; ++i) {
        const double middle = 0.5 * (low + high);
        (weight.weight(middle) > 0.5 * least_weight ? low : high) = middle;
    }
    return NearPart{parts(curve, low).first, low};
}

/// nu emitted by a body at rest there over nu = E at infinity: 1/sqrt(-g_tt). NaN where nothing rests.
double frequency_at_rest(const sim::AnySpacetime& spacetime, const glm::dvec3& place) {
    return std::visit(
        [&](const auto& chosen) {
            return 1.0 / std::sqrt(-chosen.metric(sim::Components<double>{0.0, place.x, place.y, place.z})(0, 0));
        },
        spacetime);
}

} // namespace

HoleRays::HoleRays(const sim::AnySpacetime& spacetime, const sim::MinoEye& eye, const sim::RaySettings& settings,
                   const TracedMatter& matter, std::shared_ptr<const RaySource> with_time)
    : spacetime_(spacetime), eye_(eye), settings_(settings), matter_(matter),
      watch_(eye, {matter.objects->bounds(), false}), with_time_(std::move(with_time)) {}

bool HoleRays::needs_time(const sim::MinoHole& hole, const sim::RaySettings& settings, const TracedMatter& matter) {
    return !matter.objects->moving_bounds().empty() || (hole.spin != 0.0 && !settings.nothing_near_horizon);
}

HoleRays::Step HoleRays::meet(const sim::MinoSegment& segment, double& share, TracedRay& ray) const {
    if (eye_.hole.spin != 0.0 && !(segment.to.y.u * eye_.hole.radii.horizon < 1.0)) {
        return with_time_ ? Step::needs_time : Step::free;
    }
    const std::optional<NearPart> near = part_within(segment.bezier(), settings_.escape_radius);
    if (!near) {
        return Step::free;
    }
    const RayCurve curve = RayCurve::timeless(near->curve);
    if (matter_.objects->may_meet_moving(curve)) {
        return Step::needs_time;
    }
    const std::optional<ObjectHit> hit = matter_.objects->first(curve);
    if (!hit) {
        return Step::free;
    }
    // The ray's own place where the cubic has it; along the way the two may run differently.
    share = hit->s * near->end;
    const glm::dvec4 wanted = curve.at(hit->s);
    const glm::dvec4 slope = curve.slope(hit->s) / near->end;
    for (int i = 0; i < 3; ++i) {
        ray.direction = segment.place(share);
        const glm::dvec4 missing = wanted - glm::dvec4(0.0, ray.direction);
        share = glm::clamp(share + glm::dot(missing, slope) / glm::dot(slope, slope), 0.0, 1.0);
    }
    ray.fate = RayFate::object;
    ray.object = static_cast<std::uint32_t>(hit->object);
    ray.wavelength_ratio = segment.ray.energy * frequency_at_rest(spacetime_, ray.direction);
    if (ray.wavelength_ratio > 0.0) {
        ray.light = light_of(*hit, matter_, ray.wavelength_ratio);
    } else {
        ray.fate = RayFate::not_finite;
    }
    return Step::met;
}

std::vector<std::size_t> HoleRays::trace_with(double step, std::span<const glm::dvec3> directions,
                                              std::span<TracedRay> rays) const {
    std::vector<sim::SkyRay> found(directions.size());
    std::vector<sim::PlaneCrossings> crossings(matter_.disk != nullptr ? directions.size() : 0);
    std::vector<TracedRay> met(directions.size());
    std::vector<std::size_t> left;
    sim::RaySettings settings = settings_;
    settings.step = step;
    const auto visit = [&](std::size_t ray, const sim::MinoSegment& segment) {
        constexpr double goes_on = 2.0;
        double share = 0.0;
        const Step what = meet(segment, share, met[ray]);
        if (what == Step::needs_time) {
            left.push_back(ray);
        }
        return what == Step::free ? goes_on : share;
    };
    sim::trace_mino_sky(eye_, directions, settings, found, crossings, watch_, visit);
    for (std::size_t i = 0; i < found.size(); ++i) {
        rays[i] = traced_ray(found[i].outcome, found[i].infinity, found[i].steps);
        if (found[i].outcome == sim::RayOutcome::hit_object) {
            met[i].steps = rays[i].steps;
            rays[i] = met[i];
        }
        if (matter_.disk != nullptr) {
            look_for_disk(*matter_.disk, crossings[i], rays[i]);
        }
    }
    return left;
}

void HoleRays::trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays, std::size_t error_every) const {
    const std::vector<std::size_t> left = trace_with(settings_.step, directions, rays);
    estimate_errors(directions, rays, error_every, [&](std::span<const glm::dvec3> judged, std::span<TracedRay> into) {
        trace_with(2.0 * settings_.step, judged, into);
    });
    if (left.empty()) {
        return;
    }
    std::vector<glm::dvec3> directions_left;
    for (const std::size_t ray : left) {
        directions_left.push_back(directions[ray]);
    }
    std::vector<TracedRay> timed(left.size());
    with_time_->trace(directions_left, timed, error_every > 0 ? 1 : 0);
    for (std::size_t i = 0; i < left.size(); ++i) {
        rays[left[i]] = timed[i];
        if (error_every == 0 || left[i] % error_every != 0) {
            rays[left[i]].error = 0.0f;
        }
    }
}

} // namespace render
