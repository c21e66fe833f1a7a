#pragma once

#include "render/colour/observer.h"
#include "render/colour/uniform_table.h"

namespace render {

/// XYZ of black bodies over ln T, for every star and light at every D (T/D): 0.1 K to 1e9 K; below it the light is
/// far below anything a double holds, above it the Rayleigh-Jeans law (Y proportional to T) goes on.
class BlackBodyTable {
  public:
    explicit BlackBodyTable(const Observer& observer);

    /// As Observer::black_body, to 1e-6 of Y from 500 K on.
    LogXyz at_ln(double ln_temperature_kelvin) const;

  private:
    UniformTable<glm::dvec3> table_; ///< (ln Y + c2 / (830 nm T), X/Y, Z/Y)
};

} // namespace render
