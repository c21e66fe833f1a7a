#pragma once

#include "engine/trace/tile_plan.h"
#include "render/offline/traced/traced_tile.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace engine {

/// Finished tiles of a picture or sequence in a folder beside it, so that a run that was stopped in any way, kill -9
/// included, goes on where it was. A tile's file appears whole or not at all, with a checksum.
class TileStore {
  public:
    /// Opens or makes the folder. `job` says in one text all that the tiles depend on. Throws sim::BadInput when the
    /// folder holds tiles of another job, or cannot be written.
    TileStore(std::filesystem::path folder, const std::string& job, const TilePlan& plan);

    /// Which tiles of the plan are there, sound; damaged ones are removed and count as not done.
    std::vector<bool> done() const;
    /// Throws sim::BadInput with the system's reason, such as a full disk.
    void store(std::size_t tile, const std::vector<float>& values) const;
    /// A tile's values; nothing when it is not there or damaged.
    std::optional<std::vector<float>> load(std::size_t tile) const;
    /// Removes a frame's tiles, whose picture is written; the mark that remains counts them as done.
    void finish_frame(int frame) const;
    bool is_finished(int frame) const;
    /// Removes the folder and all in it that is the store's.
    void remove() const;

    /// Where the exposures of a sequence's frames are noted.
    std::filesystem::path exposure_file() const { return folder_ / "exposure.csv"; }
    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path tile_file(std::size_t tile) const;
    std::filesystem::path mark_file(int frame) const;

    std::filesystem::path folder_;
    TilePlan plan_;
};

} // namespace engine
