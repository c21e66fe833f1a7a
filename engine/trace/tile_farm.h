#pragma once

#include "engine/ranks/rank_link.h"
#include "engine/trace/tile_store.h"

#include <functional>
#include <vector>

namespace engine {

/// Makes the values of one tile; called by several threads at once. The values depend on the tile's number alone.
using MakeTile = std::function<std::vector<float>(std::size_t tile)>;

/// Who wants to know how the work goes on; called by the main thread.
struct TileProgress {
    std::function<void(std::size_t tile)> finished; ///< a tile is in the store
    std::function<void()> waiting;                  ///< a few times a second
    std::function<bool()> stop;                     ///< true: hand out no more tiles
};

/// Makes the tiles that are not `done` on `threads` threads of this process and on all ranks of `link` (nullptr: this
/// process alone). Tiles are handed out one by one, in order, to whoever is free; rank 0 stores them. On other ranks
/// `store` is not used. Returns whether all were made: false after `stop`. The first exception of a tile is thrown
/// again after the others' tiles are done. A rank that dies ends the run (MPI's rule); stored tiles remain.
bool farm_tiles(const std::vector<bool>& done, int threads, const MakeTile& make, const TileStore* store,
                RankLink* link, const TileProgress& progress);

/// What a rank other than 0 does: makes tiles for rank 0 until there are no more.
void serve_tiles(int threads, const MakeTile& make, RankLink& link);

} // namespace engine
