#pragma once

#include "sim/spacetime/spacetimes.h"

#include <filesystem>
#include <string>

namespace content {

/// A spacetime of a user's own from a TOML file:
///   name = "..."                 shown to people
///   smallest_length = 1.0        over which the metric changes; steps are this fine near the origin
///   flat_radius = 1e4            beyond which it is flat: there g must be diag(-1, 1, 1, 1) to 1e-2
///   [parameters]                 numbers by name, which `given` may change
///   [definitions]                formulas by name, used in others
///   [metric]                     tt, tx, ty, tz, xx, xy, xz, yy, yz, zz; off the diagonal 0 when left out
/// Throws sim::BadInput with file, key and text for anything that cannot be used: an unknown name, a missing component,
/// a signature that is not (-,+,+,+) far away.
sim::CustomSpacetime read_spacetime(const std::filesystem::path& file, const sim::ParameterValues& given = {});

/// A built-in spacetime by name, or one of a user's own by a file name that ends in .toml. `source` (file or option)
/// names what is refused.
sim::AnySpacetime spacetime_of(const std::string& source, const std::string& name_or_file,
                               const sim::ParameterValues& given);

} // namespace content
