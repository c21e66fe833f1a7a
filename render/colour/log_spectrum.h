#pragma once

#include "content/spectrum.h"
#include "render/colour/observer.h"
#include "render/colour/uniform_table.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

/// Spectra in even steps of the logarithm of the wavelength: a Doppler shift moves them by whole samples, so what
/// the eye sees of one at every D is one running sum. What the tables in ln D are built with; the direct integrals
/// (Observer) know nothing of it.
namespace render {

/// Step of ln wavelength: 0.36 to 0.83 nm within the visible, a tenth of the observer's rows.
inline constexpr double ln_wavelength_step = 1e-3;

/// Sample i is the value at exp((first + i) * ln_wavelength_step) nm.
struct LogSpectrum {
    int first = 0;
    std::vector<double> values;

    int last() const { return first + static_cast<int>(values.size()) - 1; }
};

/// Whole steps.
struct StepRange {
    int first = 0;
    int last = 0;

    std::size_t count() const { return last < first ? 0 : 1 + static_cast<std::size_t>(last - first); }
};

/// Values of `f(nm)` as they stand: for what is smooth over a step.
template <class Function>
LogSpectrum log_samples(const StepRange& range, const Function& f) {
    LogSpectrum spectrum{range.first, {}};
    spectrum.values.reserve(range.count());
    for (int i = range.first; i <= range.last; ++i) {
        spectrum.values.push_back(f(std::exp(i * ln_wavelength_step)));
    }
    return spectrum;
}

/// A light. Black bodies: relative to themselves at `range.last`. All others: the averages around each sample that keep
/// the light of a line however narrow.
LogSpectrum log_samples(const StepRange& range, const content::Spectrum& light);

/// The observer's sums as running sums.
class LogObserver {
  public:
    explicit LogObserver(const Observer& observer);

    /// Emitted wavelengths that are seen anywhere within these shifts.
    StepRange emitted(const StepRange& shifts) const { return {first_ - shifts.last, last() - shifts.first}; }
    /// Shifts at which an emitted wavelength within [shortest, longest] nm is seen.
    StepRange shifts(double shortest_nm, double longest_nm) const;

    /// XYZ of `emitted(nm / D)` at D = exp(shift * ln_wavelength_step); nothing beyond the samples.
    glm::dvec3 xyz(const LogSpectrum& emitted, int shift) const;

  private:
    int last() const { return first_ + static_cast<int>(x_.size()) - 1; }

    int first_ = 0; ///< received wavelength of the first of
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> z_;
};

/// Tables in ln D, three terms each, a term's XYZ in a column.
using TermTables = std::vector<UniformTable<glm::dmat3>>;

/// What the eye sees of `light` sent on by terms, over at least these shifts, every `stride` steps, D = 1 on a sample:
/// XYZ times D^5.
TermTables shifted_terms(const LogObserver& observer, const LogSpectrum& light, std::span<const LogSpectrum> terms,
                         const StepRange& shifts, int stride);
/// The same relative to white's X, Y and Z each: averages of the terms. Where the light has none of one, what
/// is seen at the eye's red end stands for it. `terms` must hold all that is seen at the shifts.
TermTables shifted_averages(const LogObserver& observer, const LogSpectrum& light, std::span<const LogSpectrum> terms,
                            const StepRange& shifts, int stride);

} // namespace render
