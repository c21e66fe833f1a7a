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

/// A light sent on by a term, apart what the term does everywhere: of a line on white only the line is left to sum.
struct SentLight {
    double level = 0.0;
    LogSpectrum above_level;
};

SentLight sent_light(const LogSpectrum& term, const LogSpectrum& light) {
    const double level = term.values.back();
    const auto differs = [level](double value) { return value != level; };
    const auto first = std::find_if(term.values.begin(), term.values.end(), differs);
    const auto last = std::find_if(term.values.rbegin(), term.values.rend(), differs).base();
    LogSpectrum above{term.first + static_cast<int>(first - term.values.begin()), {}};
    for (auto value = first; value < last; ++value) {
        above.values.push_back(*value - level);
    }
    return {level, product(above, light)};
}

std::vector<SentLight> sent_lights(std::span<const LogSpectrum> terms, const LogSpectrum& light) {
    std::vector<SentLight> sent;
    sent.reserve(terms.size());
    for (const LogSpectrum& term : terms) {
        sent.push_back(sent_light(term, light));
    }
    return sent;
}

/// Which strides the tables hold.
StepRange strides_of(const StepRange& shifts, int stride) {
    const int first = static_cast<int>(std::floor(static_cast<double>(shifts.first) / stride));
    const int last = static_cast<int>(std::ceil(static_cast<double>(shifts.last) / stride));
    return {first, std::max(last, first + 3)};
}

/// The light's own XYZ at each stride.
std::vector<glm::dvec3> white_light(const LogObserver& observer, const LogSpectrum& light, const StepRange& strides,
                                    int stride) {
    std::vector<glm::dvec3> white;
    for (int i = strides.first; i <= strides.last; ++i) {
        white.push_back(observer.xyz(light, stride * i));
    }
    return white;
}

/// Calls make(stride index, term index) for every column of the tables; the first stride has index 0.
template <class Make>
TermTables tables(const StepRange& strides, int stride, std::size_t count, const Make& make) {
    TermTables result;
    for (std::size_t term = 0; term < count; term += 3) {
        std::vector<glm::dmat3> values;
        for (std::size_t i = 0; i <= static_cast<std::size_t>(strides.last - strides.first); ++i) {
            glm::dmat3 columns(0.0);
            for (std::size_t j = 0; j < std::min<std::size_t>(3, count - term); ++j) {
                columns[static_cast<int>(j)] = make(i, term + j);
            }
            values.push_back(columns);
        }
        const double step = stride * ln_wavelength_step;
        result.emplace_back(strides.first * step, step, std::move(values));
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
    const std::size_t count = StepRange{from, to}.count();
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
    const std::vector<SentLight> sent = sent_lights(terms, light);
    const StepRange strides = strides_of(shifts, stride);
    const std::vector<glm::dvec3> white = white_light(observer, light, strides, stride);
    return tables(strides, stride, terms.size(), [&](std::size_t i, std::size_t term) {
        const int shift = stride * (strides.first + static_cast<int>(i));
        return sent[term].level * white[i] + observer.xyz(sent[term].above_level, shift);
    });
}

TermTables shifted_averages(const LogObserver& observer, const LogSpectrum& light, std::span<const LogSpectrum> terms,
                            const StepRange& shifts, int stride) {
    const std::vector<SentLight> sent = sent_lights(terms, light);
    const StepRange strides = strides_of(shifts, stride);
    const std::vector<glm::dvec3> white = white_light(observer, light, strides, stride);
    const auto at_red_end = [&](int shift, const LogSpectrum& term) {
        return term.values[static_cast<std::size_t>(observer.emitted({shift, shift}).last - term.first)];
    };
    constexpr double nothing = 1e-290; // less has lost its digits
    return tables(strides, stride, terms.size(), [&](std::size_t i, std::size_t term) {
        const int shift = stride * (strides.first + static_cast<int>(i));
        glm::dvec3 average = observer.xyz(sent[term].above_level, shift);
        for (int j = 0; j < 3; ++j) {
            average[j] =
                white[i][j] > nothing ? sent[term].level + average[j] / white[i][j] : at_red_end(shift, terms[term]);
        }
        return average;
    });
}

} // namespace render
