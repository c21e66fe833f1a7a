#pragma once

#include "render/colour/observer.h"
#include "render/colour/uniform_table.h"

namespace render {

/// XYZ of black bodies of any T, for every star and light at every D (T/D). Below 20 K, where a double hardly holds the
/// light, the Wien tail at the red end goes on; to the hot end the Rayleigh-Jeans law (Y proportional to T).
class BlackBodyTable {
  public:
    explicit BlackBodyTable(const Observer& observer);

    /// As Observer::black_body, to 1e-6 of Y from 500 K on.
    LogXyz at_ln(double ln_temperature_kelvin) const;

  private:
    UniformTable<glm::dvec3> table_; ///< (ln Y - ln T + c2 / (830 nm T), X/Y, Z/Y)
};

} // namespace render
