#include "sim/spacetime/sky_tracer.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace sim {

double standard_step(RayKernel kernel) {
    return kernel == RayKernel::mino ? 0.2 : 0.1;
}

double estimated_error(const SkyRay& whole, const SkyRay& halved) {
    if (whole.outcome != halved.outcome || whole.infinity.side != halved.infinity.side) {
        return std::numeric_limits<double>::infinity();
    }
    if (halved.outcome != RayOutcome::escaped) {
        return 0.0;
    }
    // The frequency changes on the way only where nothing is stationary.
    return 2.0 / 15.0 *
           std::max(angle_between(whole.infinity.direction, halved.infinity.direction),
                    std::abs(whole.infinity.frequency / halved.infinity.frequency - 1.0));
}

SkyTracer::SkyTracer(AnySpacetime spacetime, const Components<double>& event, const Tetrad& tetrad,
                     const RaySettings& settings, RayKernel kernel, Precision precision)
    : spacetime_(std::move(spacetime)), event_(event), tetrad_(tetrad), settings_(settings), precision_(precision) {
    const std::optional<MinoHole> hole = mino_hole(spacetime_);
    const bool fits = hole && fits_mino(*hole, event);
    if (kernel == RayKernel::mino && !fits) {
        throw std::invalid_argument("Mino time is for eyes outside a black hole");
    }
    if (fits && kernel != RayKernel::generic) {
        mino_ = mino_eye(spacetime_, *hole, event, tetrad);
    }
}

void SkyTracer::trace_with_step(double step, std::span<const glm::dvec3> seen, std::span<SkyRay> rays,
                                std::span<PlaneCrossings> crossings) const {
    RaySettings settings = settings_;
    settings.step = step;
    if (mino_) {
        trace_mino_sky(*mino_, seen, settings, rays, crossings, precision_);
    } else {
        trace_sky(spacetime_, event_, tetrad_, seen, settings, rays, precision_);
    }
}

void SkyTracer::trace(std::span<const glm::dvec3> seen, std::span<SkyRay> rays,
                      std::span<PlaneCrossings> crossings) const {
    if (!crossings.empty() && !mino_) {
        throw std::invalid_argument("only the kernel in Mino time finds crossings");
    }
    trace_with_step(settings_.step, seen, rays, crossings);
}

std::size_t SkyTracer::trace_to_error(std::span<const glm::dvec3> seen, double error, std::span<SkyRay> rays,
                                      std::span<double> errors, int most_halvings) const {
    trace_with_step(settings_.step, seen, rays, {});
    std::ranges::fill(errors, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> open(seen.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    std::vector<glm::dvec3> directions;
    std::vector<SkyRay> halved;
    std::size_t missed = 0;
    double step = settings_.step;
    for (int halving = 0; halving < most_halvings && !open.empty(); ++halving) {
        step *= 0.5;
        directions.resize(open.size());
        halved.resize(open.size());
        std::ranges::transform(open, directions.begin(), [&](std::size_t i) { return seen[i]; });
        trace_with_step(step, directions, halved, {});
        std::vector<std::size_t> still_open;
        for (std::size_t k = 0; k < open.size(); ++k) {
            const std::size_t i = open[k];
            const double reached = estimated_error(rays[i], halved[k]);
            // Rounding grows with the steps: further halvings only make it worse.
            if (halved[k].outcome == RayOutcome::step_limit ||
                (halving > 0 && errors[i] < 1e-9 && reached > 0.5 * errors[i])) {
                ++missed;
                continue;
            }
            errors[i] = reached;
            rays[i] = halved[k];
            if (!(reached <= error)) {
                still_open.push_back(i);
            }
        }
        open = std::move(still_open);
    }
    return missed + open.size();
}

double SkyTracer::choose_step(std::span<const glm::dvec3> sample, double error, double share) {
    std::vector<SkyRay> whole(sample.size());
    std::vector<SkyRay> halved(sample.size());
    std::vector<double> errors(sample.size());
    double step = 2.0 * standard_step(kernel());
    // The error goes as step^4; two or three corrections meet it, more only where steps are too long for that law.
    for (int attempt = 0; attempt < 8; ++attempt) {
        trace_with_step(step, sample, whole, {});
        trace_with_step(0.5 * step, sample, halved, {});
        std::ranges::transform(whole, halved, errors.begin(), estimated_error);
        const auto captured = std::ranges::remove(errors, 0.0);
        const auto count = errors.size() - captured.size();
        if (count == 0) {
            break;
        }
        const auto chosen = static_cast<std::size_t>(share * static_cast<double>(count - 1));
        std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(chosen), captured.begin());
        const double reached = errors[chosen];
        errors.resize(sample.size());
        if (reached <= error && reached > error / 3.0) {
            break;
        }
        step *= std::clamp(std::pow(0.7 * error / reached, 0.25), 0.1, 4.0);
        step = std::clamp(step, 1e-5, 1.0);
    }
    settings_.step = 0.5 * step;
    return settings_.step;
}

} // namespace sim
