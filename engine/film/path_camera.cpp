#include "engine/film/path_camera.h"

#include "engine/picture_request.h"
#include "sim/bad_input.h"
#include "sim/look.h"
#include "sim/lorentz.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace engine {
namespace {

template <class Value, class Read>
sim::CubicSpline<Value> spline_of(const content::CameraPath& path, Read read) {
    std::vector<double> times;
    std::vector<Value> values;
    for (const content::CameraKeyframe& keyframe : path.keyframes) {
        times.push_back(keyframe.time);
        values.push_back(read(keyframe));
    }
    using Ends = typename sim::CubicSpline<Value>::Ends;
    return {std::move(times), std::move(values), path.ends_rest ? Ends::at_rest : Ends::free};
}

glm::dvec3 rapidity_vector(const glm::dvec3& velocity) {
    const double speed = glm::length(velocity);
    return speed > 0.0 ? std::atanh(speed) / speed * velocity : velocity;
}

using Derivative = sim::CubicSpline<glm::dvec3>::Derivative;

/// Where on a stretch, from 0 to 1, the curve is as long as `limit` or longer; none: nowhere. By the hull of its
/// points, halved until it is within the limit everywhere or one of its own points is not.
std::optional<double> reaches(const Derivative& curve, double limit, double from = 0.0, double to = 1.0) {
    if (glm::length(curve.begin) >= limit) {
        return from;
    }
    if (glm::length(curve.end) >= limit) {
        return to;
    }
    constexpr double as_good_as_there = 1e-9;
    if (glm::length(curve.middle) < limit || to - from < as_good_as_there) {
        return std::nullopt;
    }
    const glm::dvec3 left = 0.5 * (curve.begin + curve.middle);
    const glm::dvec3 right = 0.5 * (curve.middle + curve.end);
    const glm::dvec3 halfway = 0.5 * (left + right);
    const double middle = 0.5 * (from + to);
    const std::optional<double> first = reaches({curve.begin, left, halfway}, limit, from, middle);
    return first ? first : reaches({halfway, right, curve.end}, limit, middle, to);
}

std::vector<std::optional<render::Mode>> modes_of(const content::CameraPath& path) {
    std::vector<std::optional<render::Mode>> modes;
    for (std::size_t i = 0; i < path.keyframes.size(); ++i) {
        const std::string& mode = path.keyframes[i].mode;
        if (mode.empty()) {
            modes.push_back(i == 0 ? std::nullopt : modes.back());
            continue;
        }
        const auto known = std::ranges::find(mode_names, mode, &std::pair<std::string_view, render::Mode>::first);
        if (known == mode_names.end()) {
            throw sim::BadInput(path.file.string(), content::CameraPath::name_of(i, "mode"), mode,
                                "must be geometry, doppler, searchlight or full");
        }
        modes.emplace_back(known->second);
    }
    return modes;
}

} // namespace

PathCamera::PathCamera(content::CameraPath path, double metres_per_light_unit)
    : path_(std::move(path)), metres_per_light_unit_(metres_per_light_unit),
      position_(spline_of<glm::dvec3>(
          path_, [this](const content::CameraKeyframe& k) { return k.position / metres_per_light_unit_; })),
      sight_(spline_of<glm::dvec3>(
          path_,
          [this](const content::CameraKeyframe& k) { return k.look ? *k.look : *k.look_at / metres_per_light_unit_; })),
      roll_(spline_of<double>(path_, [](const content::CameraKeyframe& k) { return k.roll; })),
      log_tangent_(spline_of<double>(
          path_,
          [](const content::CameraKeyframe& k) { return std::log(std::tan(0.5 * k.horizontal_field_of_view)); })),
      modes_(modes_of(path_)) {
    if (path_.keyframes.front().velocity) {
        rapidity_ =
            spline_of<glm::dvec3>(path_, [](const content::CameraKeyframe& k) { return rapidity_vector(*k.velocity); });
        return;
    }
    refuse_faster_than_light();
    clock_.push_back(0.0);
    for (std::size_t i = 0; i + 1 < position_.times().size(); ++i) {
        clock_.push_back(clock_.back() + clock_over(position_.times()[i], position_.times()[i + 1]));
    }
}

void PathCamera::refuse_faster_than_light() const {
    for (std::size_t i = 0; i < position_.stretches(); ++i) {
        if (const std::optional<double> there = reaches(position_.derivative_on(i), 1.0)) {
            const double time = position_.times()[i] + *there * (position_.times()[i + 1] - position_.times()[i]);
            throw sim::BadInput(path_.file.string(), content::CameraPath::name_of(i, "position"),
                                fmt::format("{:.6g} c at time {:.6g}", glm::length(velocity(time)), time),
                                "from here to the next keyframe the path is as fast as light: give it more time");
        }
    }
}

glm::dvec3 PathCamera::velocity(double time) const {
    if (!rapidity_) {
        return position_.derivative(time);
    }
    const glm::dvec3 rapidity = rapidity_->value(time);
    const double xi = glm::length(rapidity);
    return xi > 0.0 ? std::tanh(xi) / xi * rapidity : rapidity;
}

glm::dvec3 PathCamera::look(const Pose& pose, double time) const {
    glm::dvec3 sight = sight_.value(time);
    if (path_.keyframes.front().look_at) {
        sight -= position_.value(time);
    }
    const double length = glm::length(sight);
    if (!(length > 0.0)) {
        throw sim::BadInput(path_.file.string(), "", fmt::format("time {:.6g}", time), "the eye has nowhere to look");
    }
    sight /= length;
    return path_.keyframes.front().look_at
               ? sim::where_seen(sim::boosted_eye(pose.velocity), sim::Direction<sim::World>{sight}).head_direction
               : sight;
}

PathCamera::Pose PathCamera::at(double time) const {
    Pose pose;
    pose.position = position_.value(time) * metres_per_light_unit_;
    pose.velocity = velocity(time);
    const glm::dvec3 rapidity = rapidity_ ? rapidity_->value(time) : rapidity_vector(pose.velocity);
    const double xi = glm::length(rapidity);
    const glm::dvec3 heading = xi > 0.0 ? rapidity / xi : glm::dvec3(0.0, 0.0, -1.0);
    pose.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(xi), heading, look(pose, time)) *
        sim::rotation<sim::Head, sim::Head>(sim::Radians(-roll_.value(time)), glm::dvec3(0.0, 0.0, 1.0));
    pose.horizontal_field_of_view = 2.0 * std::atan(std::exp(log_tangent_.value(time)));
    const std::vector<double>& times = position_.times();
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    pose.mode = modes_[after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1];
    return pose;
}

// Gauss's rule of five points on parts of a stretch: of order 10, and the integrand is smooth while v < 1.
double PathCamera::clock_over(double from, double to) const {
    constexpr std::array<double, 3> nodes{0.0, 0.53846931010568309104, 0.90617984593866399280};
    constexpr std::array<double, 3> weights{0.56888888888888888889, 0.47862867049936646804, 0.23692688505618908751};
    constexpr int parts = 64;
    const double half = 0.5 * (to - from) / parts;
    const auto rate = [this](double time) {
        const glm::dvec3 v = velocity(time);
        return std::sqrt(std::max(0.0, (1.0 - glm::length(v)) * (1.0 + glm::length(v))));
    };
    double sum = 0.0;
    for (int part = 0; part < parts; ++part) {
        const double middle = from + (2 * part + 1) * half;
        sum += weights[0] * rate(middle);
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            sum += weights.at(i) * (rate(middle - nodes.at(i) * half) + rate(middle + nodes.at(i) * half));
        }
    }
    return half * sum;
}

sim::ProperTime PathCamera::proper_time(double time) const {
    const std::vector<double>& times = position_.times();
    std::size_t i = 0;
    while (i + 2 < times.size() && time >= times[i + 1]) {
        ++i;
    }
    return sim::ProperTime(clock_.at(i) + clock_over(times[i], time));
}

double PathCamera::world_time(sim::ProperTime clock) const {
    double low = first();
    double high = last();
    constexpr int halvings = 60; // down to a double's last digits
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (proper_time(middle).value < clock.value ? low : high) = middle;
    }
    return high;
}

bool PathCamera::has_modes() const {
    return std::ranges::any_of(modes_, [](const std::optional<render::Mode>& mode) { return mode.has_value(); });
}

} // namespace engine
