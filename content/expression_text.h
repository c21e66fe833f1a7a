#pragma once

#include "sim/spacetime/expression.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace content {

/// What the names in a formula stand for.
struct ExpressionNames {
    std::map<std::string, double, std::less<>> numbers;          ///< parameters
    std::map<std::string, std::string, std::less<>> definitions; ///< formulas of their own, put in wherever named
};

/// A formula over t, x, y, z: numbers, + - * / ^ (to whole powers), parentheses, sqrt exp log sin cos tanh atan, pi,
/// and `names`. Throws sim::BadInput with `source`, `field` and the text: an unknown name (with the nearest known one),
/// a formula that breaks off, a definition that needs itself.
sim::Expression parse_expression(const std::string& source, const std::string& field, const std::string& text,
                                 const ExpressionNames& names);

} // namespace content
