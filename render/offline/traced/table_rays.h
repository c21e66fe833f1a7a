#pragma once

#include "render/offline/traced/traced_ray.h"
#include "sim/spacetime/deflection_table.h"

namespace render {

/// Rays on which nothing lies but infinity, looked up instead of traced. Their error is the table's own.
class TableRays : public RaySource {
  public:
    explicit TableRays(sim::DeflectionTable table) : table_(std::move(table)) {}

    void trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
               std::size_t error_every) const override;

  private:
    sim::DeflectionTable table_;
};

} // namespace render
