#include "content/spectrum_input.h"

#include "content/csv.h"
#include "sim/bad_input.h"

#include <fmt/format.h>

namespace content {
namespace {

constexpr double first_visible_nm = 380.0;
constexpr double last_visible_nm = 730.0;
constexpr double widest_step_nm = 50.0; ///< straight lines over more than this hide what is between

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

bool has_visible_light(const SampledSpectrum& spectrum) {
    for (double nm = first_visible_nm; nm <= last_visible_nm; nm += 1.0) {
        if (spectrum.at(nm) > 0.0) {
            return true;
        }
    }
    return false;
}

} // namespace

Spectrum checked_spectrum(const std::vector<std::pair<double, double>>& samples, SpectrumUse use,
                          const std::string& source, const std::string& field, std::vector<std::string>& notes) {
    if (samples.empty()) {
        throw sim::BadInput(source, field, "", "the spectrum is empty");
    }
    SampledSpectrum spectrum;
    spectrum.beyond =
        use == SpectrumUse::reflectance ? TabulatedSpectrum::Beyond::held : TabulatedSpectrum::Beyond::zero;
    const auto fail = [&](std::size_t i, double value, const std::string& reason) {
        throw sim::BadInput(source, fmt::format("{}sample {}", field.empty() ? "" : field + " ", i + 1),
                            fmt::format("{}", value), reason);
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto [nm, value] = samples[i];
        if (!(nm > 0.0)) {
            fail(i, nm, "a wavelength must be positive");
        }
        if (i > 0 && !(nm > samples[i - 1].first)) {
            fail(i, nm, fmt::format("wavelengths must rise; the one before is {}", samples[i - 1].first));
        }
        if (!(value >= 0.0)) {
            fail(i, value, "must not be negative");
        }
        if (use == SpectrumUse::reflectance && value > 1.0) {
            fail(i, value, "a reflectance must not be above 1");
        }
        spectrum.nanometres.push_back(nm);
        spectrum.values.push_back(value);
    }
    if (use == SpectrumUse::light && !has_visible_light(spectrum)) {
        throw sim::BadInput(source, field, "",
                            fmt::format("has no light within {} to {} nm, by which its brightness is told",
                                        first_visible_nm, last_visible_nm));
    }
    note_gaps(spectrum, field.empty() ? source : source + ": " + field, notes);
    return Spectrum(std::move(spectrum));
}

Spectrum read_spectrum(const std::filesystem::path& file, SpectrumUse use, std::vector<std::string>& notes) {
    const CsvTable table = read_csv(file);
    const std::size_t wavelength = table.column("wavelength_nm");
    const std::size_t value = table.column("value");
    std::vector<std::pair<double, double>> samples;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        samples.emplace_back(table.number(row, wavelength), table.number(row, value));
    }
    return checked_spectrum(samples, use, file.string(), "", notes);
}

} // namespace content
