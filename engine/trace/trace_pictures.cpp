#include "engine/trace/trace_pictures.h"

#include "engine/failure.h"
#include "engine/trace/interruption.h"
#include "engine/trace/progress_line.h"
#include "engine/trace/tile_farm.h"
#include "engine/trace/traced_picture_file.h"
#include "render/offline/traced/tile_painter.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <fmt/core.h>
#include <map>
#include <mutex>
#include <system_error>

namespace engine {
namespace {

/// Paints tiles of any frame; the rays of a frame are made when its first tile is asked for and kept while its
/// neighbours are under way.
class FramePainter {
  public:
    FramePainter(const TraceRequest& request, const render::TracedScene& scene, const TilePlan& plan)
        : request_(request), scene_(scene), plan_(plan) {}

    std::vector<float> operator()(std::size_t tile) {
        const CameraRays camera = rays_of(plan_.frame_of(tile));
        render::TracedTile painted = plan_.place_of(tile);
        render::TilePainter(request_.lens, *camera.rays, camera.magnification, scene_.skies(), scene_.colour(),
                            request_.samples_per_side)
            .paint(painted);
        return std::move(painted.values);
    }

  private:
    struct CameraRays {
        std::shared_ptr<const render::RaySource> rays;
        render::BundleMagnification magnification;
    };

    CameraRays rays_of(int frame) {
        const std::scoped_lock lock(mutex_);
        CameraRays& camera = cameras_[frame];
        if (!camera.rays) {
            const render::CameraPose& pose = request_.frames[static_cast<std::size_t>(frame)];
            camera = {scene_.rays(pose, request_.lens), scene_.magnification(pose)};
            // Tiles are handed out in order: frames long past are not asked for again.
            std::erase_if(cameras_, [&](const auto& entry) { return entry.first < frame - 1; });
        }
        return cameras_[frame];
    }

    const TraceRequest& request_;
    const render::TracedScene& scene_;
    const TilePlan& plan_;
    std::mutex mutex_;
    std::map<int, CameraRays> cameras_;
};

void discard_tiles(const TraceRequest& request, const TilePlan& plan) {
    const std::filesystem::path job = request.tiles_folder() / "job.txt";
    std::error_code error;
    std::filesystem::remove(job, error);
    if (std::filesystem::is_directory(request.tiles_folder(), error)) {
        TileStore(request.tiles_folder(), request.job, plan).remove();
    }
}

/// Rank 0: keeps the tiles, writes each picture when it is whole, and tells of it.
class PictureKeeper {
  public:
    PictureKeeper(const TraceRequest& request, const render::TracedScene& scene, const TilePlan& plan)
        : request_(request), scene_(scene), plan_(plan), store_(request.tiles_folder(), request.job, plan),
          exposure_(store_.exposure_file(), request.frames_per_second), done_(store_.done()),
          missing_(static_cast<std::size_t>(plan.frames()), 0) {
        for (std::size_t tile = 0; tile < done_.size(); ++tile) {
            missing_[static_cast<std::size_t>(plan.frame_of(tile))] += done_[tile] ? 0 : 1;
        }
        const auto kept = static_cast<std::size_t>(std::count(done_.begin(), done_.end(), true));
        if (kept > 0) {
            fmt::print(stderr, "rapidity: going on from {} of {} tiles in {}\n", kept, done_.size(),
                       store_.folder().string());
        }
        progress_.emplace(done_.size(), kept);
        finish_whole_frames();
    }

    void make(int threads, const MakeTile& make, RankLink* link) {
        const Interruption interruption;
        const TileProgress progress{[this](std::size_t tile) { finished(tile); }, [this] { progress_->show(); },
                                    [] { return Interruption::wanted(); }};
        const bool complete = farm_tiles(done_, threads, make, &store_, link, progress);
        progress_->clear();
        if (!complete) {
            throw Failure(fmt::format("stopped; the tiles that are done are kept in {}: the same command goes on",
                                      store_.folder().string()));
        }
        store_.remove();
    }

  private:
    void finished(std::size_t tile) {
        progress_->advance();
        --missing_[static_cast<std::size_t>(plan_.frame_of(tile))];
        finish_whole_frames();
    }

    /// Writes those next in order, for each is exposed after the one before it.
    void finish_whole_frames() {
        for (; next_ < plan_.frames() && missing_[static_cast<std::size_t>(next_)] == 0; ++next_) {
            if (!store_.is_finished(next_)) {
                finish(next_);
            } else if (request_.format == render::PictureFormat::png) {
                exposure_.stops(static_cast<std::size_t>(next_), request_.exposure, {});
            }
        }
    }

    void finish(int frame) {
        const std::string method = scene_.method(request_.frames[static_cast<std::size_t>(frame)]);
        const TraceSummary summary = write_traced_picture(request_, plan_, store_, exposure_, frame, method);
        store_.finish_frame(frame);
        progress_->clear();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        fmt::print("{}: {} x {} pixels, {}; {:.2f} s ({:.2f} s of CPU time here), {:.3g} million rays, {:.1f} steps a "
                   "ray; error {:.1e} rad "
                   "(median), {:.1e} (99 %)\n",
                   request_.picture_file(static_cast<std::size_t>(frame)).string(), plan_.width(), plan_.height(),
                   method, seconds, cpu_seconds() - cpu_start_, 1e-6 * summary.rays, summary.steps,
                   summary.median_error, summary.largest_error);
        if (summary.undecided_pixels > 0) {
            fmt::print("{} of {} pixels have rays that ran out of steps, left the chart or were not finite: marked in "
                       "magenta\n",
                       summary.undecided_pixels, summary.pixels);
        }
        std::fflush(stdout);
        start_ = std::chrono::steady_clock::now();
        cpu_start_ = cpu_seconds();
    }

    /// Of all threads of this process.
    static double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

    const TraceRequest& request_;
    const render::TracedScene& scene_;
    const TilePlan& plan_;
    TileStore store_;
    SequenceExposure exposure_;
    int next_ = 0; ///< frame to be written
    std::vector<bool> done_;
    std::vector<std::size_t> missing_; ///< tiles of each frame
    std::optional<ProgressLine> progress_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double cpu_start_ = cpu_seconds();
};

} // namespace

void trace_pictures(const TraceRequest& request, RankLink* link) {
    const bool leads = link == nullptr || link->rank() == 0;
    const render::TracedScene scene(request.scenario, request.accuracy);
    const TilePlan plan(static_cast<int>(request.frames.size()), request.lens.width, request.lens.height);
    // Every camera is checked before any work is done.
    for (const render::CameraPose& pose : request.frames) {
        static_cast<void>(scene.method(pose));
    }
    FramePainter painter(request, scene, plan);
    const MakeTile make = [&](std::size_t tile) { return painter(tile); };
    if (!leads) {
        serve_tiles(request.threads, make, *link);
        return;
    }
    for (const std::string& note : scene.notes()) {
        fmt::print(stderr, "rapidity: note: {}\n", note);
    }
    if (request.restart) {
        discard_tiles(request, plan);
    }
    PictureKeeper(request, scene, plan).make(request.threads, make, link);
}

} // namespace engine
