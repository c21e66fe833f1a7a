#include "render/offline/traced/table_rays.h"

#include "render/offline/traced/lane_rays.h"

namespace render {

void TableRays::trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
                      std::size_t /*error_every*/) const {
    std::vector<sim::SkyRay> found(directions.size());
    table_.trace(directions, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        rays[i] = traced_ray(found[i].outcome, found[i].infinity, 0);
        rays[i].error = static_cast<float>(table_.error());
    }
}

} // namespace render
