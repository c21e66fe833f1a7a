#include "sim/spacetime/mino_path.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

struct Planar {
    double x, y;
    friend Planar operator*(const Planar& a, const Planar& b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
    friend Planar operator+(const Planar& a, const Planar& b) { return {a.x + b.x, a.y + b.y}; }
};

/// (u x, u y, u z, u) of a state and its rate by tau into the past: u (x + i y) =
/// (1 + i a u)(N_x + i N_y) exp(i (Phi + g)), u z = N_z.
struct ChartPlace {
    glm::dvec4 place;
    glm::dvec4 rate;
};

ChartPlace chart_place(const MinoEye& eye, double angular_momentum, const MinoState<double>& s) {
    const MinoPosition<double>& y = s.y;
    const MinoPosition<double>& v = s.velocity;
    if (eye.hole.spin == 0.0) {
        return {{y.x, y.y, y.z, y.u}, {v.x, v.y, v.z, v.u}};
    }
    const double a = eye.hole.spin;
    const double turn = s.z + eye.azimuth + chart_turn(eye.hole, y.u);
    const double turn_rate =
        -mino_dragging(eye.hole, angular_momentum, y.u) -
        a * v.u / (1.0 - y.u * (2.0 * eye.hole.mass - a * a * y.u)); // g' = -a/((1 - u r_+)(1 - u r_-))
    const Planar turned{std::cos(turn), std::sin(turn)};
    const Planar stretch{1.0, a * y.u};
    const Planar n{y.x, y.y};
    const Planar at = stretch * n * turned;
    const Planar rate = (Planar{0.0, a * v.u} * n + stretch * Planar{v.x, v.y}) * turned + Planar{0.0, turn_rate} * at;
    return {{at.x, at.y, y.z, y.u}, {rate.x, rate.y, v.z, v.u}};
}

} // namespace

double chart_turn(const MinoHole& hole, double u) {
    const double outer = hole.radii.horizon;
    const double inner = 2.0 * hole.mass - outer;
    return hole.spin / (outer - inner) * std::log((1.0 - u * outer) / (1.0 - u * inner));
}

std::array<glm::dvec4, 4> MinoSegment::bezier() const {
    const ChartPlace a = chart_place(*eye, ray.angular_momentum, from);
    const ChartPlace b = chart_place(*eye, ray.angular_momentum, to);
    const double third = step / 3.0;
    return {a.place, a.place + third * a.rate, b.place - third * b.rate, b.place};
}

glm::dvec3 MinoSegment::place(double share) const {
    const double part = share * step;
    const MinoState<double> state = eye->hole.spin == 0.0 ? mino_step<false>(eye->hole, ray, from, part)
                                                          : mino_step<true>(eye->hole, ray, from, part);
    const glm::dvec4 at = chart_place(*eye, ray.angular_momentum, state).place;
    return glm::dvec3(at) / at.w;
}

MinoWatch::MinoWatch(const MinoEye& eye, const WatchedPlaces& places)
    : spin_(eye.hole.spin), azimuth_(eye.azimuth), horizon_(eye.hole.radii.horizon) {
    const double inner = 2.0 * eye.hole.mass - horizon_;
    // g = -a sum_k u^k (r_+^k - r_-^k)/(r_+ - r_-)/k, the quotient by its recurrence in k.
    double quotient = 1.0;
    double before = 0.0;
    for (std::size_t k = 0; k < turn_series_.size(); ++k) {
        turn_series_[k] = -spin_ * quotient / static_cast<double>(k + 1);
        const double next = (horizon_ + inner) * quotient - horizon_ * inner * before;
        before = quotient;
        quotient = next;
    }
    for (const WatchedBall& ball : places.balls) {
        const double speed = glm::length(ball.velocity);
        const glm::dvec3 axis = speed > 0.0 ? ball.velocity / speed : glm::dvec3(0.0);
        const glm::dvec3 centre = ball.centre_at_zero - glm::dot(ball.centre_at_zero, axis) * axis;
        const double distance = glm::length(centre);
        // The chart's distance from the origin is r, or more than r by less than a.
        const double nearest = std::max(distance - ball.radius - spin_, horizon_);
        most_inverse_radius_ = std::max(most_inverse_radius_, 1.0 / nearest);
        least_inverse_radius_ = std::min(least_inverse_radius_, speed > 0.0 ? 0.0 : 1.0 / (distance + ball.radius));
        balls_.push_back({centre, axis, ball.radius});
    }
}

} // namespace sim
