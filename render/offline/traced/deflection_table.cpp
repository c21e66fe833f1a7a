#include "render/offline/traced/deflection_table.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

using std::numbers::pi;

constexpr std::size_t nodes = 4096;
constexpr double nearest_to_edge = 1e-9; // radians
constexpr double node_error = 1e-9;

bool escapes(const sim::SkyRay& ray) {
    return ray.outcome == sim::RayOutcome::escaped;
}

// Which side of the edge a ray is on: outside, all light comes from the eye's own sky.
bool outside_edge(const sim::SkyRay& ray) {
    return escapes(ray) && ray.infinity.side > 0;
}

glm::dvec3 any_across(const glm::dvec3& axis) {
    const glm::dvec3 helper = std::abs(axis.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(helper - glm::dot(helper, axis) * axis);
}

} // namespace

std::optional<RadialSymmetry> radial_symmetry(const sim::AnySpacetime& spacetime, const sim::Components<double>& event,
                                              const sim::Tetrad& tetrad) {
    if (!std::holds_alternative<sim::Schwarzschild>(spacetime) &&
        !std::holds_alternative<sim::ReissnerNordstroem>(spacetime) &&
        !std::holds_alternative<sim::Wormhole>(spacetime)) {
        return std::nullopt;
    }
    RadialSymmetry symmetry;
    symmetry.chart_outward = glm::normalize(sim::space(event));
    const glm::dvec3 motion = sim::space(tetrad.legs[0]);
    if (glm::length(glm::cross(motion, symmetry.chart_outward)) > 1e-12 * std::abs(tetrad.legs[0].t)) {
        return std::nullopt;
    }
    // The legs' parts across the radius, in the chart, tell which head directions are across: conformal to them.
    const sim::Components<double> radial{0.0, symmetry.chart_outward.x, symmetry.chart_outward.y,
                                         symmetry.chart_outward.z};
    const sim::SymmetricTensor<double> g =
        std::visit([&](const auto& chosen) { return chosen.metric(event); }, spacetime);
    const sim::Components<double> lowered = g * radial;
    const glm::dvec3 outward(sim::contract(tetrad.legs[1], lowered), sim::contract(tetrad.legs[2], lowered),
                             sim::contract(tetrad.legs[3], lowered));
    symmetry.head_outward = glm::normalize(outward);
    symmetry.head_across[0] = any_across(symmetry.head_outward);
    symmetry.head_across[1] = glm::cross(symmetry.head_outward, symmetry.head_across[0]);
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3& e = symmetry.head_across[i];
        const glm::dvec3 chart =
            e.x * sim::space(tetrad.legs[1]) + e.y * sim::space(tetrad.legs[2]) + e.z * sim::space(tetrad.legs[3]);
        symmetry.chart_across[i] =
            glm::normalize(chart - glm::dot(chart, symmetry.chart_outward) * symmetry.chart_outward);
    }
    return symmetry;
}

DeflectionTable::DeflectionTable(sim::SkyTracer tracer, const RadialSymmetry& symmetry)
    : tracer_(std::move(tracer)), symmetry_(symmetry) {
    std::vector<glm::dvec3> sample;
    for (double psi = 0.05; psi < pi; psi += 0.05) {
        sample.push_back(std::sin(psi) * symmetry_.head_across[0] - std::cos(psi) * symmetry_.head_outward);
    }
    tracer_.choose_step(sample, node_error, 0.9);
    edge_ = find_edge();
    inner_ = branch(edge_, 0.0);
    outer_ = branch(edge_, pi);
    const double near_psi = 0.5 * (edge_ + pi);
    const double near_frequency = ray_at(near_psi).infinity.frequency;
    const double far_frequency = ray_at(pi).infinity.frequency;
    frequency_slope_ = (near_frequency - far_frequency) / (-1.0 - std::cos(near_psi));
    frequency_constant_ = far_frequency - frequency_slope_;
    error_ = measured_error();
}

sim::SkyRay DeflectionTable::ray_at(double psi) const {
    const glm::dvec3 direction = std::sin(psi) * symmetry_.head_across[0] - std::cos(psi) * symmetry_.head_outward;
    sim::SkyRay ray;
    tracer_.trace(std::span(&direction, 1), std::span(&ray, 1));
    return ray;
}

double DeflectionTable::theta_of(const sim::SkyRay& ray) const {
    return std::atan2(glm::dot(ray.infinity.direction, symmetry_.chart_across[0]),
                      glm::dot(ray.infinity.direction, symmetry_.chart_outward));
}

double DeflectionTable::find_edge() const {
    double low = 0.0;
    double high = pi;
    while (high - low > 1e-15) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) {
            break;
        }
        (outside_edge(ray_at(middle)) ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

DeflectionTable::Branch DeflectionTable::branch(double edge, double end) const {
    Branch result;
    const double sign = end > edge ? 1.0 : -1.0;
    const sim::SkyRay middle = ray_at(0.5 * (edge + end));
    result.escapes = escapes(middle);
    result.fate = !result.escapes ? RayFate::captured : middle.infinity.side > 0 ? RayFate::sky : RayFate::other_sky;
    if (!result.escapes) {
        return result;
    }
    result.first_ln = std::log(nearest_to_edge);
    result.step_ln = (std::log(std::abs(end - edge)) - result.first_ln) / (nodes - 1);
    std::vector<glm::dvec3> directions;
    for (std::size_t i = 0; i < nodes; ++i) {
        const double psi = edge + sign * std::exp(result.first_ln + result.step_ln * static_cast<double>(i));
        directions.push_back(std::sin(psi) * symmetry_.head_across[0] - std::cos(psi) * symmetry_.head_outward);
    }
    std::vector<sim::SkyRay> rays(nodes);
    tracer_.trace(directions, rays);
    result.theta.resize(nodes);
    // From the end, where the ray is radial, towards the edge, around which it turns again and again.
    double before = theta_of(rays.back());
    for (std::size_t i = nodes; i-- > 0;) {
        const double theta = theta_of(rays[i]);
        before += std::remainder(theta - before, 2.0 * pi);
        result.theta[i] = before;
    }
    return result;
}

double DeflectionTable::interpolated(const Branch& branch, double distance) const {
    const double position =
        std::clamp((std::log(std::max(distance, nearest_to_edge)) - branch.first_ln) / branch.step_ln, 0.0,
                   static_cast<double>(nodes - 1));
    const std::size_t i = std::clamp<std::size_t>(static_cast<std::size_t>(position), 1, nodes - 3);
    const double t = position - static_cast<double>(i);
    const double* const y = &branch.theta[i - 1];
    // Lagrange's cubic through four nodes.
    return -t * (t - 1.0) * (t - 2.0) / 6.0 * y[0] + (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 * y[1] -
           (t + 1.0) * t * (t - 2.0) / 2.0 * y[2] + (t + 1.0) * t * (t - 1.0) / 6.0 * y[3];
}

double DeflectionTable::measured_error() const {
    double largest = 0.0;
    for (const Branch* const branch : {&inner_, &outer_}) {
        for (std::size_t i = 0; branch->escapes && i + 64 < nodes; i += 64) {
            const double distance = std::exp(branch->first_ln + branch->step_ln * (static_cast<double>(i) + 0.5));
            if (distance > 1e-6) {
                const double psi = branch == &outer_ ? edge_ + distance : edge_ - distance;
                const double theta = interpolated(*branch, distance);
                largest = std::max(largest, std::abs(std::remainder(theta - theta_of(ray_at(psi)), 2.0 * pi)));
            }
        }
    }
    return largest;
}

void DeflectionTable::trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
                            std::size_t /*error_every*/) const {
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const glm::dvec3& n = directions[i];
        const double cosine = -glm::dot(n, symmetry_.head_outward);
        const double x = glm::dot(n, symmetry_.head_across[0]);
        const double y = glm::dot(n, symmetry_.head_across[1]);
        const double sine = std::hypot(x, y);
        const double psi = std::atan2(sine, cosine);
        const Branch& branch = psi > edge_ ? outer_ : inner_;
        TracedRay ray;
        ray.fate = branch.fate;
        ray.error = static_cast<float>(error_);
        if (branch.escapes) {
            const double theta = interpolated(branch, std::abs(psi - edge_));
            const double per_sine = sine > 0.0 ? std::sin(theta) / sine : 0.0;
            ray.direction = std::cos(theta) * symmetry_.chart_outward +
                            per_sine * (x * symmetry_.chart_across[0] + y * symmetry_.chart_across[1]);
            ray.wavelength_ratio = frequency_constant_ - frequency_slope_ * cosine;
        }
        rays[i] = ray;
    }
}

} // namespace render
