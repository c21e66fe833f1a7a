#include "sim/spacetime/mino.h"

#include "sim/spacetime/clones.h"
#include "sim/spacetime/lanes.h"
#include "sim/spacetime/mino_path.h"
#include "sim/spacetime/sine_cosine.h"

#include <algorithm>
#include <cassert>

namespace sim {
namespace {

struct MinoSky {
    const MinoEye& eye;
    std::span<const glm::dvec3> seen;
    const RaySettings& settings;
    std::span<SkyRay> rays;
    std::span<PlaneCrossings> crossings;
    const MinoWatch* watch = nullptr;
    const MinoVisitor* visit = nullptr;
};

// A scalar is a pack of one lane.
constexpr int width_of(double /*scalar*/) {
    return 1;
}
template <class Real, int N>
constexpr int width_of(const Lanes<Real, N>& /*lanes*/) {
    return N;
}
bool element(bool mask, int /*lane*/) {
    return mask;
}
template <class Integer, int N>
bool element(const LaneMask<Integer, N>& mask, int lane) {
    return mask[lane];
}
double element(double value, int /*lane*/) {
    return value;
}
template <class Real, int N>
double element(const Lanes<Real, N>& value, int lane) {
    return static_cast<double>(value.v[lane]);
}
void set_element(double& value, int /*lane*/, double to) {
    value = to;
}
template <class Real, int N>
void set_element(Lanes<Real, N>& value, int lane, double to) {
    value.v[lane] = static_cast<Real>(to);
}

template <class Mask>
bool any(const Mask& mask, int width) {
    bool result = false;
    for (int lane = 0; lane < width; ++lane) {
        result |= element(mask, lane);
    }
    return result;
}

template <class Mask, class T>
MinoState<T> select_state(const Mask& condition, const MinoState<T>& a, const MinoState<T>& b) {
    const auto pick = [&](const MinoPosition<T>& p, const MinoPosition<T>& q) {
        return MinoPosition<T>{select(condition, p.u, q.u), select(condition, p.x, q.x), select(condition, p.y, q.y),
                               select(condition, p.z, q.z)};
    };
    return {pick(a.y, b.y), pick(a.velocity, b.velocity), select(condition, a.z, b.z)};
}

/// One lane's step of tau that crosses z = 0: from (u, N, Phi) and rates at both ends, cubic Hermite curves.
struct CrossingStep {
    std::array<MinoState<double>, 2> ends;
    double step;
    double angular_momentum;
    double end_share; ///< where the ray is stopped; more than 1: it is not
};

double hermite(double u, double from, double from_rate, double to, double to_rate) {
    const double v = 1.0 - u;
    return v * v * (1.0 + 2.0 * u) * from + u * u * (1.0 + 2.0 * v) * to + u * v * v * from_rate - u * u * v * to_rate;
}

[[gnu::noinline]] void add_crossing(const MinoEye& eye, const CrossingStep& s, PlaneCrossings& into) {
    const auto& [a, b] = s.ends;
    const auto at = [&](double u, auto member) {
        return hermite(u, a.y.*member, s.step * (a.velocity.*member), b.y.*member, s.step * (b.velocity.*member));
    };
    using Position = MinoPosition<double>;
    // Bisection narrowed by secants (regula falsi, Illinois): N_z has opposite signs at the ends.
    double low = 0.0, high = 1.0;
    double at_low = a.y.z, at_high = b.y.z;
    double share = 0.5;
    for (int i = 0; i < 12; ++i) {
        share = (low * at_high - high * at_low) / (at_high - at_low);
        const double here = at(share, &Position::z);
        if (std::abs(here) < 1e-14) {
            break;
        }
        if ((here > 0.0) == (at_high > 0.0)) {
            high = share;
            at_high = here;
            at_low *= 0.5;
        } else {
            low = share;
            at_low = here;
            at_high *= 0.5;
        }
    }
    const double u = at(share, &Position::u);
    if (share > s.end_share) {
        return;
    }
    if (into.count == PlaneCrossings::most || !(u > 0.0) || !(u * eye.hole.radii.horizon < 1.0)) {
        return;
    }
    const auto dragging_rate = [&](const MinoState<double>& end) {
        return -s.step * mino_dragging(eye.hole, s.angular_momentum, end.y.u);
    };
    const double dragging = hermite(share, a.z, dragging_rate(a), b.z, dragging_rate(b));
    const double azimuth = std::atan2(at(share, &Position::y), at(share, &Position::x)) + dragging + eye.azimuth;
    into.crossing[static_cast<std::size_t>(into.count++)] = {1.0 / u, azimuth};
}

template <class T>
MinoState<double> lane_of(const MinoState<T>& s, int lane) {
    return {{element(s.y.u, lane), element(s.y.x, lane), element(s.y.y, lane), element(s.y.z, lane)},
            {element(s.velocity.u, lane), element(s.velocity.x, lane), element(s.velocity.y, lane),
             element(s.velocity.z, lane)},
            element(s.z, lane)};
}

template <class T>
MinoRay<double> lane_of(const MinoRay<T>& r, int lane) {
    return {element(r.energy, lane),    element(r.angular_momentum, lane), element(r.k, lane),
            element(r.linear, lane),    element(r.quadratic, lane),        element(r.cubic, lane),
            element(r.step_scale, lane)};
}

/// Out of line, so that the wide loop holds nothing but the wide loop.
[[gnu::noinline]] double show(const MinoSky& sky, std::size_t ray, const MinoSegment& segment) {
    return (*sky.visit)(ray, segment);
}

/// The rays from `first` on, as many as T has lanes, side by side until all have ended.
template <bool rotating, bool watched, class T>
void follow_pack(const MinoSky& sky, std::size_t first) {
    constexpr int width = width_of(T{});
    const MinoEye& eye = sky.eye;
    const std::size_t last = sky.seen.size() - 1;
    T nx, ny, nz;
    for (int lane = 0; lane < width; ++lane) {
        const glm::dvec3& n = sky.seen[std::min(first + static_cast<std::size_t>(lane), last)];
        set_element(nx, lane, n.x);
        set_element(ny, lane, n.y);
        set_element(nz, lane, n.z);
    }
    auto [ray, state] = mino_start(eye, nx, ny, nz);
    const T step = T(sky.settings.step) * ray.step_scale;
    const T zero(0.0);
    const T caught(1.0 / eye.hole.radii.capture_radius(sky.settings.nothing_near_horizon));
    const auto from_horizon = !(ray.energy > zero);
    auto captured = from_horizon;
    auto escaped = !(from_horizon | !from_horizon);
    auto lost = escaped;
    auto stopped = escaped;
    auto running = !from_horizon;
    T steps(0.0);
    const int rays_here = static_cast<int>(std::min<std::size_t>(width, sky.seen.size() - first));
    if (!sky.crossings.empty()) {
        for (int lane = 0; lane < rays_here; ++lane) {
            PlaneCrossings& into = sky.crossings[first + static_cast<std::size_t>(lane)];
            into = {};
            into.frequency = element(ray.energy, lane);
            into.angular_momentum = element(ray.angular_momentum, lane) * into.frequency;
        }
    }
    for (std::uint32_t i = 0; i < sky.settings.step_limit && any(running, width); ++i) {
        const MinoState<T> next = mino_step<rotating>(eye.hole, ray, state, step);
        steps = steps + select(running, T(1.0), zero);
        T end_share(2.0);
        if constexpr (watched) {
            const decltype(running) touching =
                running & sky.watch->template may_touch<rotating>(state, next, sky.settings.step);
            if (any(touching, rays_here)) {
                for (int lane = 0; lane < rays_here; ++lane) {
                    if (element(touching, lane)) {
                        set_element(end_share, lane,
                                    show(sky, first + static_cast<std::size_t>(lane),
                                         {&eye, lane_of(ray, lane), lane_of(state, lane), lane_of(next, lane),
                                          element(step, lane)}));
                    }
                }
                stopped = stopped | (running & !(end_share > T(1.0)));
            }
        }
        if (!sky.crossings.empty()) {
            const decltype(running) crossing = running & (state.y.z * next.y.z < zero);
            for (int lane = 0; lane < rays_here; ++lane) {
                if (element(crossing, lane)) {
                    add_crossing(eye,
                                 {{lane_of(state, lane), lane_of(next, lane)},
                                  element(step, lane),
                                  element(ray.angular_momentum, lane),
                                  element(end_share, lane)},
                                 sky.crossings[first + static_cast<std::size_t>(lane)]);
                }
            }
        }
        state = select_state(running, next, state);
        const T finite = state.y.u - state.y.u + state.z - state.z; // 0, or no number
        const decltype(running) lost_now = running & !(finite > T(-1.0));
        escaped = escaped | (running & !(state.y.u > zero) & !lost_now);
        captured = captured | (running & (state.y.u > caught) & (state.velocity.u > zero));
        lost = lost | lost_now;
        running = running & !(escaped | captured | lost | stopped);
    }
    // To u = 0: one step by Halley's estimate of what is left of tau, then what that left out by its Taylor series.
    const auto acceleration = [&] { return mino_rate<rotating>(eye.hole, ray, state.y); };
    const T v = state.velocity.u;
    const T back = -state.y.u / v - state.y.u * state.y.u * acceleration().acceleration.u / (T(2.0) * v * v * v);
    state = mino_step<rotating>(eye.hole, ray, state, back);
    const T rest = -state.y.u / state.velocity.u;
    const MinoPosition<T> end = state.y + rest * state.velocity + (T(0.5) * rest * rest) * acceleration().acceleration;
    const auto turn = sine_cosine(state.z + T(eye.azimuth));
    using std::sqrt;
    const T length2 = end.x * end.x + end.y * end.y + end.z * end.z;
    const T per_length = T(1.0) / sqrt(length2);
    const T x = per_length * (turn.cosine * end.x - turn.sine * end.y);
    const T y = per_length * (turn.sine * end.x + turn.cosine * end.y);
    const T z = per_length * end.z;
    // u'^2 = 1 at infinity, and N is a unit vector.
    const T drift_u = state.velocity.u * state.velocity.u - T(1.0);
    const T drift_n = length2 - T(1.0);
    const T drift = sqrt(drift_u * drift_u + drift_n * drift_n);
    for (int lane = 0; lane < rays_here; ++lane) {
        SkyRay& result = sky.rays[first + static_cast<std::size_t>(lane)];
        result = {};
        result.steps = static_cast<std::uint32_t>(element(steps, lane));
        if (element(stopped, lane)) {
            result.outcome = RayOutcome::hit_object;
        } else if (element(escaped, lane)) {
            const double strayed = element(drift, lane);
            result.infinity = {{element(x, lane), element(y, lane), element(z, lane)}, element(ray.energy, lane), 1};
            result.hamiltonian_drift = strayed;
            result.outcome = strayed <= sky.settings.drift_limit ? RayOutcome::escaped : RayOutcome::constraint_drift;
        } else {
            result.outcome = element(captured, lane) ? RayOutcome::captured
                             : element(lost, lane)   ? RayOutcome::left_chart
                                                     : RayOutcome::step_limit;
        }
    }
}

template <bool rotating, bool watched, class T>
RAPIDITY_FOR_EACH_REGISTER_WIDTH void follow_all(const MinoSky& sky) {
    for (std::size_t first = 0; first < sky.seen.size(); first += static_cast<std::size_t>(width_of(T{}))) {
        follow_pack<rotating, watched, T>(sky, first);
    }
}

template <class T, bool watched = false>
void follow(const MinoSky& sky) {
    assert(sky.rays.size() == sky.seen.size());
    assert(sky.crossings.empty() || sky.crossings.size() == sky.seen.size());
    if (sky.eye.hole.spin == 0.0) {
        follow_all<false, watched, T>(sky);
    } else {
        follow_all<true, watched, T>(sky);
    }
}

double radius_of(const MinoHole& hole, const Components<double>& event) {
    return Kerr(hole.mass, hole.spin).radius(event);
}

} // namespace

std::optional<MinoHole> mino_hole(const AnySpacetime& spacetime) {
    if (const auto* kerr = std::get_if<Kerr>(&spacetime)) {
        return MinoHole{kerr->mass, kerr->spin, 0.0, kerr->radii};
    }
    if (const auto* hole = std::get_if<Schwarzschild>(&spacetime)) {
        return MinoHole{hole->mass, 0.0, 0.0, hole->radii};
    }
    if (const auto* hole = std::get_if<ReissnerNordstroem>(&spacetime)) {
        return MinoHole{hole->mass, 0.0, hole->charge, hole->radii};
    }
    return std::nullopt;
}

bool fits_mino(const MinoHole& hole, const Components<double>& event) {
    return radius_of(hole, event) > (hole.spin == 0.0 ? hole.radii.innermost : hole.radii.horizon * (1.0 + 1e-9));
}

MinoEye mino_eye(const AnySpacetime& spacetime, const MinoHole& hole, const Components<double>& event,
                 const Tetrad& tetrad) {
    const double a = hole.spin;
    const double r = radius_of(hole, event);
    const double reach = std::sqrt(r * r + a * a);
    const glm::dvec3 x = space(event);
    const glm::dvec3 place(x.x / reach, x.y / reach, x.z / r);
    MinoEye eye;
    eye.hole = hole;
    eye.inverse_radius = 1.0 / r;
    eye.place = place;
    if (a != 0.0) {
        const double inner = 2.0 * hole.mass - hole.radii.horizon;
        eye.azimuth =
            -std::atan2(a, r) - a / (hole.radii.horizon - inner) * std::log((r - hole.radii.horizon) / (r - inner));
    }
    // For each leg of the tetrad as if it were the photon, these are linear: E, L_z, u' and N' into the past. With
    // R = sqrt(r^2 + a^2), m = (x, y)/R and p_xy the planar part:
    //   dN_xy/dtau = R p_xy - (R m.p_xy + z p_z) m,  dN_z/dtau = r sin^2(theta) p_z - cos(theta) R m.p_xy,
    //   Sigma dr/dlambda = (r (x.v) + a^2 z v_z/r) (Sigma r^2/(r^4 + a^2 z^2) = 1) with v^i = dx^i/dlambda.
    const std::array<Components<double>, 4> momenta = std::visit(
        [&](const auto& chosen) {
            const auto g = chosen.metric(event);
            return std::array{g * tetrad.legs[0], g * tetrad.legs[1], g * tetrad.legs[2], g * tetrad.legs[3]};
        },
        spacetime);
    const auto quantities = [&](std::size_t leg) {
        const Components<double>& p = momenta[leg];
        const Components<double>& v = tetrad.legs[leg];
        const double outward = reach * (place.x * p.x + place.y * p.y);
        const double sine2 = place.x * place.x + place.y * place.y;
        const double along = outward + x.z * p.z;
        const double radial = r * (x.x * v.x + x.y * v.y + x.z * v.z) + a * a * x.z * v.z / r;
        return std::array<double, 6>{-p.t,
                                     x.x * p.y - x.y * p.x,
                                     radial / (r * r),
                                     -(reach * p.x - along * place.x),
                                     -(reach * p.y - along * place.y),
                                     -(r * sine2 * p.z - place.z * outward)};
    };
    // p = e_0 - n^i e_i.
    const auto time = quantities(0), right = quantities(1), up = quantities(2), back = quantities(3);
    const auto linear = [&](std::size_t i) { return LinearInDirection{time[i], {-right[i], -up[i], -back[i]}}; };
    eye.energy = linear(0);
    eye.angular_momentum = linear(1);
    eye.inverse_radius_rate = linear(2);
    eye.place_rate = {linear(3), linear(4), linear(5)};
    return eye;
}

void trace_mino_sky(const MinoEye& eye, std::span<const glm::dvec3> seen, const RaySettings& settings,
                    std::span<SkyRay> rays, std::span<PlaneCrossings> crossings, Precision precision) {
    const MinoSky sky{eye, seen, settings, rays, crossings};
    if (precision == Precision::single_precision) {
        follow<Lanes<float, 16>>(sky);
    } else {
        follow<Lanes<double, 8>>(sky);
    }
}

void trace_mino_sky(const MinoEye& eye, std::span<const glm::dvec3> seen, const RaySettings& settings,
                    std::span<SkyRay> rays, std::span<PlaneCrossings> crossings, const MinoWatch& watch,
                    const MinoVisitor& visit) {
    follow<Lanes<double, 8>, true>({eye, seen, settings, rays, crossings, &watch, &visit});
}

void trace_mino_sky_one_by_one(const MinoEye& eye, std::span<const glm::dvec3> seen, const RaySettings& settings,
                               std::span<SkyRay> rays, std::span<PlaneCrossings> crossings) {
    follow<double>({eye, seen, settings, rays, crossings});
}

} // namespace sim
