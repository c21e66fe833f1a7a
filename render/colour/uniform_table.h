#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace render {

/// A smooth function tabulated at even steps and interpolated by cubic Hermite pieces whose slopes are differences over
/// five samples: exact for quartics' slopes, error step^4 f''''/384 inside; beyond its ends it keeps the value there.
template <class Value>
class UniformTable {
  public:
    UniformTable() = default;

    /// `values`, at least 4, of first, first + step, ...
    UniformTable(double first, double step, std::vector<Value> values)
        : first_(first), per_unit_(1.0 / step), values_(std::move(values)) {
        slopes_.reserve(values_.size());
        for (std::size_t i = 0; i < values_.size(); ++i) {
            slopes_.push_back(slope(i));
        }
    }

    /// Samples `f(x)` at `count` >= 4 even steps over [first, last].
    template <class Function>
    UniformTable(double first, double last, std::size_t count, const Function& f)
        : UniformTable(first, (last - first) / static_cast<double>(count - 1), sampled(first, last, count, f)) {}

    Value at(double x) const {
        const double position = std::clamp((x - first_) * per_unit_, 0.0, static_cast<double>(values_.size() - 1));
        const std::size_t i = std::min(static_cast<std::size_t>(position), values_.size() - 2);
        const double t = position - static_cast<double>(i);
        const Value& a = values_[i];
        const Value rise = values_[i + 1] - a;
        const Value& slope_a = slopes_[i];
        const Value& slope_b = slopes_[i + 1];
        return a + t * (slope_a + t * ((3.0 * rise - 2.0 * slope_a - slope_b) + t * (slope_a + slope_b - 2.0 * rise)));
    }

  private:
    template <class Function>
    static std::vector<Value> sampled(double first, double last, std::size_t count, const Function& f) {
        std::vector<Value> values;
        values.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            values.push_back(f(first + static_cast<double>(i) * ((last - first) / static_cast<double>(count - 1))));
        }
        return values;
    }

    /// Per step.
    Value slope(std::size_t i) const {
        const std::size_t last = values_.size() - 1;
        if (i >= 2 && i + 2 <= last) {
            return (2.0 / 3.0) * (values_[i + 1] - values_[i - 1]) - (1.0 / 12.0) * (values_[i + 2] - values_[i - 2]);
        }
        const std::size_t left = i == 0 ? 0 : i - 1;
        const std::size_t right = std::min(i + 1, last);
        return (1.0 / static_cast<double>(right - left)) * (values_[right] - values_[left]);
    }

    double first_ = 0.0;
    double per_unit_ = 1.0;
    std::vector<Value> values_;
    std::vector<Value> slopes_;
};

} // namespace render
