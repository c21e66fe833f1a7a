#include "sim/spacetime/sky_rays.h"

#include "sim/spacetime/clones.h"
#include "sim/spacetime/lanes.h"

#include <algorithm>
#include <cassert>

namespace sim {
namespace {

/// Where each ray starts.
template <class Spacetime>
using FirstState = std::function<GeodesicState<double>(const Spacetime& spacetime, std::size_t ray)>;

template <class Spacetime>
struct Sky {
    const Spacetime& spacetime;
    const FirstState<Spacetime>& first;
    const RaySettings& settings;
    std::span<SkyRay> rays;
    double far;
    const WatchedPlaces& places;
    const SegmentVisitor* visit; ///< nullptr: nothing is watched
};

template <class Lane>
void set(GeodesicState<Lane>& state, int lane, const GeodesicState<double>& value) {
    for (int mu = 0; mu < 4; ++mu) {
        using Real = std::remove_cvref_t<decltype(state.position.t.v[0])>;
        state.position[mu].v[lane] = static_cast<Real>(value.position[mu]);
        state.momentum[mu].v[lane] = static_cast<Real>(value.momentum[mu]);
    }
}

template <class Lane>
GeodesicState<double> get(const GeodesicState<Lane>& state, int lane) {
    GeodesicState<double> value;
    for (int mu = 0; mu < 4; ++mu) {
        value.position[mu] = static_cast<double>(state.position[mu].v[lane]);
        value.momentum[mu] = static_cast<double>(state.momentum[mu].v[lane]);
    }
    return value;
}

/// How a lane starts.
struct Start {
    GeodesicState<double> state;
    bool reversed; ///< in the time-reversed chart
    double momentum2;
};

/// Out of line, so that the wide loop holds nothing but the wide loop.
template <class Spacetime>
[[gnu::noinline]] Start begin(const Sky<Spacetime>& sky, std::size_t ray) {
    const GeodesicState<double> photon = sky.first(sky.spacetime, ray);
    const bool reversed = sky.visit == nullptr && starts_reversed(sky.spacetime, photon);
    return {reversed ? in_other_chart(sky.spacetime, photon) : photon, reversed, momentum2(photon)};
}

template <class Spacetime>
[[gnu::noinline]] GeodesicState<double> turned(const Sky<Spacetime>& sky, const GeodesicState<double>& state) {
    return in_other_chart(sky.spacetime, state);
}

template <class Spacetime>
[[gnu::noinline]] void end(const Sky<Spacetime>& sky, std::size_t ray, const GeodesicState<double>& state,
                           RayOutcome outcome, std::uint32_t steps) {
    const RayResult result = ray_result(sky.spacetime, outcome, state, state, state, sky.settings);
    sky.rays[ray] = {result.infinity, result.outcome, steps, result.hamiltonian_drift, state};
}

/// Which lanes' steps may touch a watched place. A step that is no longer than twice its chord stays within the chord's
/// length of its middle; a moving ball is passed in its own frame, where all is longer by up to gamma.
template <class Lane>
typename Lane::Mask may_touch(const WatchedPlaces& places, const GeodesicState<Lane>& from,
                              const GeodesicState<Lane>& to) {
    const auto& a = from.position;
    const auto& b = to.position;
    typename Lane::Mask touch = (places.plane ? a.z * b.z : Lane(1.0)) < Lane(1e-300);
    for (const WatchedBall& ball : places.balls) {
        const glm::dvec3& v = ball.velocity;
        const glm::dvec3& c = ball.centre_at_zero;
        const double speed2 = v.x * v.x + v.y * v.y + v.z * v.z;
        Lane chord2(0.0), middle2(0.0);
        const auto add = [&](const Lane& start, const Lane& end, double centre, double speed) {
            const Lane from_start = start - Lane(centre) - Lane(speed) * a.t;
            const Lane from_end = end - Lane(centre) - Lane(speed) * b.t;
            const Lane chord = from_end - from_start;
            const Lane middle = Lane(0.5) * (from_start + from_end);
            chord2 = chord2 + chord * chord;
            middle2 = middle2 + middle * middle;
        };
        add(a.x, b.x, c.x, v.x);
        add(a.y, b.y, c.y, v.y);
        add(a.z, b.z, c.z, v.z);
        // (R + gamma L)^2 <= 2 R^2 + 2 gamma^2 L^2, within a factor of sqrt(2): no root is needed.
        touch = touch | (middle2 < Lane(2.0 * ball.radius * ball.radius) + Lane(2.0 / (1.0 - speed2)) * chord2);
    }
    return touch;
}

/// Shows the visitor one lane's step.
template <class Spacetime>
[[gnu::noinline]] Visit show(const Sky<Spacetime>& sky, std::size_t ray, const GeodesicState<double>& from,
                             const GeodesicState<double>& to) {
    return (*sky.visit)(ray, {from, to, -1.0 * rate_in_own_parameter(sky.spacetime, from).position,
                              -1.0 * rate_in_own_parameter(sky.spacetime, to).position, sky.settings.step});
}

template <class Real, int N, bool watched, class Spacetime>
RAPIDITY_FOR_EACH_REGISTER_WIDTH void follow_lanes(const Sky<Spacetime>& sky) {
    using Lane = Lanes<Real, N>;
    using Mask = typename Lane::Mask;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double far = sky.far;
    const double caught = capture_radius(sky.spacetime, sky.settings);
    const double limit2 = sky.settings.blueshift_limit * sky.settings.blueshift_limit;
    GeodesicState<Lane> state;
    Lane remoteness, blueshift2;
    Mask reversed;
    std::array<std::size_t, N> ray{};
    std::array<std::uint64_t, N> started{};
    std::array<bool, N> busy{};
    std::size_t next_ray = 0;
    std::size_t running = 0;
    std::uint64_t step = 0;
    std::uint64_t deadline = std::numeric_limits<std::uint64_t>::max();
    const auto take_next = [&](int lane) {
        const auto l = static_cast<std::size_t>(lane);
        busy[l] = next_ray < sky.rays.size();
        if (busy[l]) {
            ray[l] = next_ray++;
            started[l] = step;
            ++running;
            const Start start = begin(sky, ray[l]);
            set(state, lane, start.state);
            reversed.set(lane, start.reversed);
            remoteness.v[lane] = static_cast<Real>(sky.spacetime.remoteness(start.state.position));
            blueshift2.v[lane] = static_cast<Real>(Spacetime::may_have_horizon ? limit2 * start.momentum2 : infinity);
        }
        deadline = std::numeric_limits<std::uint64_t>::max();
        for (std::size_t i = 0; i < N; ++i) {
            deadline = busy[i] ? std::min(deadline, started[i] + sky.settings.step_limit) : deadline;
        }
    };
    // Idle lanes repeat the first ray; whatever becomes of them is not looked at.
    for (int lane = N; lane-- > 0;) {
        set(state, lane, begin(sky, 0).state);
    }
    for (int lane = 0; lane < N; ++lane) {
        take_next(lane);
    }
    while (running > 0) {
        const GeodesicState<Lane> before = state;
        state = geodesic_step(sky.spacetime, state, -sky.settings.step);
        ++step;
        const Lane next_remoteness = sky.spacetime.remoteness(state.position);
        const Lane p2 = momentum2(state);
        const Mask finite = (p2 < Lane(infinity)) & (next_remoteness < Lane(infinity));
        const Mask escaped = next_remoteness > Lane(far);
        const Mask inwards = next_remoteness < remoteness;
        const Mask captured = ((next_remoteness < Lane(caught)) & inwards) | (p2 > blueshift2);
        Mask met{};
        if constexpr (watched) {
            met = may_touch(sky.places, before, state) & finite;
            for (int lane = 0; lane < N; ++lane) {
                const auto l = static_cast<std::size_t>(lane);
                if (met[lane] && !(busy[l] && show(sky, ray[l], get(before, lane), get(state, lane)) == Visit::stop)) {
                    met.set(lane, false);
                }
            }
        }
        const Mask ended = escaped | captured | met | (!finite);
        const Mask turning = reversed & !inwards;
        const Mask noted = ended | turning;
        remoteness = next_remoteness;
        bool any = step == deadline;
        for (int lane = 0; lane < N; ++lane) {
            any |= noted[lane];
        }
        if (!any) {
            continue;
        }
        for (int lane = 0; lane < N; ++lane) {
            const auto l = static_cast<std::size_t>(lane);
            const auto steps = static_cast<std::uint32_t>(step - started[l]);
            if (turning[lane]) {
                set(state, lane, turned(sky, get(state, lane)));
                reversed.set(lane, false);
            }
            if (!busy[l] || (!ended[lane] && steps < sky.settings.step_limit)) {
                continue;
            }
            const RayOutcome outcome = !finite[lane]    ? RayOutcome::left_chart
                                       : met[lane]      ? RayOutcome::hit_object
                                       : escaped[lane]  ? RayOutcome::escaped
                                       : captured[lane] ? RayOutcome::captured
                                                        : RayOutcome::step_limit;
            end(sky, ray[l], get(state, lane), outcome, steps);
            --running;
            take_next(lane);
        }
    }
}

} // namespace

namespace {

/// `Begin`: gives the first state of each ray in a spacetime; `Far`: where its rays count as escaped.
template <class Begin, class Far>
void trace(const AnySpacetime& spacetime, const Begin& begin_of, const Far& far_of, const RaySettings& settings,
           std::span<SkyRay> rays, Precision precision, const WatchedPlaces& places, const SegmentVisitor* visit) {
    if (rays.empty()) {
        return;
    }
    std::visit(
        [&](const auto& chosen) {
            using Chosen = std::remove_cvref_t<decltype(chosen)>;
            const FirstState<Chosen> first = begin_of;
            const Sky<Chosen> sky{chosen, first, settings, rays, far_of(chosen), places, visit};
            if (visit != nullptr) {
                follow_lanes<double, 8, true>(sky);
                return;
            }
            if constexpr (Chosen::fits_single_precision) {
                if (precision == Precision::single_precision) {
                    follow_lanes<float, 16, false>(sky);
                    return;
                }
            }
            follow_lanes<double, 8, false>(sky);
        },
        spacetime);
}

void trace_eye(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
               std::span<const glm::dvec3> seen, const RaySettings& settings, std::span<SkyRay> rays,
               Precision precision, const WatchedPlaces& places, const SegmentVisitor* visit) {
    assert(rays.size() == seen.size());
    trace(
        spacetime, [&](const auto& chosen, std::size_t ray) { return seen_photon(chosen, event, tetrad, seen[ray]); },
        [&](const auto& chosen) { return escape_radius(chosen, event, settings); }, settings, rays, precision, places,
        visit);
}

} // namespace

void trace_sky(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
               std::span<const glm::dvec3> seen, const RaySettings& settings, std::span<SkyRay> rays,
               Precision precision) {
    trace_eye(spacetime, event, tetrad, seen, settings, rays, precision, {}, nullptr);
}

void trace_sky(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
               std::span<const glm::dvec3> seen, const RaySettings& settings, std::span<SkyRay> rays,
               const WatchedPlaces& places, const SegmentVisitor& visit) {
    trace_eye(spacetime, event, tetrad, seen, settings, rays, Precision::double_precision, places, &visit);
}

void trace_photons(const AnySpacetime& spacetime, std::span<const GeodesicState<double>> photons,
                   const RaySettings& settings, std::span<SkyRay> rays, const WatchedPlaces& places,
                   const SegmentVisitor& visit) {
    assert(rays.size() == photons.size());
    trace(
        spacetime, [&](const auto& /*chosen*/, std::size_t ray) { return photons[ray]; },
        [&](const auto& /*chosen*/) { return settings.escape_radius; }, settings, rays, Precision::double_precision,
        places, &visit);
}

} // namespace sim
