#include "engine/recorder.h"

#include "sim/bad_input.h"

#include <exception>
#include <iterator>
#include <utility>

namespace engine {
namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T>& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    from.clear();
}

std::size_t size_of(const FlightBatch& batch) {
    return batch.controls.size() + batch.changes.size() + batch.snapshots.size() + batch.events.size() +
           batch.frames.size();
}

void clear(FlightBatch& batch) {
    batch.controls.clear();
    batch.changes.clear();
    batch.snapshots.clear();
    batch.events.clear();
    batch.frames.clear();
}

} // namespace

Recorder::Recorder(std::filesystem::path file, const RecordingHeader& header, const FlightChange& start,
                   Options options)
    : file_(std::move(file)), options_(options) {
    std::error_code none;
    const auto size = std::filesystem::file_size(file_, none);
    if (!none && size > 0) {
        throw sim::BadInput(file_.string(), "", "", "is there already; a recording never overwrites a file");
    }
    news_.latest = start.state;
    try {
        writer_ = std::make_unique<RecordingWriter>(file_, header, start);
        thread_ = std::thread([this] { write_until_closed(); });
    } catch (const std::exception& error) { // a DatabaseError, or no thread to be had
        writer_.reset();
        given_up_ = true;
        trouble_ = name_in_lines() + error.what() + "; the flight is not recorded";
    }
}

Recorder::~Recorder() {
    close();
}

void Recorder::on_tick(const sim::ControlFrame& control, const sim::VehicleState& after) {
    const std::lock_guard lock(mutex_);
    if (!accepts_news()) {
        return;
    }
    if (!identical(control, last_control_)) {
        news_.controls.push_back({after.tick - 1, control});
        last_control_ = control;
    }
    if (after.tick % snapshot_interval == 0) {
        news_.snapshots.push_back(after);
    }
    news_.latest = after;
    has_news_ = true;
}

void Recorder::on_event(const sim::FlightEvent& event) {
    const std::lock_guard lock(mutex_);
    if (accepts_news()) {
        news_.events.push_back(event);
    }
}

void Recorder::on_frame(const ShownFrame& frame) {
    const std::lock_guard lock(mutex_);
    if (accepts_news()) {
        news_.frames.push_back(frame);
    }
}

void Recorder::on_change(const FlightChange& change) {
    const std::lock_guard lock(mutex_);
    if (!accepts_news()) {
        return;
    }
    news_.changes.push_back(change);
    news_.latest = change.state;
    has_news_ = true;
}

bool Recorder::accepts_news() {
    if (!given_up_ && !closing_ && size_of(news_) >= options_.backlog) {
        given_up_ = true;
        trouble_ = name_in_lines() + "the file has not kept up; the rest of the flight is not recorded";
    }
    return !given_up_ && !closing_;
}

std::string Recorder::trouble() const {
    const std::lock_guard lock(mutex_);
    return trouble_;
}

std::string Recorder::name_in_lines() const {
    return "recording " + file_.string() + ": ";
}

void Recorder::write_until_closed() {
    FlightBatch pending;
    bool unwritten = false;
    bool closing = false;
    while (!closing) {
        {
            std::unique_lock lock(mutex_);
            wake_.wait_for(lock, options_.commit_interval, [this] { return closing_; });
            closing = closing_;
            unwritten = unwritten || has_news_;
            take_news(pending);
        }
        if (unwritten) {
            unwritten = !write(pending);
        }
    }
    const std::lock_guard lock(mutex_);
    if (!unwritten && !given_up_) {
        try {
            writer_->finish(pending.latest.tick);
        } catch (const std::exception& error) {
            trouble_ = name_in_lines() + error.what();
        }
    }
}

void Recorder::take_news(FlightBatch& pending) {
    append(pending.controls, news_.controls);
    append(pending.changes, news_.changes);
    append(pending.snapshots, news_.snapshots);
    append(pending.events, news_.events);
    append(pending.frames, news_.frames);
    pending.latest = news_.latest;
    has_news_ = false;
}

bool Recorder::write(FlightBatch& pending) {
    std::string reason;
    try {
        writer_->write(pending);
        clear(pending);
    } catch (const std::exception& error) {
        reason = error.what();
    }
    const std::lock_guard lock(mutex_);
    if (!given_up_) {
        given_up_ = size_of(pending) >= options_.backlog;
        trouble_ = reason.empty() ? "" : name_in_lines() + reason;
        trouble_ += given_up_ ? "; the rest of the flight is not recorded" : "";
    }
    return reason.empty();
}

void Recorder::close() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    wake_.notify_one();
    if (thread_.joinable()) {
        thread_.join();
    }
    writer_.reset();
}

} // namespace engine
