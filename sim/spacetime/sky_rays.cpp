#include "sim/spacetime/sky_rays.h"

#include "sim/spacetime/clones.h"
#include "sim/spacetime/lanes.h"

#include <algorithm>
#include <cassert>

namespace sim {
namespace {

template <class Spacetime>
struct Sky {
    const Spacetime& spacetime;
    const Components<double>& event;
    const Tetrad& tetrad;
    std::span<const glm::dvec3> seen;
    const RaySettings& settings;
    std::span<SkyRay> rays;
    double far;
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

/// Out of line, so that the wide loop holds nothing but the wide loop.
template <class Spacetime>
[[gnu::noinline]] GeodesicState<double> begin(const Sky<Spacetime>& sky, std::size_t ray) {
    return seen_photon(sky.spacetime, sky.event, sky.tetrad, sky.seen[ray]);
}

template <class Spacetime>
[[gnu::noinline]] void end(const Sky<Spacetime>& sky, std::size_t ray, const GeodesicState<double>& state,
                           RayOutcome outcome, std::uint32_t steps) {
    const RayResult result = ray_result(sky.spacetime, outcome, state, state, state, sky.settings);
    sky.rays[ray] = {result.infinity, result.outcome, steps, result.hamiltonian_drift};
}

template <class Real, int N, class Spacetime>
RAPIDITY_FOR_EACH_REGISTER_WIDTH void follow_lanes(const Sky<Spacetime>& sky) {
    using Lane = Lanes<Real, N>;
    using Mask = typename Lane::Mask;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double far = sky.far;
    const double caught = capture_radius(sky.spacetime, sky.settings);
    const double limit2 = sky.settings.blueshift_limit * sky.settings.blueshift_limit;
    GeodesicState<Lane> state;
    Lane remoteness, blueshift2;
    std::array<std::size_t, N> ray{};
    std::array<std::uint64_t, N> started{};
    std::array<bool, N> busy{};
    std::size_t next_ray = 0;
    std::size_t running = 0;
    std::uint64_t step = 0;
    std::uint64_t deadline = std::numeric_limits<std::uint64_t>::max();
    const auto take_next = [&](int lane) {
        const auto l = static_cast<std::size_t>(lane);
        busy[l] = next_ray < sky.seen.size();
        if (busy[l]) {
            ray[l] = next_ray++;
            started[l] = step;
            ++running;
            const GeodesicState<double> start = begin(sky, ray[l]);
            set(state, lane, start);
            remoteness.v[lane] = static_cast<Real>(sky.spacetime.remoteness(start.position));
            blueshift2.v[lane] = static_cast<Real>(Spacetime::may_have_horizon ? limit2 * momentum2(start) : infinity);
        }
        deadline = std::numeric_limits<std::uint64_t>::max();
        for (std::size_t i = 0; i < N; ++i) {
            deadline = busy[i] ? std::min(deadline, started[i] + sky.settings.step_limit) : deadline;
        }
    };
    // Idle lanes repeat the first ray; whatever becomes of them is not looked at.
    for (int lane = N; lane-- > 0;) {
        set(state, lane, begin(sky, 0));
    }
    for (int lane = 0; lane < N; ++lane) {
        take_next(lane);
    }
    while (running > 0) {
        state = geodesic_step(sky.spacetime, state, -sky.settings.step);
        ++step;
        const Lane next_remoteness = sky.spacetime.remoteness(state.position);
        const Lane p2 = momentum2(state);
        const Mask finite = (p2 < Lane(infinity)) & (next_remoteness < Lane(infinity));
        const Mask escaped = next_remoteness > Lane(far);
        const Mask captured = ((next_remoteness < Lane(caught)) & (next_remoteness < remoteness)) | (p2 > blueshift2);
        const Mask ended = escaped | captured | (!finite);
        remoteness = next_remoteness;
        bool any = step == deadline;
        for (int lane = 0; lane < N; ++lane) {
            any |= ended[lane];
        }
        if (!any) {
            continue;
        }
        for (int lane = 0; lane < N; ++lane) {
            const auto l = static_cast<std::size_t>(lane);
            const auto steps = static_cast<std::uint32_t>(step - started[l]);
            if (!busy[l] || (!ended[lane] && steps < sky.settings.step_limit)) {
                continue;
            }
            const RayOutcome outcome = !finite[lane]    ? RayOutcome::left_chart
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

void trace_sky(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
               std::span<const glm::dvec3> seen, const RaySettings& settings, std::span<SkyRay> rays,
               Precision precision) {
    assert(rays.size() == seen.size());
    if (seen.empty()) {
        return;
    }
    std::visit(
        [&](const auto& chosen) {
            using Chosen = std::remove_cvref_t<decltype(chosen)>;
            const Sky<Chosen> sky{chosen, event, tetrad, seen, settings, rays, escape_radius(chosen, event, settings)};
            if constexpr (Chosen::fits_single_precision) {
                if (precision == Precision::single_precision) {
                    follow_lanes<float, 16>(sky);
                    return;
                }
            }
            follow_lanes<double, 8>(sky);
        },
        spacetime);
}

} // namespace sim
