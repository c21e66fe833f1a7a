#pragma once

#include "sim/spacetime/alcubierre.h"
#include "sim/spacetime/custom_spacetime.h"
#include "sim/spacetime/kerr.h"
#include "sim/spacetime/minkowski.h"
#include "sim/spacetime/plane_wave.h"
#include "sim/spacetime/reissner_nordstroem.h"
#include "sim/spacetime/schwarzschild.h"
#include "sim/spacetime/wormhole.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace sim {

/// Any spacetime; std::visit chooses once, the kernels are compiled for each.
using AnySpacetime =
    std::variant<Minkowski, Schwarzschild, Kerr, ReissnerNordstroem, Alcubierre, Wormhole, PlaneWave, CustomSpacetime>;

/// One number that shapes a spacetime.
struct SpacetimeParameter {
    std::string_view name;
    std::string_view doc; ///< with its unit
    double standard;      ///< used when none is given
    double least;
    double most; ///< both ends are allowed
};

/// Values by parameter name.
using ParameterValues = std::map<std::string, double, std::less<>>;

/// What a user can choose from.
struct SpacetimeKind {
    std::string_view name;
    std::string_view title;
    std::string_view line_element;
    std::string_view chart;
    std::string_view source;
    std::string_view limits;
    std::span<const SpacetimeParameter> parameters;
    AnySpacetime (*make)(const ParameterValues& all); ///< `all`: every parameter, checked
};

/// All built-in spacetimes.
std::span<const SpacetimeKind> spacetime_kinds();

/// The spacetime of that name. Parameters not given take their standard value. Throws BadInput, which names `source`
/// (file or option), for an unknown name or parameter, a value out of range, or values that do not go together (spin
/// above the mass).
AnySpacetime make_spacetime(const std::string& source, std::string_view name, const ParameterValues& given);

} // namespace sim
