#include "content/spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace content {

double TabulatedSpectrum::at(double wavelength_nm) const {
    const double position = (wavelength_nm - first_nm) / step_nm;
    const auto last = static_cast<double>(values.size() - 1);
    if (beyond == Beyond::zero && (position < 0.0 || position > last)) {
        return 0.0;
    }
    const double clamped = std::clamp(position, 0.0, last);
    const auto left = std::min(static_cast<std::size_t>(clamped), values.size() - 2);
    const double fraction = clamped - static_cast<double>(left);
    return values[left] + fraction * (values[left + 1] - values[left]);
}

double black_body_radiance(double wavelength_nm, double temperature_kelvin) {
    const double metres = 1e-9 * wavelength_nm;
    const double x = second_radiation_constant_nm_kelvin / (wavelength_nm * temperature_kelvin);
    return first_radiation_constant / (std::pow(metres, 5.0) * std::expm1(x));
}

double SampledSpectrum::at(double wavelength_nm) const {
    const bool inside = wavelength_nm >= nanometres.front() && wavelength_nm <= nanometres.back();
    if (!inside && beyond == TabulatedSpectrum::Beyond::zero) {
        return 0.0;
    }
    const auto right = std::upper_bound(nanometres.begin(), nanometres.end(), wavelength_nm);
    if (right == nanometres.begin()) {
        return values.front();
    }
    if (right == nanometres.end()) {
        return values.back();
    }
    const auto i = static_cast<std::size_t>(right - nanometres.begin());
    const double fraction = (wavelength_nm - nanometres[i - 1]) / (nanometres[i] - nanometres[i - 1]);
    return values[i - 1] + fraction * (values[i] - values[i - 1]);
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Support {
    double first = 0.0;
    double last = infinity;
};

Support support_of(const Spectrum::Factor& factor) {
    if (const auto* even = std::get_if<TabulatedSpectrum>(&factor)) {
        const double last = even->first_nm + even->step_nm * static_cast<double>(even->values.size() - 1);
        return even->beyond == TabulatedSpectrum::Beyond::zero ? Support{even->first_nm, last} : Support{};
    }
    if (const auto* sampled = std::get_if<SampledSpectrum>(&factor)) {
        const bool ends = sampled->beyond == TabulatedSpectrum::Beyond::zero;
        return ends ? Support{sampled->nanometres.front(), sampled->nanometres.back()} : Support{};
    }
    return {};
}

} // namespace

double Spectrum::at(double wavelength_nm) const {
    double sum = 0.0;
    for (const Part& part : parts_) {
        double product = part.scale;
        for (const Factor& factor : part.factors) {
            product *= std::visit([&](const auto& f) { return f.at(wavelength_nm); }, factor);
        }
        sum += product;
    }
    return sum;
}

std::optional<double> Spectrum::black_body_kelvin() const {
    if (parts_.size() != 1 || parts_.front().factors.size() != 1) {
        return std::nullopt;
    }
    const auto* body = std::get_if<BlackBody>(&parts_.front().factors.front());
    return body != nullptr ? std::optional(body->kelvin) : std::nullopt;
}

double Spectrum::shortest_nm() const {
    double shortest = infinity;
    for (const Part& part : parts_) {
        double first = 0.0;
        for (const Factor& factor : part.factors) {
            first = std::max(first, support_of(factor).first);
        }
        shortest = std::min(shortest, first);
    }
    return shortest;
}

double Spectrum::longest_nm() const {
    double longest = 0.0;
    for (const Part& part : parts_) {
        double last = infinity;
        for (const Factor& factor : part.factors) {
            last = std::min(last, support_of(factor).last);
        }
        longest = std::max(longest, last);
    }
    return longest;
}

std::vector<double> Spectrum::bends() const {
    std::vector<double> all;
    for (const Part& part : parts_) {
        for (const Factor& factor : part.factors) {
            if (const auto* even = std::get_if<TabulatedSpectrum>(&factor)) {
                for (std::size_t i = 0; i < even->values.size(); ++i) {
                    all.push_back(even->first_nm + even->step_nm * static_cast<double>(i));
                }
            } else if (const auto* sampled = std::get_if<SampledSpectrum>(&factor)) {
                all.insert(all.end(), sampled->nanometres.begin(), sampled->nanometres.end());
            }
        }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

Spectrum& Spectrum::operator+=(const Spectrum& other) {
    const std::vector<Part> added = other.parts_; // `other` may be this
    parts_.insert(parts_.end(), added.begin(), added.end());
    return *this;
}

Spectrum operator*(double scale, const Spectrum& spectrum) {
    Spectrum result = spectrum;
    for (Spectrum::Part& part : result.parts_) {
        part.scale *= scale;
    }
    return result;
}

Spectrum operator*(const Spectrum& a, const Spectrum& b) {
    Spectrum result;
    for (const Spectrum::Part& left : a.parts_) {
        for (const Spectrum::Part& right : b.parts_) {
            Spectrum::Part part{left.scale * right.scale, left.factors};
            part.factors.insert(part.factors.end(), right.factors.begin(), right.factors.end());
            result.parts_.push_back(std::move(part));
        }
    }
    return result;
}

} // namespace content
