#include "engine/trace/tile_store.h"

#include "engine/checksum.h"
#include "render/whole_file.h"
#include "sim/bad_input.h"

#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace engine {
namespace {

std::string read_whole(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return in ? bytes.str() : std::string();
}

std::uint64_t checksum_of(std::size_t tile, const std::vector<float>& values) {
    Checksum sum;
    sum.add(static_cast<std::uint64_t>(tile));
    for (const float value : values) {
        sum.add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value)));
    }
    return sum.sum();
}

std::size_t value_count(const TilePlan& plan, std::size_t tile) {
    const render::TracedTile place = plan.place_of(tile);
    return static_cast<std::size_t>(place.width) * static_cast<std::size_t>(place.height) *
           render::traced_channel_count;
}

} // namespace

TileStore::TileStore(std::filesystem::path folder, const std::string& job, const TilePlan& plan)
    : folder_(std::move(folder)), plan_(plan) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) {
        throw sim::BadInput(folder_.string(), "", "", "cannot be made: " + error.message());
    }
    const std::filesystem::path job_file = folder_ / "job.txt";
    if (std::filesystem::exists(job_file, error)) {
        if (read_whole(job_file) != job) {
            throw sim::BadInput(folder_.string(), "", "",
                                "holds tiles of another picture than this command makes; --restart throws them away");
        }
    } else {
        render::write_whole_file(job_file, job);
    }
}

std::filesystem::path TileStore::tile_file(std::size_t tile) const {
    return folder_ / fmt::format("{:08}.tile", tile);
}

std::filesystem::path TileStore::mark_file(int frame) const {
    return folder_ / fmt::format("{:06}.frame", frame);
}

std::vector<bool> TileStore::done() const {
    std::vector<bool> done(plan_.count(), false);
    std::error_code error;
    for (std::size_t tile = 0; tile < done.size(); ++tile) {
        if (is_finished(plan_.frame_of(tile))) {
            done[tile] = true;
        } else if (std::filesystem::exists(tile_file(tile), error)) {
            done[tile] = load(tile).has_value();
            if (!done[tile]) {
                std::filesystem::remove(tile_file(tile), error);
            }
        }
    }
    return done;
}

void TileStore::store(std::size_t tile, const std::vector<float>& values) const {
    const std::uint64_t checksum = checksum_of(tile, values);
    std::string bytes(sizeof checksum + values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), &checksum, sizeof checksum);
    std::memcpy(bytes.data() + sizeof checksum, values.data(), values.size() * sizeof(float));
    render::write_whole_file(tile_file(tile), bytes);
}

std::optional<std::vector<float>> TileStore::load(std::size_t tile) const {
    const std::string bytes = read_whole(tile_file(tile));
    std::vector<float> values(value_count(plan_, tile));
    std::uint64_t checksum = 0;
    if (bytes.size() != sizeof checksum + values.size() * sizeof(float)) {
        return std::nullopt;
    }
    std::memcpy(&checksum, bytes.data(), sizeof checksum);
    std::memcpy(values.data(), bytes.data() + sizeof checksum, values.size() * sizeof(float));
    return checksum == checksum_of(tile, values) ? std::optional(std::move(values)) : std::nullopt;
}

bool TileStore::is_finished(int frame) const {
    std::error_code error;
    return std::filesystem::exists(mark_file(frame), error);
}

void TileStore::finish_frame(int frame) const {
    render::write_whole_file(mark_file(frame), "");
    std::error_code ignored;
    const std::size_t first = static_cast<std::size_t>(frame) * plan_.tiles_per_frame();
    for (std::size_t i = 0; i < plan_.tiles_per_frame(); ++i) {
        std::filesystem::remove(tile_file(first + i), ignored);
    }
}

void TileStore::remove() const {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".tile" || extension == ".frame" || extension == ".part" ||
            entry.path().filename() == "job.txt" || entry.path() == exposure_file()) {
            std::filesystem::remove(entry.path(), ignored);
        }
    }
    std::filesystem::remove(folder_, ignored); // stays when somebody else's files are in it
}

} // namespace engine
