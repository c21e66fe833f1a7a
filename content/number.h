#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace content {

/// A finite number written out in full, as in "-1.5e3"; nothing else may stand beside it. Never depends on the locale.
inline std::optional<double> finite_number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

} // namespace content
