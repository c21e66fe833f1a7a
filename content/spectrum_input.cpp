#include "content/spectrum_input.h"

#include "content/csv.h"
#include "sim/bad_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace content {
namespace {

using Samples = std::vector<std::pair<double, double>>;

/// Where an input stands, for messages.
struct Place {
    std::string source;
    std::string field; ///< "" for a whole file
    std::function<std::string(std::size_t sample, bool is_value)> number;
};

constexpr double first_visible_nm = 380.0;
constexpr double last_visible_nm = 730.0;
constexpr double widest_step_nm = 50.0; ///< straight lines over more than this hide what is between
// What the tables hold of a reflectance.
constexpr double shortest_known_nm = 40.0;
constexpr double longest_known_nm = 12000.0;

void note_gaps(const SampledSpectrum& spectrum, const std::string& where, std::vector<std::string>& notes) {
    const std::vector<double>& nm = spectrum.nanometres;
    for (std::size_t i = 1; i < nm.size(); ++i) {
        if (nm[i] - nm[i - 1] > widest_step_nm && nm[i] > first_visible_nm && nm[i - 1] < last_visible_nm) {
            notes.push_back(
                fmt::format("{}: the gap from {} to {} nm is taken as a straight line", where, nm[i - 1], nm[i]));
        }
    }
    if (nm.front() > first_visible_nm || nm.back() < last_visible_nm) {
        notes.push_back(
            fmt::format("{}: known from {} to {} nm only, the visible is {} to {}; beyond it {}", where, nm.front(),
                        nm.back(), first_visible_nm, last_visible_nm,
                        spectrum.beyond == TabulatedSpectrum::Beyond::held ? "its last value is held" : "it is dark"));
    }
}

// Lines between samples are positive within a range only if a sample there or the line at one of its ends is.
bool has_visible_light(const SampledSpectrum& spectrum) {
    bool found = spectrum.at(first_visible_nm) > 0.0 || spectrum.at(last_visible_nm) > 0.0;
    for (std::size_t i = 0; i < spectrum.values.size(); ++i) {
        found |= spectrum.nanometres[i] > first_visible_nm && spectrum.nanometres[i] < last_visible_nm &&
                 spectrum.values[i] > 0.0;
    }
    return found;
}

void check_samples(const Samples& samples, SpectrumUse use, const Place& place) {
    if (samples.empty()) {
        throw sim::BadInput(place.source, place.field, "", "the spectrum is empty");
    }
    const auto fail = [&](std::size_t i, bool is_value, const std::string& reason) {
        throw sim::BadInput(place.source, place.number(i, is_value),
                            fmt::format("{}", is_value ? samples[i].second : samples[i].first), reason);
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto [nm, value] = samples[i];
        if (!(nm > 0.0)) {
            fail(i, false, "a wavelength must be positive");
        }
        if (i > 0 && !(nm > samples[i - 1].first)) {
            fail(i, false, fmt::format("wavelengths must rise; the one before is {}", samples[i - 1].first));
        }
        if (!(value >= 0.0)) {
            fail(i, true, "must not be negative");
        }
        if (use == SpectrumUse::reflectance && value > 1.0) {
            fail(i, true, "a reflectance must not be above 1");
        }
    }
    if (samples.back().first < shortest_known_nm) {
        fail(samples.size() - 1, false,
             fmt::format("the last wavelength is below {} nm: are these micrometres?", shortest_known_nm));
    }
    if (samples.front().first > longest_known_nm) {
        fail(0, false, fmt::format("the first wavelength is above {} nm", longest_known_nm));
    }
    if (use == SpectrumUse::light && samples.size() == 1) {
        fail(0, false, "a light of a single sample has no width: give two or more");
    }
}

/// A light's brightness is told elsewhere: its largest value becomes 1, so that no sum overflows or vanishes.
void scale_to_one(std::vector<double>& values) {
    const double most = *std::max_element(values.begin(), values.end());
    for (double& value : values) {
        value = most > 0.0 ? value / most : 0.0;
    }
}

/// Tables and sums hold a reflectance beyond this range as it is at the range's end.
void cut_to_known(SampledSpectrum& spectrum, const std::string& where, std::vector<std::string>& notes) {
    const std::vector<double> nm = spectrum.nanometres;
    if (nm.front() >= shortest_known_nm && nm.back() <= longest_known_nm) {
        return;
    }
    notes.push_back(
        fmt::format("{}: samples below {} and above {} nm are left out", where, shortest_known_nm, longest_known_nm));
    SampledSpectrum kept{{}, {}, spectrum.beyond};
    const auto keep = [&](double at) {
        kept.nanometres.push_back(at);
        kept.values.push_back(spectrum.at(at));
    };
    keep(std::max(nm.front(), shortest_known_nm));
    for (const double at : nm) {
        if (at > kept.nanometres.front() && at < longest_known_nm) {
            keep(at);
        }
    }
    if (nm.back() > longest_known_nm) {
        keep(longest_known_nm);
    }
    spectrum = std::move(kept);
}

Spectrum checked(const Samples& samples, SpectrumUse use, const Place& place, std::vector<std::string>& notes) {
    check_samples(samples, use, place);
    const std::string where = place.field.empty() ? place.source : place.source + ": " + place.field;
    SampledSpectrum spectrum;
    for (const auto& [nm, value] : samples) {
        spectrum.nanometres.push_back(nm);
        spectrum.values.push_back(value);
    }
    if (use == SpectrumUse::light) {
        if (!has_visible_light(spectrum)) {
            throw sim::BadInput(place.source, place.field, "",
                                fmt::format("has no light within {} to {} nm, by which its brightness is told",
                                            first_visible_nm, last_visible_nm));
        }
        scale_to_one(spectrum.values);
    } else {
        spectrum.beyond = TabulatedSpectrum::Beyond::held;
        cut_to_known(spectrum, where, notes);
    }
    note_gaps(spectrum, where, notes);
    return Spectrum(std::move(spectrum));
}

} // namespace

Spectrum checked_spectrum(const std::vector<std::pair<double, double>>& samples, SpectrumUse use,
                          const std::string& source, const std::string& field, std::vector<std::string>& notes) {
    const auto number = [&](std::size_t sample, bool is_value) {
        return fmt::format("{}[{}][{}]", field, sample, is_value ? 1 : 0);
    };
    return checked(samples, use, {source, field, number}, notes);
}

Spectrum read_spectrum(const std::filesystem::path& file, SpectrumUse use, std::vector<std::string>& notes) {
    const CsvTable table = read_csv(file);
    const std::size_t wavelength = table.column("wavelength_nm");
    const std::size_t value = table.column("value");
    Samples samples;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        samples.emplace_back(table.number(row, wavelength), table.number(row, value));
    }
    const auto number = [&](std::size_t sample, bool is_value) {
        return fmt::format("line {}, {}", table.line_numbers[sample], table.header[is_value ? value : wavelength]);
    };
    return checked(samples, use, {file.string(), "", number}, notes);
}

} // namespace content
