#include "engine/proof/integrator_comparison.h"

#include "engine/median.h"
#include "engine/proof/closed_forms.h"
#include "engine/verify/flights.h"
#include "sim/integrators.h"
#include "sim/vehicle.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

namespace engine {

const std::string_view flying_integrator = "SL(2,C) RK4, corrected, lossless sums";
const std::string_view exact_integrator = "exact exponential, lossless sums";

namespace {

/// What all kinds of state have to say of a ship.
struct Observed {
    sim::Event event;
    double gamma;
    glm::dmat3 boosted_from_vehicle; ///< the axes once the boost is taken out
    std::optional<sim::Complex> determinant;
    double norm; ///< u.u
};

/// The axes carried back by the pure boost of their own four-velocity: e - (u + u_rest) e.u_rest-part/(1 + gamma).
glm::dmat3 without_boost(const std::array<sim::FourVector<sim::World>, 4>& e) {
    glm::dmat3 rotation;
    for (int i = 0; i < 3; ++i) {
        const sim::FourVector<sim::World>& axis = e[static_cast<std::size_t>(i) + 1];
        rotation[i] = axis.space - (axis.t / (1.0 + e[0].t)) * e[0].space;
    }
    return rotation;
}

Observed observe(const sim::TetradState& state) {
    const auto& u = state.axes[0];
    return {state.event, u.t, without_boost(state.axes), std::nullopt, sim::dot(u, u)};
}

Observed observe(const sim::SpinState& state) {
    const sim::Lorentz<sim::World, sim::Vehicle> frame{state.spin};
    const auto u = sim::four_velocity(frame);
    const glm::dquat ahead(1.0, 0.0, 0.0, 0.0);
    return {state.event, u.t, sim::split(sim::world_from_head(frame, ahead)).boosted_from_head, determinant(state.spin),
            sim::dot(u, u)};
}

Observed observe(const sim::VehicleState& state) {
    return observe(sim::SpinState{state.event, state.world_from_vehicle.spin});
}

void start(sim::TetradState& state, const sim::Lorentz<sim::World, sim::Vehicle>& frame) {
    state.axes = sim::tetrad(frame);
}
void start(sim::SpinState& state, const sim::Lorentz<sim::World, sim::Vehicle>& frame) {
    state.spin = frame.spin;
}
void start(sim::VehicleState& state, const sim::Lorentz<sim::World, sim::Vehicle>& frame) {
    state.world_from_vehicle = frame;
}

struct PlainTetrad {
    using State = sim::TetradState;
    static State step(const State& s, sim::ProperTime h, const sim::Drive& d) { return sim::rk4_tetrad_step(s, h, d); }
};
struct NormalisedTetrad {
    using State = sim::TetradState;
    static State step(const State& s, sim::ProperTime h, const sim::Drive& d) {
        return sim::orthonormal(sim::rk4_tetrad_step(s, h, d));
    }
};
struct UnprojectedSpin {
    using State = sim::SpinState;
    static State step(const State& s, sim::ProperTime h, const sim::Drive& d) { return sim::rk4_spin_step(s, h, d); }
};
struct ScaledSpin {
    using State = sim::SpinState;
    static State step(const State& s, sim::ProperTime h, const sim::Drive& d) {
        return sim::scaled_to_unit_determinant(sim::rk4_spin_step(s, h, d));
    }
};
struct CorrectedSpin {
    using State = sim::SpinState;
    static State step(const State& s, sim::ProperTime h, const sim::Drive& d) {
        return sim::smallest_corrected(sim::rk4_spin_step(s, h, d));
    }
};
struct Flying {
    using State = sim::VehicleState;
    static State step(const State& s, sim::ProperTime h, const sim::Drive& d) { return sim::step(s, h, d); }
};
struct Exact {
    using State = sim::VehicleState;
    static State step(const State& s, sim::ProperTime h, const sim::Drive& d) { return sim::exact_step(s, h, d); }
};

/// A flight and what is known of the ends of its segments.
struct KnownFlight {
    sim::Lorentz<sim::World, sim::Vehicle> start;
    sim::FlightScript script;
    struct End {
        sim::Event event;
        double gamma;
        std::optional<glm::dmat3> orientation;
    };
    std::vector<End> ends;
};

std::vector<KnownFlight> flights_of(const content::CsvTable& table) {
    // A double's rounding of a tetrad fixes the orientation to gamma * 1e-16.
    constexpr double largest_gamma = 1e4;
    std::vector<KnownFlight> flights;
    for (const TrueFlight& flight : read_true_flights(table)) {
        KnownFlight& known = flights.emplace_back(KnownFlight{{}, flight.script, {}});
        for (const auto& v : flight.ends) {
            std::array<sim::FourVector<sim::World>, 4> axes;
            for (std::size_t i = 0; i < axes.size(); ++i) {
                const std::size_t first = 5 + 4 * i; // after tau and the event
                axes[i] = {v[first], {v[first + 1], v[first + 2], v[first + 3]}};
            }
            known.ends.push_back({{v[1], {v[2], v[3], v[4]}}, axes[0].t, std::nullopt});
            if (axes[0].t < largest_gamma) {
                known.ends.back().orientation = without_boost(axes);
            }
        }
    }
    return flights;
}

std::vector<KnownFlight> closed_form_flights() {
    constexpr double rapidity = 10.0;
    const glm::dvec3 along = glm::normalize(glm::dvec3(0.3, 0.7, -0.4));
    const sim::Event turning = hyperbolic_motion(1.0, rapidity, along);
    KnownFlight out_and_back{
        {},
        {{sim::ProperTime(rapidity), along, {}}, {sim::ProperTime(rapidity), -along, {}}},
        {{turning, std::cosh(rapidity), glm::dmat3(1.0)}, {turning + turning, 1.0, glm::dmat3(1.0)}}};
    const CircularMotion circle{0.8, 1.0};
    constexpr double turns = 10.0;
    KnownFlight round{sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(circle.beta)), {1.0, 0.0, 0.0}),
                      {{sim::ProperTime(turns * circle.ship_period()),
                        {0.0, circle.proper_acceleration(), 0.0},
                        {0.0, 0.0, circle.proper_turn_rate()}}},
                      {{{turns * circle.world_period(), glm::dvec3(0.0)}, circle.gamma(), glm::dmat3(1.0)}}};
    return {out_and_back, round};
}

double largest_entry(const glm::dmat3& m) {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
        largest = std::max({largest, std::abs(m[i].x), std::abs(m[i].y), std::abs(m[i].z)});
    }
    return largest;
}

double largest_component(const sim::Event& e) {
    return std::max({std::abs(e.t), std::abs(e.space.x), std::abs(e.space.y), std::abs(e.space.z)});
}

/// `error`, or infinity for a NaN, which would lose every comparison and pass.
double counted(double error) {
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

/// At higher gamma the roundings of the components hide how far det Lambda and u.u have drifted.
constexpr double slow = 2.0;

struct Drift {
    std::optional<double> determinant;
    double norm = 0.0;
};

template <class Integrator>
MotionErrors fly(const std::vector<KnownFlight>& flights, double rate, Drift& drift) {
    MotionErrors errors;
    for (const KnownFlight& flight : flights) {
        typename Integrator::State state;
        start(state, flight.start);
        for (std::size_t i = 0; i < flight.script.size(); ++i) {
            const sim::FlightSegment& segment = flight.script[i];
            const double steps = sim::steps_of_segment(segment, rate);
            const sim::ProperTime h(segment.duration.value / steps);
            for (double n = 0.0; n < steps; n += 1.0) {
                state = Integrator::step(state, h, {segment.proper_acceleration, segment.angular_velocity});
            }
            const Observed now = observe(state);
            const KnownFlight::End& end = flight.ends[i];
            errors.event = std::max(errors.event,
                                    counted(largest_component(now.event - end.event)) / largest_component(end.event));
            errors.gamma = std::max(errors.gamma, counted(std::abs(now.gamma - end.gamma)) / end.gamma);
            if (end.orientation) {
                errors.orientation =
                    std::max(errors.orientation, counted(largest_entry(now.boosted_from_vehicle - *end.orientation)));
            }
            if (end.gamma > slow) {
                continue;
            }
            drift.norm = std::max(drift.norm, counted(std::abs(now.norm + 1.0)));
            if (now.determinant) {
                const double off = std::hypot(now.determinant->re - 1.0, now.determinant->im);
                drift.determinant = std::max(drift.determinant.value_or(0.0), counted(off));
            }
        }
    }
    return errors;
}

/// Processor time of one step of a flight that turns and thrusts about every axis.
template <class Integrator>
double nanoseconds_a_step(double rate) {
    constexpr int steps = 10000;
    typename Integrator::State state;
    const std::clock_t before = std::clock();
    for (int i = 0; i < steps; ++i) {
        const double way = (i / 16) % 2 == 0 ? 1.0 : -1.0;
        state = Integrator::step(state, sim::ProperTime(1.0 / rate),
                                 {{0.3 * way, -0.2 * way, way}, {0.1, 0.7 * way, -0.4}});
    }
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    // Read, so that the flight cannot be left out.
    return std::isfinite(observe(state).gamma) ? seconds / steps * 1e9 : std::numeric_limits<double>::infinity();
}

struct Integrator {
    std::string_view name;
    MotionErrors (*fly)(const std::vector<KnownFlight>&, double rate, Drift&);
    double (*nanoseconds_a_step)(double rate);
};

template <class Kind>
constexpr Integrator integrator(std::string_view name) {
    return {name, fly<Kind>, nanoseconds_a_step<Kind>};
}

} // namespace

std::vector<IntegratorRow> compare_integrators(const content::CsvTable& flights, int rounds) {
    const std::array integrators{integrator<PlainTetrad>("four-velocity RK4"),
                                 integrator<NormalisedTetrad>("four-velocity RK4, normalised"),
                                 integrator<UnprojectedSpin>("SL(2,C) RK4"),
                                 integrator<ScaledSpin>("SL(2,C) RK4, scaled"),
                                 integrator<CorrectedSpin>("SL(2,C) RK4, corrected"),
                                 integrator<Flying>(flying_integrator),
                                 integrator<Exact>(exact_integrator)};
    const std::vector<KnownFlight> table = flights_of(flights);
    const std::vector<KnownFlight> closed = closed_form_flights();
    std::vector<IntegratorRow> rows;
    for (const Integrator& kind : integrators) {
        for (const double rate : comparison_rates) {
            Drift not_told;
            Drift drift;
            const MotionErrors of_table = kind.fly(table, rate, not_told);
            const MotionErrors of_closed = kind.fly(closed, rate, drift);
            rows.push_back({kind.name, rate, 0.0, of_table, of_closed, drift.determinant, drift.norm});
        }
    }
    // Interleaved, so that what else the machine does falls on all alike.
    std::vector<std::vector<double>> times(rows.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            times[i].push_back(integrators[i / comparison_rates.size()].nanoseconds_a_step(rows[i].rate));
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].nanoseconds_a_step = median(times[i]);
    }
    return rows;
}

} // namespace engine
