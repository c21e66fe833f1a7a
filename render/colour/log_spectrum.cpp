#include "render/colour/log_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace render {
namespace {

/// Sums a light over each step between samples by Gauss's two points, anew between all of its bends, and shares what is
/// found at a point among the two samples beside it.
void add_averages(const content::Spectrum& light, const std::vector<double>& bends, LogSpectrum& spectrum) {
    const double half_gap = 0.5 / std::sqrt(3.0);
    auto bend = bends.begin();
    for (std::size_t i = 0; i + 1 < spectrum.values.size(); ++i) {
        const double ln_left = (spectrum.first + static_cast<int>(i)) * ln_wavelength_step;
        const double left = std::exp(ln_left);
        const double right = std::exp(ln_left + ln_wavelength_step);
        if (right < light.shortest_nm() || left > light.longest_nm()) {
            continue;
        }
        bend = std::upper_bound(bend, bends.end(), left);
        double from = left;
        while (from < right) {
            const double to = bend != bends.end() && *bend < right ? *bend++ : right;
            for (const double side : {-half_gap, half_gap}) {
                const double nm = 0.5 * (from + to) + side * (to - from);
                const double share = (std::log(nm) - ln_left) / ln_wavelength_step;
                const double value = light.at(nm) * 0.5 * (to - from) / (nm * ln_wavelength_step);
                spectrum.values[i] += (1.0 - share) * value;
                spectrum.values[i + 1] += share * value;
            }
            from = to;
        }
    }
}

LogSpectrum product(const LogSpectrum& a, const LogSpectrum& b) {
    LogSpectrum result{std::max(a.first, b.first), {}};
    const int last = std::min(a.last(), b.last());
    for (int i = result.first; i <= last; ++i) {
        result.values.push_back(a.values[static_cast<std::size_t>(i - a.first)] *
                                b.values[static_cast<std::size_t>(i - b.first)]);
    }
    return result;
}

/// Calls make(shift, term index) for every column of the tables.
template <class Make>
TermTables tables(const StepRange& shifts, int stride, std::size_t count, const Make& make) {
    const int first = static_cast<int>(std::floor(static_cast<double>(shifts.first) / stride));
    const int last = std::max(static_cast<int>(std::ceil(static_cast<double>(shifts.last) / stride)), first + 3);
    TermTables result;
    for (std::size_t term = 0; term < count; term += 3) {
        std::vector<glm::dmat3> values;
        for (int i = first; i <= last; ++i) {
            glm::dmat3 columns(0.0);
            for (std::size_t j = 0; j < std::min<std::size_t>(3, count - term); ++j) {
                columns[static_cast<int>(j)] = make(stride * i, term + j);
            }
            values.push_back(columns);
        }
        const double step = stride * ln_wavelength_step;
        result.emplace_back(first * step, step, std::move(values));
    }
    return result;
}

} // namespace

LogSpectrum log_samples(const StepRange& range, const content::Spectrum& light) {
    if (const auto kelvin = light.black_body_kelvin()) {
        const double c2_over_t = content::second_radiation_constant_nm_kelvin / *kelvin;
        const double longest = std::exp(range.last * ln_wavelength_step);
        return log_samples(range, [&](double nm) {
            const double x = c2_over_t / nm;
            return std::pow(longest / nm, 5.0) * std::exp(c2_over_t / longest - x) / -std::expm1(-x);
        });
    }
    const std::vector<double> bends = light.bends();
    if (bends.empty()) {
        return log_samples(range, [&](double nm) { return light.at(nm); });
    }
    LogSpectrum spectrum = log_samples(range, [](double) { return 0.0; });
    add_averages(light, bends, spectrum);
    return spectrum;
}

LogObserver::LogObserver(const Observer& observer) {
    first_ = static_cast<int>(std::ceil(std::log(Observer::first_nm) / ln_wavelength_step));
    const int last = static_cast<int>(std::floor(std::log(Observer::last_nm) / ln_wavelength_step));
    for (int i = first_; i <= last; ++i) {
        const double nm = std::exp(i * ln_wavelength_step);
        const glm::dvec3 weight = nm * ln_wavelength_step * observer.matching(nm); // d lambda = lambda d ln lambda
        x_.push_back(weight.x);
        y_.push_back(weight.y);
        z_.push_back(weight.z);
    }
}

StepRange LogObserver::shifts(double shortest_nm, double longest_nm) const {
    return {first_ - static_cast<int>(std::ceil(std::log(longest_nm) / ln_wavelength_step)),
            last() - static_cast<int>(std::floor(std::log(shortest_nm) / ln_wavelength_step))};
}

glm::dvec3 LogObserver::xyz(const LogSpectrum& emitted, int shift) const {
    const int from = std::max(first_, emitted.first + shift);
    const int to = std::min(last(), emitted.last() + shift);
    if (from > to) {
        return glm::dvec3(0.0);
    }
    const auto count = static_cast<std::size_t>(to - from + 1);
    const double* x = x_.data() + (from - first_);
    const double* y = y_.data() + (from - first_);
    const double* z = z_.data() + (from - first_);
    const double* values = emitted.values.data() + (from - shift - emitted.first);
    // Four sums each, side by side: the order in which vectors of the processor add.
    constexpr std::size_t lanes = 4;
    std::array<double, lanes> sum_x{};
    std::array<double, lanes> sum_y{};
    std::array<double, lanes> sum_z{};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sum_x[lane] += x[i + lane] * values[i + lane];
            sum_y[lane] += y[i + lane] * values[i + lane];
            sum_z[lane] += z[i + lane] * values[i + lane];
        }
    }
    for (; i < count; ++i) {
        sum_x[0] += x[i] * values[i];
        sum_y[0] += y[i] * values[i];
        sum_z[0] += z[i] * values[i];
    }
    return {(sum_x[0] + sum_x[1]) + (sum_x[2] + sum_x[3]), (sum_y[0] + sum_y[1]) + (sum_y[2] + sum_y[3]),
            (sum_z[0] + sum_z[1]) + (sum_z[2] + sum_z[3])};
}

TermTables shifted_terms(const LogObserver& observer, const LogSpectrum& light, std::span<const LogSpectrum> terms,
                         const StepRange& shifts, int stride) {
    std::vector<LogSpectrum> sent;
    for (const LogSpectrum& term : terms) {
        sent.push_back(product(term, light));
    }
    return tables(shifts, stride, terms.size(),
                  [&](int shift, std::size_t term) { return observer.xyz(sent[term], shift); });
}

TermTables shifted_averages(const LogObserver& observer, const LogSpectrum& light, std::span<const LogSpectrum> terms,
                            const StepRange& shifts, int stride) {
    std::vector<LogSpectrum> sent;
    for (const LogSpectrum& term : terms) {
        sent.push_back(product(term, light));
    }
    const auto at_red_end = [&](int shift, const LogSpectrum& term) {
        return term.values[static_cast<std::size_t>(observer.emitted({shift, shift}).last - term.first)];
    };
    constexpr double nothing = 1e-290; // less has lost its digits
    int white_shift = shifts.first - 1;
    glm::dvec3 white(0.0);
    return tables(shifts, stride, terms.size(), [&](int shift, std::size_t term) {
        if (shift != white_shift) {
            white = observer.xyz(light, shift);
            white_shift = shift;
        }
        glm::dvec3 average = observer.xyz(sent[term], shift);
        for (int i = 0; i < 3; ++i) {
            average[i] = white[i] > nothing ? average[i] / white[i] : at_red_end(shift, terms[term]);
        }
        return average;
    });
}

} // namespace render
