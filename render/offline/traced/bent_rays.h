#pragma once

#include "render/offline/traced/disk_light.h"
#include "render/offline/traced/lane_rays.h"
#include "render/offline/traced/traced_objects.h"
#include "render/offline/traced/traced_ray.h"
#include "sim/spacetime/sky_rays.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <optional>
#include <vector>

namespace render {

/// What rays can meet on their way; null: nothing of the kind.
struct TracedMatter {
    const TracedObjects* objects = nullptr;
    const DiskLight* disk = nullptr;
    const TracedColour* colour = nullptr;
};

/// Radiance of what was hit as the eye sees it at D.
inline glm::dvec3 light_of(const ObjectHit& hit, const TracedMatter& matter, double wavelength_ratio) {
    glm::dvec3 light = matter.objects->seen(hit, wavelength_ratio);
    if (hit.temperature > 0.0) {
        light += matter.colour->black_body(hit.temperature, wavelength_ratio);
    }
    return light;
}

inline glm::dvec4 to_vector(const sim::Components<double>& c) {
    return {c.t, c.x, c.y, c.z};
}
inline sim::Components<double> to_components(const glm::dvec4& v) {
    return {v.x, v.y, v.z, v.w};
}

/// Light on the way from an event of a body that moves with coordinate velocity w = (1, v): nu there over nu at the
/// eye, -p.u with u = w/sqrt(-w.w). NaN where nothing can move so.
template <class Spacetime>
double emitted_frequency(const Spacetime& spacetime, const sim::GeodesicState<double>& photon,
                         const glm::dvec3& velocity) {
    const sim::Components<double> w{1.0, velocity.x, velocity.y, velocity.z};
    const double norm2 = -sim::contract(w, spacetime.metric(photon.position) * w);
    return -sim::contract(w, photon.momentum) / std::sqrt(norm2);
}

/// Looks for matter along one ray. The nearest event is found on the cubic between two steps; one step of the
/// integrator to just there then gives place and momentum to the ray's own accuracy.
template <class Spacetime>
class MatterVisitor {
  public:
    MatterVisitor(const Spacetime& spacetime, const TracedMatter& matter, TracedRay& ray)
        : spacetime_(spacetime), matter_(matter), ray_(ray) {}

    sim::Visit operator()(const sim::RaySegment& segment) {
        const RayCurve curve =
            RayCurve::between(to_vector(segment.from.position), segment.length * to_vector(segment.from_tangent),
                              to_vector(segment.to.position), segment.length * to_vector(segment.to_tangent));
        std::optional<ObjectHit> object;
        if (matter_.objects != nullptr) {
            object = matter_.objects->first(curve);
        }
        const std::optional<double> disk = disk_crossing(curve);
        if (disk && (!object || *disk < object->s)) {
            take_disk(photon_at(segment, curve, *disk));
        } else if (object) {
            take_object(photon_at(segment, curve, object->s), *object);
        } else {
            return sim::Visit::go_on;
        }
        return sim::Visit::stop;
    }

  private:
    // The ray's own state where the cubic has it. Over a long step the two run differently along the same way, so the
    // share of the step is put right by what is missing along it.
    sim::GeodesicState<double> photon_at(const sim::RaySegment& segment, const RayCurve& curve, double s) const {
        if (segment.straight) {
            return {segment.at(s), segment.from.momentum};
        }
        const glm::dvec4 wanted = curve.at(s);
        const glm::dvec4 slope = curve.slope(s);
        sim::GeodesicState<double> photon = sim::geodesic_step(spacetime_, segment.from, -s * segment.length);
        for (int i = 0; i < 3; ++i) {
            const double missing = glm::dot(wanted - to_vector(photon.position), slope) / glm::dot(slope, slope);
            s = glm::clamp(s + missing, 0.0, 1.5);
            photon = sim::geodesic_step(spacetime_, segment.from, -s * segment.length);
        }
        return photon;
    }

    // Where the cubic meets the plane z = 0 within the disk.
    std::optional<double> disk_crossing(const RayCurve& curve) const {
        if constexpr (requires { spacetime_.radii; }) {
            if (matter_.disk == nullptr || !((curve.points[0].w > 0.0) != (curve.points[3].w > 0.0))) {
                return std::nullopt;
            }
            double low = 0.0;
            double high = 1.0;
            const bool starts_above = curve.points[0].w > 0.0;
            for (int i = 0; i < 50; ++i) {
                const double middle = 0.5 * (low + high);
                ((curve.at(middle).w > 0.0) == starts_above ? low : high) = middle;
            }
            return matter_.disk->reaches(kerr_radius(to_components(curve.at(high)))) ? std::optional(high)
                                                                                     : std::nullopt;
        } else {
            return std::nullopt;
        }
    }

    double kerr_radius(const sim::Components<double>& x) const { return spacetime_.remoteness(x); }

    void take_disk(const sim::GeodesicState<double>& photon) {
        const auto& x = photon.position;
        const double r = kerr_radius(x);
        const double turning = matter_.disk->angular_velocity(r);
        ray_.fate = RayFate::disk;
        ray_.wavelength_ratio = emitted_frequency(spacetime_, photon, {-turning * x.y, turning * x.x, 0.0});
        const double azimuth = boyer_lindquist_azimuth(x, r);
        ray_.direction = r * glm::dvec3(std::cos(azimuth), std::sin(azimuth), 0.0);
        ray_.light = matter_.disk->seen(r, azimuth, ray_.wavelength_ratio);
    }

    // x + i y = (r + i a) exp(i phi + i a/(r_+ - r_-) ln((r - r_+)/(r - r_-))) in the plane z = 0
    // (sim/spacetime/kerr.h).
    double boyer_lindquist_azimuth(const sim::Components<double>& x, double r) const {
        double azimuth = std::atan2(x.y, x.x);
        if constexpr (requires { spacetime_.spin; }) {
            const double a = spacetime_.spin;
            const double outer = spacetime_.radii.horizon;
            const double inner = 2.0 * spacetime_.mass - outer;
            azimuth -= std::atan2(a, r) + a / (outer - inner) * std::log((r - outer) / (r - inner));
        }
        return azimuth;
    }

    void take_object(const sim::GeodesicState<double>& photon, const ObjectHit& hit) {
        ray_.fate = RayFate::object;
        ray_.direction = sim::space(photon.position);
        ray_.object = static_cast<std::uint32_t>(hit.object);
        ray_.wavelength_ratio = emitted_frequency(spacetime_, photon, hit.coordinate_velocity);
        if (!(ray_.wavelength_ratio > 0.0)) {
            return; // BentRays says so
        }
        ray_.light = light_of(hit, matter_, ray_.wavelength_ratio);
    }

    const Spacetime& spacetime_;
    const TracedMatter& matter_;
    TracedRay& ray_;
};

/// Rays through any spacetime (Hamilton's equations by RK4) on lanes, with a close look at the steps that may meet
/// matter.
template <class Spacetime>
class BentRays : public RaySource {
  public:
    /// `matter` has objects or a disk; its colour is set.
    BentRays(const Spacetime& spacetime, const sim::Components<double>& eye, const sim::Tetrad& tetrad,
             const sim::RaySettings& settings, const TracedMatter& matter)
        : spacetime_(spacetime), eye_(eye), tetrad_(tetrad), settings_(settings), matter_(matter) {
        if (matter.objects != nullptr) {
            places_.balls = matter.objects->bounds();
        }
        places_.plane = matter.disk != nullptr;
    }

    void trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
               std::size_t error_every) const override {
        trace_with(settings_, directions, rays);
        sim::RaySettings doubled = settings_;
        doubled.step *= 2.0;
        estimate_errors(
            directions, rays, error_every,
            [&](std::span<const glm::dvec3> judged, std::span<TracedRay> into) { trace_with(doubled, judged, into); });
    }

  private:
    void trace_with(const sim::RaySettings& settings, std::span<const glm::dvec3> directions,
                    std::span<TracedRay> rays) const {
        std::vector<sim::SkyRay> found(directions.size());
        const auto& spacetime = std::get<Spacetime>(spacetime_);
        const auto visit = [&](std::size_t ray, const sim::RaySegment& segment) {
            return MatterVisitor(spacetime, matter_, rays[ray])(segment);
        };
        if constexpr (requires { spacetime.flat_radius(settings.tail_error); }) {
            trace_through_flat(directions, settings, found, visit);
        } else {
            sim::trace_sky(spacetime_, eye_, tetrad_, directions, settings, found, places_, visit);
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (found[i].outcome != sim::RayOutcome::hit_object) {
                rays[i] = traced_ray(found[i].outcome, found[i].infinity, found[i].steps);
                continue;
            }
            rays[i].steps = static_cast<std::int32_t>(found[i].steps);
            if (!(rays[i].wavelength_ratio > 0.0)) {
                rays[i].fate = RayFate::not_finite;
            }
        }
    }

    /// Where space is flat around the curved part, light goes straight, in one piece to it and in one away from it.
    template <class Visit>
    void trace_through_flat(std::span<const glm::dvec3> directions, const sim::RaySettings& settings,
                            std::span<sim::SkyRay> found, const Visit& visit) const {
        const auto& spacetime = std::get<Spacetime>(spacetime_);
        const double flat = spacetime.flat_radius(settings.tail_error);
        // `state` goes straight on for a time; whether it meets something.
        const auto goes_straight = [&](std::size_t ray, sim::GeodesicState<double>& state, double time) {
            sim::GeodesicState<double> to = state;
            const sim::Components<double> rate = sim::hamilton_equations(spacetime, state).position;
            const sim::Components<double> way = (-time / rate.t) * rate;
            to.position = state.position + way;
            const bool met = visit(ray, {state, to, way, way, 1.0, true}) == sim::Visit::stop;
            state = to;
            return met;
        };
        const auto ends_straight = [&](std::size_t ray, sim::GeodesicState<double> state) {
            found[ray].infinity = spacetime.asymptotics(state);
            const double all = settings.escape_radius + spacetime.remoteness(state.position);
            found[ray].outcome =
                goes_straight(ray, state, all) ? sim::RayOutcome::hit_object : sim::RayOutcome::escaped;
        };
        std::vector<std::size_t> numbers;
        std::vector<sim::GeodesicState<double>> photons;
        for (std::size_t ray = 0; ray < directions.size(); ++ray) {
            sim::GeodesicState<double> photon = sim::seen_photon(spacetime, eye_, tetrad_, directions[ray]);
            if (spacetime.remoteness(eye_) > flat) {
                const std::optional<double> time = spacetime.time_since_flat_radius(photon, flat);
                if (!time) {
                    ends_straight(ray, photon);
                    continue;
                }
                if (goes_straight(ray, photon, *time)) {
                    found[ray].outcome = sim::RayOutcome::hit_object;
                    continue;
                }
            }
            numbers.push_back(ray);
            photons.push_back(photon);
        }
        std::vector<sim::SkyRay> curved(photons.size());
        sim::RaySettings near = settings;
        near.escape_radius = flat;
        sim::trace_photons(spacetime_, photons, near, curved, places_,
                           [&](std::size_t i, const sim::RaySegment& segment) { return visit(numbers[i], segment); });
        for (std::size_t i = 0; i < curved.size(); ++i) {
            found[numbers[i]] = curved[i];
            if (curved[i].outcome == sim::RayOutcome::escaped) {
                ends_straight(numbers[i], curved[i].end);
            }
        }
    }

    sim::AnySpacetime spacetime_; ///< holds a Spacetime
    sim::Components<double> eye_;
    sim::Tetrad tetrad_;
    sim::RaySettings settings_;
    TracedMatter matter_;
    sim::WatchedPlaces places_;
};

} // namespace render
