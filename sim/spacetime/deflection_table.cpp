#include "sim/spacetime/deflection_table.h"

#include "sim/spacetime/observer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {

using std::numbers::pi;

constexpr std::size_t most_nodes = 32768;
constexpr double nearest_to_edge = 1e-9; // rad
constexpr double nearest_measured = 1e-6;

// Which side of the edge a ray is on: outside, all light comes from the eye's own sky.
bool outside_edge(const SkyRay& ray) {
    return ray.outcome == RayOutcome::escaped && ray.infinity.side > 0;
}

glm::dvec3 axis_at(const AnySpacetime& spacetime, const Components<double>& event) {
    return std::holds_alternative<Alcubierre>(spacetime) ? glm::dvec3(1.0, 0.0, 0.0) : glm::normalize(space(event));
}

glm::dvec3 any_across(const glm::dvec3& axis) {
    const glm::dvec3 other = std::abs(axis.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(glm::cross(other, axis));
}

/// The tetrad of one who falls freely along the axis: right is across[0], up across[1], back outward.
Tetrad falling_tetrad(const AnySpacetime& spacetime, const Components<double>& event, const glm::dvec3& outward,
                      const glm::dvec3& up) {
    return std::visit(
        [&](const auto& chosen) {
            const auto velocity = observer_velocity(chosen, event, ObserverKind::free_fall);
            return camera_tetrad(chosen, event, velocity.value(), -outward, up);
        },
        spacetime);
}

/// -p.w of the photon p = e_0 - n^i e_i that is seen from n.
LinearInDirection product_with(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                               const Components<double>& w) {
    const Components<double> lowered =
        std::visit([&](const auto& chosen) { return chosen.metric(event) * w; }, spacetime);
    const auto& e = tetrad.legs;
    return {-contract(e[0], lowered), {contract(e[1], lowered), contract(e[2], lowered), contract(e[3], lowered)}};
}

double value(const LinearInDirection& linear, const glm::dvec3& n) {
    return linear.constant + glm::dot(linear.slope, n);
}

} // namespace

bool DeflectionTable::fits(const AnySpacetime& spacetime, const Components<double>& event) {
    if (const auto* const bubble = std::get_if<Alcubierre>(&spacetime)) {
        const double from_centre = event.x - bubble->speed * event.t;
        return event.y == 0.0 && event.z == 0.0 && std::abs(from_centre) <= 0.5 * bubble->bubble_radius;
    }
    return (std::holds_alternative<Schwarzschild>(spacetime) || std::holds_alternative<ReissnerNordstroem>(spacetime) ||
            std::holds_alternative<Wormhole>(spacetime)) &&
           chart_radius(event) > 0.0;
}

DeflectionTable::DeflectionTable(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                                 const RaySettings& settings, double error)
    : outward_(axis_at(spacetime, event)), across_{any_across(outward_), glm::cross(outward_, any_across(outward_))},
      tracer_(spacetime, event, falling_tetrad(spacetime, event, outward_, across_[1]), settings) {
    const Tetrad falling = falling_tetrad(spacetime, event, outward_, across_[1]);
    for (std::size_t i = 0; i < 4; ++i) {
        fall_from_eye_[i] = product_with(spacetime, event, tetrad, falling.legs[i]);
    }
    if (const auto* const bubble = std::get_if<Alcubierre>(&spacetime)) {
        speed_ = bubble->speed;
    }
    constant_ = product_with(spacetime, event, tetrad, {1.0, speed_, 0.0, 0.0});

    std::vector<glm::dvec3> sample;
    for (double psi = 0.05; psi < pi; psi += 0.05) {
        sample.emplace_back(std::sin(psi), 0.0, -std::cos(psi));
    }
    tracer_.choose_step(sample, 0.01 * error, 0.9);
    edge_ = find_edge();
    for (;; nodes_ *= 2) {
        inner_ = branch(0.0);
        outer_ = branch(pi);
        error_ = std::max(measured_error(inner_, -1.0), measured_error(outer_, 1.0));
        if (error_ <= error || nodes_ >= most_nodes) {
            break;
        }
    }
}

std::vector<SkyRay> DeflectionTable::rays_at(std::span<const double> psi) const {
    std::vector<glm::dvec3> directions;
    directions.reserve(psi.size());
    for (const double angle : psi) {
        directions.emplace_back(std::sin(angle), 0.0, -std::cos(angle));
    }
    std::vector<SkyRay> rays(psi.size());
    tracer_.trace(directions, rays);
    return rays;
}

SkyRay DeflectionTable::ray_at(double psi) const {
    return rays_at(std::span(&psi, 1)).front();
}

double DeflectionTable::theta_of(const SkyRay& ray) const {
    return std::atan2(glm::dot(ray.infinity.direction, across_[0]), glm::dot(ray.infinity.direction, outward_));
}

double DeflectionTable::find_edge() const {
    if (outside_edge(ray_at(0.0))) {
        return 0.0;
    }
    double low = 0.0;
    double high = pi;
    for (double middle = 0.5 * pi; middle > low && middle < high; middle = 0.5 * (low + high)) {
        (outside_edge(ray_at(middle)) ? high : low) = middle;
    }
    return high;
}

DeflectionTable::Branch DeflectionTable::branch(double end) const {
    Branch result;
    const double width = std::abs(end - edge_);
    if (width <= 2.0 * nearest_to_edge) {
        return result;
    }
    const double sign = end > edge_ ? 1.0 : -1.0;
    const SkyRay middle = ray_at(0.5 * (edge_ + end));
    result.outcome = middle.outcome;
    result.side = middle.infinity.side;
    if (result.outcome != RayOutcome::escaped) {
        return result;
    }
    result.first_ln = std::log(nearest_to_edge);
    result.step_ln = (std::log(width) - result.first_ln) / static_cast<double>(nodes_ - 1);
    std::vector<double> psi(nodes_);
    for (std::size_t i = 0; i < nodes_; ++i) {
        psi[i] = edge_ + sign * std::exp(result.first_ln + result.step_ln * static_cast<double>(i));
    }
    psi.back() = end;
    const std::vector<SkyRay> rays = rays_at(psi);
    // From the end, where the ray is on the axis, towards the edge, around which it may turn again and again, as far as
    // the rays can be followed.
    std::vector<double> theta;
    for (std::size_t i = nodes_; i-- > 0;) {
        if (rays[i].outcome != result.outcome || rays[i].infinity.side != result.side) {
            result.first_ln += result.step_ln * static_cast<double>(i + 1);
            break;
        }
        const double here = theta_of(rays[i]);
        theta.push_back(theta.empty() ? here : theta.back() + std::remainder(here - theta.back(), 2.0 * pi));
    }
    if (theta.size() < 4) { // too few to interpolate between: none of them can be told
        result.outcome = RayOutcome::step_limit;
        return result;
    }
    result.theta.assign(theta.rbegin(), theta.rend());
    return result;
}

double DeflectionTable::interpolated(const Branch& branch, double distance) const {
    const std::size_t count = branch.theta.size();
    const double nearest = std::exp(branch.first_ln);
    const double position = std::clamp((std::log(std::max(distance, nearest)) - branch.first_ln) / branch.step_ln, 0.0,
                                       static_cast<double>(count - 1));
    const std::size_t i = std::clamp<std::size_t>(static_cast<std::size_t>(position), 1, count - 3);
    const double t = position - static_cast<double>(i);
    const double* const y = &branch.theta[i - 1];
    // Lagrange's cubic through four nodes.
    return -t * (t - 1.0) * (t - 2.0) / 6.0 * y[0] + (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 * y[1] -
           (t + 1.0) * t * (t - 2.0) / 2.0 * y[2] + (t + 1.0) * t * (t - 1.0) / 6.0 * y[3];
}

double DeflectionTable::measured_error(const Branch& branch, double sign) const {
    // Every 8th gap, and all of the widest.
    std::vector<double> distances;
    for (std::size_t i = 0; i + 1 < branch.theta.size(); i += i + 40 < branch.theta.size() ? 8 : 1) {
        const double distance = std::exp(branch.first_ln + branch.step_ln * (static_cast<double>(i) + 0.5));
        if (distance > nearest_measured) {
            distances.push_back(distance);
        }
    }
    std::vector<double> psi(distances.size());
    std::ranges::transform(distances, psi.begin(), [&](double distance) { return edge_ + sign * distance; });
    const std::vector<SkyRay> rays = rays_at(psi);
    double largest = 0.0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (rays[i].outcome != branch.outcome) {
            continue; // beyond the nearest that can be followed
        }
        const double theta = interpolated(branch, distances[i]);
        largest = std::max(largest, std::abs(std::remainder(theta - theta_of(rays[i]), 2.0 * pi)));
    }
    return largest;
}

void DeflectionTable::trace(std::span<const glm::dvec3> seen, std::span<SkyRay> rays) const {
    for (std::size_t i = 0; i < seen.size(); ++i) {
        // From -p.f_i for the falling tetrad's legs f: the frequency is -p.f_0, the direction seen -p.f_i over it.
        const glm::dvec3& n = seen[i];
        const double frequency = value(fall_from_eye_[0], n);
        const double x = value(fall_from_eye_[1], n) / frequency;
        const double y = value(fall_from_eye_[2], n) / frequency;
        const double back = value(fall_from_eye_[3], n) / frequency;
        const double sine = std::hypot(x, y);
        const double psi = std::atan2(sine, -back);
        const Branch& branch = psi >= edge_ ? outer_ : inner_;
        SkyRay ray;
        ray.outcome = branch.outcome;
        if (branch.outcome == RayOutcome::escaped) {
            const double theta = interpolated(branch, std::abs(psi - edge_));
            const double per_sine = sine > 0.0 ? std::sin(theta) / sine : 0.0;
            ray.infinity.direction = std::cos(theta) * outward_ + per_sine * (x * across_[0] + y * across_[1]);
            ray.infinity.frequency = value(constant_, n) / (1.0 + speed_ * ray.infinity.direction.x);
            ray.infinity.side = branch.side;
        }
        rays[i] = ray;
    }
}

} // namespace sim
