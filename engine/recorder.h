#pragma once

#include "engine/recording_header.h"
#include "engine/recording_writer.h"
#include "engine/tick_sink.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace engine {

/// Records a flight to a file. The flight's thread only notes what changed; a thread of its own writes and commits it.
/// What cannot be written is kept and tried again at the next commit, up to `backlog`; the flight goes on all the same.
class Recorder final : public TickSink {
  public:
    struct Options {
        /// Between two commits; wall time. A killed program loses this much and what one commit takes.
        std::chrono::milliseconds commit_interval{100};
        /// Changes of demand, snapshots and changes that are kept while the file cannot be written, all together; an
        /// hour of a hand that never rests. Beyond it the rest of the flight is not recorded.
        std::size_t backlog = 1'000'000;
    };

    /// Starts the recording of a flight that begins with `start`. Throws sim::BadInput when `file` is there and not
    /// empty: nothing is ever overwritten. Anything else that goes wrong, now or later, is told by trouble().
    Recorder(std::filesystem::path file, const RecordingHeader& header, const FlightChange& start, Options options);
    Recorder(std::filesystem::path file, const RecordingHeader& header, const FlightChange& start)
        : Recorder(std::move(file), header, start, Options()) {}
    ~Recorder() override;
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void on_tick(const sim::ControlFrame& control, const sim::VehicleState& after) override;
    void on_event(const sim::FlightEvent& event) override;
    void on_frame(const ShownFrame& frame) override;
    void on_change(const FlightChange& change) override;
    std::string trouble() const override;

    const std::filesystem::path& file() const { return file_; }

    /// Writes the rest and closes the file; nothing is recorded afterwards. trouble() then says whether all is there.
    void close();

  private:
    bool accepts_news(); ///< with mutex_ held
    void write_until_closed();
    void take_news(FlightBatch& pending); ///< with mutex_ held
    /// True when all of `pending`, which is then empty, is in the file.
    bool write(FlightBatch& pending);
    std::string name_in_lines() const;

    std::filesystem::path file_;
    Options options_;
    std::unique_ptr<RecordingWriter> writer_; ///< none when the file could not be created

    mutable std::mutex mutex_; ///< guards what follows, up to the thread
    std::condition_variable wake_;
    FlightBatch news_; ///< since the writer last looked
    sim::ControlFrame last_control_;
    bool has_news_ = false;
    bool given_up_ = false;
    bool closing_ = false;
    std::string trouble_;

    std::thread thread_;
};

} // namespace engine
