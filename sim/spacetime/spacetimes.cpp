#include "sim/spacetime/spacetimes.h"

#include "sim/bad_input.h"
#include "sim/spacetime/ray.h"

#include <algorithm>
#include <cstdio>

namespace sim {
namespace {

constexpr double tiny = 1e-6;
constexpr double huge = 1e6;
constexpr SpacetimeParameter mass{"mass", "M, the unit of length of the scene", 1.0, tiny, huge};

constexpr std::array hole_parameters{mass};
constexpr std::array kerr_parameters{mass,
                                     SpacetimeParameter{"spin", "a/M = J/M^2, turning about +z", 0.9, -0.9999, 0.9999}};
constexpr std::array charged_parameters{mass, SpacetimeParameter{"charge", "Q/M", 0.8, -1.0, 1.0}};
constexpr std::array warp_parameters{
    SpacetimeParameter{"speed", "v, of the bubble along +x, in c", 0.5, 0.0, 10.0},
    SpacetimeParameter{"radius", "R, of the bubble, length", 2.0, tiny, huge},
    SpacetimeParameter{"sigma", "1/thickness of its wall, 1/length; sigma R from 0.1 to 100", 2.0, tiny, huge}};
constexpr std::array wormhole_parameters{
    SpacetimeParameter{"throat", "b, radius of the throat, length", 1.0, tiny, huge}};
constexpr std::array wave_parameters{
    SpacetimeParameter{"plus", "A_+, amplitude", 0.1, -0.5, 0.5},
    SpacetimeParameter{"cross", "A_x, amplitude", 0.0, -0.5, 0.5},
    SpacetimeParameter{"wavelength", "lambda, length", 1.0, tiny, huge},
    SpacetimeParameter{"cycles", "width w of the pulse in wavelengths", 3.0, 0.5, 100.0}};

constexpr std::string_view kerr_schild_chart = "ingoing Cartesian Kerr-Schild (t, x, y, z), across the outer horizon";

const std::array<SpacetimeKind, 7> kinds{
    SpacetimeKind{"minkowski",
                  "flat spacetime",
                  "-dt^2 + dx^2 + dy^2 + dz^2",
                  "Cartesian, everywhere",
                  "Minkowski 1908",
                  "none",
                  {},
                  [](const ParameterValues&) { return AnySpacetime(Minkowski{}); }},
    SpacetimeKind{"schwarzschild", "black hole without spin or charge", "eta + (2 M/r) (dt + dr)^2", kerr_schild_chart,
                  "Schwarzschild 1916; Eddington 1924; Kerr & Schild 1965", "outside r = 0.02 M", hole_parameters,
                  [](const ParameterValues& v) { return AnySpacetime(Schwarzschild(v.at("mass"))); }},
    SpacetimeKind{
        "kerr", "rotating black hole",
        "eta + 2 M r^3/(r^4 + a^2 z^2) (dt + (r(x dx + y dy) + a(y dx - x dy))/(r^2 + a^2) + z dz/r)^2",
        kerr_schild_chart, "Kerr 1963; Kerr & Schild 1965", "outside the inner horizon; spin tested to 0.999",
        kerr_parameters,
        [](const ParameterValues& v) { return AnySpacetime(Kerr(v.at("mass"), v.at("spin") * v.at("mass"))); }},
    SpacetimeKind{"reissner-nordstroem", "charged black hole; light and ships are neutral",
                  "eta + (2 M/r - Q^2/r^2) (dt + dr)^2", kerr_schild_chart, "Reissner 1916; Nordstroem 1918",
                  "outside the inner horizon", charged_parameters,
                  [](const ParameterValues& v) {
                      return AnySpacetime(ReissnerNordstroem(v.at("mass"), v.at("charge") * v.at("mass")));
                  }},
    SpacetimeKind{"alcubierre", "warp bubble moving along +x",
                  "-dt^2 + (dx - v f(r_s) dt)^2 + dy^2 + dz^2, f = (tanh(s(r_s+R)) - tanh(s(r_s-R)))/(2 tanh(s R))",
                  "the outside's Cartesian coordinates; the bridge is at x = v t", "Alcubierre 1994",
                  "the bubble keeps its speed; sigma R from 0.1 to 100", warp_parameters,
                  [](const ParameterValues& v) {
                      return AnySpacetime(Alcubierre(v.at("speed"), v.at("radius"), v.at("sigma")));
                  }},
    SpacetimeKind{"wormhole", "traversable wormhole between two flat universes",
                  "-dt^2 + dl^2 + (b^2 + l^2) dOmega^2 = -dt^2 + (1 + b^2/(4 rho^2))^2 (dx^2 + dy^2 + dz^2)",
                  "isotropic Cartesian; rho > b/2 this side, rho < b/2 the far side",
                  "Ellis 1973; Morris & Thorne 1988", "none; the throat needs exotic matter", wormhole_parameters,
                  [](const ParameterValues& v) { return AnySpacetime(Wormhole{v.at("throat")}); }},
    SpacetimeKind{
        "plane-wave", "pulse of plane gravitational waves along +z",
        "-dt^2 + (1+h_+) dx^2 + (1-h_+) dy^2 + 2 h_x dx dy + dz^2, h(t - z) a wave in a Gaussian envelope",
        "transverse traceless, everywhere", "Misner, Thorne & Wheeler, section 35.2",
        "a solution of the field equations to first order in the amplitude; geodesics are exact in the metric",
        wave_parameters,
        [](const ParameterValues& v) {
            return AnySpacetime(PlaneWave{v.at("plus"), v.at("cross"), v.at("wavelength"), v.at("cycles")});
        }},
};

std::string text_of(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.12g", value);
    return text.data();
}

template <class Range>
std::string names_of(const Range& range) {
    std::string names;
    for (const auto& each : range) {
        names += (names.empty() ? "" : ", ") + std::string(each.name);
    }
    return names.empty() ? "none" : names;
}

} // namespace

std::string_view name_of(RayOutcome outcome) {
    constexpr std::array<std::string_view, 6> names{"escaped",    "captured",   "hit-object",
                                                    "step-limit", "left-chart", "constraint-drift"};
    return names[static_cast<std::size_t>(outcome)];
}

std::span<const SpacetimeKind> spacetime_kinds() {
    return kinds;
}

AnySpacetime make_spacetime(const std::string& source, std::string_view name, const ParameterValues& given) {
    const auto kind = std::ranges::find(kinds, name, &SpacetimeKind::name);
    if (kind == kinds.end()) {
        throw BadInput(source, "", std::string(name), "not a spacetime; known are " + names_of(kinds));
    }
    ParameterValues all;
    for (const SpacetimeParameter& parameter : kind->parameters) {
        all.emplace(parameter.name, parameter.standard);
    }
    for (const auto& [key, value] : given) {
        const auto parameter = std::ranges::find(kind->parameters, key, &SpacetimeParameter::name);
        if (parameter == kind->parameters.end()) {
            throw BadInput(source, key, "",
                           "not a parameter of " + std::string(name) + "; it has " + names_of(kind->parameters));
        }
        if (!(value >= parameter->least && value <= parameter->most)) {
            throw BadInput(source, key, text_of(value),
                           "must be between " + text_of(parameter->least) + " and " + text_of(parameter->most));
        }
        all[key] = value;
    }
    if (kind->name == "alcubierre") {
        const double walls = all.at("sigma") * all.at("radius");
        if (!(walls >= 0.1 && walls <= 100.0)) {
            throw BadInput(source, "sigma", text_of(all.at("sigma")), "sigma times radius must be between 0.1 and 100");
        }
    }
    return kind->make(all);
}

} // namespace sim
