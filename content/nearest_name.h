#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace content {

/// The name that `text` was most likely meant to be: the one with the smallest edit distance (insertions, deletions and
/// replacements of single letters), the first of equals; "" when there are no names.
std::string nearest_name(std::string_view text, const std::vector<std::string>& names);

} // namespace content
