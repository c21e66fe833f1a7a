#pragma once

#include <stdexcept>

namespace engine {

/// The program ran and the answer is no: a tolerance not met, hashes that differ. One line, exit code 1.
class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace engine
