#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sim {

/// A curve through points at rising times that has two continuous derivatives: a cubic on every stretch. `Value`: a
/// double or a glm vector of them.
///
/// The slopes m_i at the knots solve, with h_i = t_{i+1} - t_i and d_i = (x_{i+1} - x_i) / h_i,
/// h_i m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_{i-1} m_{i+1} = 3 (h_i d_{i-1} + h_{i-1} d_i): equal second derivatives.
template <class Value>
class CubicSpline {
  public:
    /// How it begins and ends.
    enum class Ends {
        free,    ///< second derivative zero: uniformly, as if it had come from afar
        at_rest, ///< first derivative zero
    };

    /// At least one point; times must rise. A single point is a curve that stays there.
    CubicSpline(std::vector<double> times, std::vector<Value> values, Ends ends)
        : times_(std::move(times)), values_(std::move(values)), slopes_(values_.size(), Value(0.0)) {
        if (values_.size() > 1) {
            solve(ends);
        }
    }

    /// Beyond the ends it goes on with the cubic of the last stretch.
    Value value(double time) const {
        if (values_.size() == 1) {
            return values_.front();
        }
        const std::size_t i = stretch(time);
        const double h = length(i);
        const double s = (time - times_[i]) / h;
        const double r = 1.0 - s;
        return r * r * (1.0 + 2.0 * s) * values_[i] + s * s * (3.0 - 2.0 * s) * values_[i + 1] +
               (h * s * r) * (r * slopes_[i] - s * slopes_[i + 1]);
    }
    Value derivative(double time) const {
        if (values_.size() == 1) {
            return Value(0.0);
        }
        const std::size_t i = stretch(time);
        const double s = (time - times_[i]) / length(i);
        const double r = 1.0 - s;
        const Derivative d = derivative_on(i);
        return r * r * d.begin + 2.0 * r * s * d.middle + s * s * d.end;
    }

    /// The derivative on a stretch as a Bezier curve of degree 2 in s from 0 to 1: it lies within its three points'
    /// hull.
    struct Derivative {
        Value begin;
        Value middle;
        Value end;
    };
    Derivative derivative_on(std::size_t stretch) const {
        return {slopes_[stretch], 3.0 * chord(stretch) - slopes_[stretch] - slopes_[stretch + 1], slopes_[stretch + 1]};
    }
    std::size_t stretches() const { return values_.size() - 1; }
    const std::vector<double>& times() const { return times_; }

  private:
    double length(std::size_t i) const { return times_[i + 1] - times_[i]; }
    Value chord(std::size_t i) const { return (1.0 / length(i)) * (values_[i + 1] - values_[i]); }
    std::size_t stretch(double time) const {
        std::size_t i = 0;
        while (i + 2 < times_.size() && time >= times_[i + 1]) {
            ++i;
        }
        return i;
    }

    // Thomas's algorithm for a tridiagonal matrix; it is dominated by its diagonal.
    void solve(Ends ends) {
        const std::size_t last = values_.size() - 1;
        const bool rests = ends == Ends::at_rest;
        std::vector<double> above(values_.size());
        const auto eliminate = [&](std::size_t i, double below, double diagonal, double next, const Value& right) {
            const double pivot = i == 0 ? diagonal : diagonal - below * above[i - 1];
            above[i] = next / pivot;
            slopes_[i] = (1.0 / pivot) * (i == 0 ? right : right - below * slopes_[i - 1]);
        };
        eliminate(0, 0.0, rests ? 1.0 : 2.0, rests ? 0.0 : 1.0, rests ? Value(0.0) : 3.0 * chord(0));
        for (std::size_t i = 1; i < last; ++i) {
            const double before = length(i - 1);
            const double after = length(i);
            eliminate(i, after, 2.0 * (before + after), before, 3.0 * (after * chord(i - 1) + before * chord(i)));
        }
        eliminate(last, rests ? 0.0 : 1.0, rests ? 1.0 : 2.0, 0.0, rests ? Value(0.0) : 3.0 * chord(last - 1));
        for (std::size_t i = last; i > 0; --i) {
            slopes_[i - 1] -= above[i - 1] * slopes_[i];
        }
    }

    std::vector<double> times_;
    std::vector<Value> values_;
    std::vector<Value> slopes_;
};

} // namespace sim
