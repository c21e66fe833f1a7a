#pragma once

#include <stdexcept>
#include <string>

namespace sim {

/// Input from outside the program that cannot be used: a file, a script, an option. One clear line with source, field
/// and value; `main` prints it and exits with 2. Defined here because every room throws it and sim is what all know.
class BadInput : public std::runtime_error {
  public:
    /// `source`: file name or option; `field`: which key, row or column ("" when the whole source is meant);
    /// `value`: the offending text ("" when there is none); `reason`: what is wrong and what would be right.
    BadInput(const std::string& source, const std::string& field, const std::string& value, const std::string& reason)
        : std::runtime_error(source + (field.empty() ? "" : ": " + field) + (value.empty() ? "" : " = " + value) +
                             ": " + reason) {}
};

} // namespace sim
