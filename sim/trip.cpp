#include "sim/trip.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

double gamma_of(const glm::dvec3& u) {
    return std::sqrt(1.0 + glm::dot(u, u));
}

double rapidity_of(const glm::dvec3& u) {
    return std::asinh(glm::length(u));
}

/// A function of a rapidity, and its derivative.
struct Slope {
    double value;
    double derivative;
};

/// tanh(xi/2) / xi; the series below, where both would cancel.
Slope half_tangent(double xi) {
    if (xi < 1e-3) {
        return {0.5 - xi * xi / 24.0, -xi / 12.0}; // next terms: xi^4 / 240
    }
    const double t = std::tanh(0.5 * xi);
    return {t / xi, 0.5 * (1.0 - t * t) / xi - t / (xi * xi)};
}

/// A burn whose thrust is given, or its time.
struct BurnLaw {
    double thrust = 1.0;
    double time = 0.0; ///< > 0: given, and the thrust follows

    /// What (u + v) is multiplied with for the displacement of a burn of this rapidity: tanh(phi/2) / thrust.
    Slope reach(double phi) const {
        if (time > 0.0) {
            const Slope half = half_tangent(phi);
            return {time * half.value, time * half.derivative};
        }
        const double t = std::tanh(0.5 * phi);
        return {t / thrust, 0.5 * (1.0 - t * t) / thrust};
    }
};
struct BurnLaws {
    BurnLaw first;
    BurnLaw second;
};

/// Displacement of the whole trip as a function of p, and its derivative.
struct Displacement {
    glm::dvec3 value;
    glm::dmat3 derivative;
};

Displacement displacement_of(const TripTask& task, const BurnLaws& laws, const glm::dvec3& p) {
    const glm::dvec3& u = task.velocity;
    const double gamma_p = gamma_of(p);
    const double phi = relative_rapidity(u, p).value;
    const double length = glm::length(p);
    const Slope first = laws.first.reach(phi);
    const Slope second = laws.second.reach(std::asinh(length));
    // Gradients of the two rapidities.
    const glm::dvec3 grad_phi = phi > 0.0 ? ((gamma_of(u) / gamma_p) * p - u) / std::sinh(phi) : glm::dvec3(0.0);
    const glm::dvec3 grad_xi = length > 0.0 ? p / (gamma_p * length) : glm::dvec3(0.0);

    Displacement result;
    result.value = first.value * (u + p) + (second.value + task.coast * task.tick) * p + (task.wait * task.tick) * u;
    result.derivative = glm::outerProduct(u + p, first.derivative * grad_phi) +
                        glm::outerProduct(p, second.derivative * grad_xi) +
                        glm::dmat3(first.value + second.value + task.coast * task.tick);
    return result;
}

/// Newton's method with steps halved until they lead nearer.
std::optional<glm::dvec3> newton(const TripTask& task, const BurnLaws& laws, glm::dvec3 p) {
    constexpr int most_steps = 60;
    constexpr double enough = 1e-13; ///< of the trip's length: a few roundings
    constexpr double acceptable = 1e-9;
    Displacement here = displacement_of(task, laws, p);
    double missed = glm::length(task.way - here.value);
    const double scale = glm::length(task.way) + glm::length(task.velocity) * task.tick;
    for (int i = 0; i < most_steps && missed > enough * scale; ++i) {
        const glm::dvec3 full = glm::inverse(here.derivative) * (task.way - here.value);
        bool nearer = false;
        for (double part = 1.0; part > 1e-4 && !nearer; part *= 0.5) {
            const glm::dvec3 next = p + part * full;
            const Displacement there = displacement_of(task, laws, next);
            const double distance = glm::length(task.way - there.value);
            if (distance < missed) {
                nearer = true;
                p = next;
                here = there;
                missed = distance;
            }
        }
        if (!nearer) {
            break;
        }
    }
    return missed <= acceptable * scale ? std::optional(p) : std::nullopt;
}

/// From rest without a coast: (cosh xi - 1)(1/a + 1/b) = distance.
glm::dvec3 peak_from_rest(const TripTask& task, const glm::dvec3& way) {
    const double distance = glm::length(way);
    if (distance == 0.0) {
        return glm::dvec3(0.0);
    }
    const double c1 = distance / (1.0 / task.acceleration + 1.0 / task.braking);
    return way * (std::sqrt(c1 * (c1 + 2.0)) / distance);
}

/// Where to begin: as if the ship first came to rest, and what it has of speed that way on top.
glm::dvec3 first_guess(const TripTask& task) {
    const glm::dvec3& u = task.velocity;
    const double gamma = gamma_of(u);
    const glm::dvec3 rest_way =
        task.way - u * (glm::length(u) / (1.0 + gamma) / task.braking) - (task.wait * task.tick) * u;
    const glm::dvec3 p = peak_from_rest(task, rest_way);
    return p + glm::dot(p, u) * u / (1.0 + glm::length(u) * glm::length(p) + glm::dot(u, u));
}

std::optional<glm::dvec3> peak_by_continuation(const TripTask& task, const BurnLaws& laws) {
    constexpr int stages = 24;
    TripTask stage = task;
    glm::dvec3 p = peak_from_rest(task, task.way);
    for (int i = 0; i <= stages; ++i) {
        stage.velocity = (static_cast<double>(i) / stages) * task.velocity;
        const std::optional<glm::dvec3> next = newton(stage, laws, p);
        if (!next) {
            return std::nullopt;
        }
        p = *next;
    }
    return p;
}

/// Whole ticks that a burn takes.
double ticks_of(Rapidity burn, double thrust, double tick) {
    // So much more than the thrust a burn may take: far more than the noise of planning it again every tick.
    constexpr double tolerated_ticks = 1e-6;
    return std::max(1.0, std::ceil(burn.value / (thrust * tick) - tolerated_ticks));
}

} // namespace

Rapidity relative_rapidity(const glm::dvec3& u, const glm::dvec3& v) {
    const double gammas = gamma_of(u) * gamma_of(v);
    const double along = glm::dot(u, v);
    if (along < 0.0) {
        return Rapidity(std::acosh(gammas - along));
    }
    // (cosh - 1)(cosh' + 1) with cosh' that of u and -v: the difference of large products, without them.
    const glm::dvec3 apart = u - v;
    const glm::dvec3 across = glm::cross(u, apart); // = v x u
    const double cosh_minus_one = (glm::dot(apart, apart) + glm::dot(across, across)) / (1.0 + gammas + along);
    return Rapidity(2.0 * std::asinh(std::sqrt(0.5 * cosh_minus_one)));
}

std::optional<Trip> solve_trip(const TripTask& task, const TripSchedule& schedule, const glm::dvec3& peak) {
    const BurnLaws by_time{{0.0, schedule.first * task.tick}, {0.0, schedule.second * task.tick}};
    TripTask timed = task;
    timed.wait = schedule.wait;
    timed.coast = schedule.coast;
    const std::optional<glm::dvec3> p = newton(timed, by_time, peak);
    if (!p) {
        return std::nullopt;
    }
    Trip trip;
    trip.peak = *p;
    trip.first = relative_rapidity(task.velocity, *p);
    trip.second = Rapidity(rapidity_of(*p));
    trip.schedule = schedule;
    const double gamma_u = gamma_of(task.velocity);
    const double gamma_p = gamma_of(*p);
    trip.goal_time =
        schedule.wait * task.tick * gamma_u + by_time.first.reach(trip.first.value).value * (gamma_u + gamma_p) +
        schedule.coast * task.tick * gamma_p + by_time.second.reach(trip.second.value).value * (gamma_p + 1.0);
    return trip;
}

std::optional<Trip> solve_trip(const TripTask& task) {
    const BurnLaws by_thrust{{task.acceleration, 0.0}, {task.braking, 0.0}};
    std::optional<glm::dvec3> p = newton(task, by_thrust, first_guess(task));
    p = p ? p : peak_by_continuation(task, by_thrust);
    std::optional<Trip> trip;
    TripSchedule schedule{task.wait, 0.0, task.coast, 0.0};
    // Whole ticks change the peak a little, and that the ticks that it takes: never fewer, or the two would chase.
    constexpr int most_rounds = 12;
    for (int round = 0; round < most_rounds && p; ++round) {
        TripSchedule needed = schedule;
        needed.first =
            std::max(needed.first, ticks_of(relative_rapidity(task.velocity, *p), task.acceleration, task.tick));
        needed.second = std::max(needed.second, ticks_of(Rapidity(rapidity_of(*p)), task.braking, task.tick));
        if (needed == schedule) {
            return trip;
        }
        schedule = needed;
        trip = solve_trip(task, schedule, *p);
        p = trip ? std::optional(trip->peak) : std::nullopt;
    }
    return std::nullopt;
}

} // namespace sim
