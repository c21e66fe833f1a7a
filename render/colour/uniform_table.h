#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace render {

/// A smooth function tabulated at even steps and interpolated by cubic Hermite pieces with central-difference slopes
/// (error of order step^3 f'''... at worst step^4 f''''/30 inside); beyond its ends it keeps the value there.
template <class Value>
class UniformTable {
  public:
    UniformTable() = default;

    /// Samples `f(x)` at `count` >= 4 even steps over [first, last].
    template <class Function>
    UniformTable(double first, double last, std::size_t count, const Function& f)
        : first_(first), per_unit_(static_cast<double>(count - 1) / (last - first)) {
        values_.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            values_.push_back(f(first + static_cast<double>(i) / per_unit_));
        }
    }

    Value at(double x) const {
        const double position = std::clamp((x - first_) * per_unit_, 0.0, static_cast<double>(values_.size() - 1));
        const std::size_t i = std::min(static_cast<std::size_t>(position), values_.size() - 2);
        const double t = position - static_cast<double>(i);
        const Value& a = values_[i];
        const Value& b = values_[i + 1];
        const Value slope_a = slope(i);
        const Value slope_b = slope(i + 1);
        const Value rise = b - a;
        return a + t * (slope_a + t * ((3.0 * rise - 2.0 * slope_a - slope_b) + t * (slope_a + slope_b - 2.0 * rise)));
    }

  private:
    Value slope(std::size_t i) const {
        const std::size_t left = i == 0 ? 0 : i - 1;
        const std::size_t right = std::min(i + 1, values_.size() - 1);
        return (1.0 / static_cast<double>(right - left)) * (values_[right] - values_[left]);
    }

    double first_ = 0.0;
    double per_unit_ = 1.0;
    std::vector<Value> values_;
};

} // namespace render
