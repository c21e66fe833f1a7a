#include "engine/trace/tile_farm.h"

#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace engine {
namespace {

constexpr std::size_t no_tile = std::numeric_limits<std::size_t>::max();
constexpr auto nap = std::chrono::microseconds(200);

struct MadeTile {
    std::size_t tile = no_tile;
    std::vector<float> values;
    std::exception_ptr trouble;
};

/// Threads that make the tiles they are given; the giver is one thread that never waits for them.
class Workers {
  public:
    Workers(int threads, const MakeTile& make) {
        for (int i = 0; i < threads; ++i) {
            threads_.emplace_back([this, &make] { work(make); });
        }
    }
    ~Workers() {
        {
            const std::scoped_lock lock(mutex_);
            closed_ = true;
            given_.clear();
        }
        more_.notify_all();
        for (std::thread& thread : threads_) {
            thread.join();
        }
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    void give(std::size_t tile) {
        {
            const std::scoped_lock lock(mutex_);
            given_.push_back(tile);
        }
        more_.notify_one();
    }
    std::optional<MadeTile> take() {
        const std::scoped_lock lock(mutex_);
        if (made_.empty()) {
            return std::nullopt;
        }
        MadeTile tile = std::move(made_.front());
        made_.pop_front();
        return tile;
    }

  private:
    void work(const MakeTile& make) {
        for (;;) {
            std::unique_lock lock(mutex_);
            more_.wait(lock, [this] { return closed_ || !given_.empty(); });
            if (given_.empty()) {
                return;
            }
            MadeTile tile{given_.front(), {}, nullptr};
            given_.pop_front();
            lock.unlock();
            try {
                tile.values = make(tile.tile);
            } catch (...) {
                tile.trouble = std::current_exception();
            }
            lock.lock();
            made_.push_back(std::move(tile));
        }
    }

    std::mutex mutex_;
    std::condition_variable more_;
    bool closed_ = false;
    std::deque<std::size_t> given_;
    std::deque<MadeTile> made_;
    std::vector<std::thread> threads_;
};

// A message to rank 0: the number of a made tile and its values, or no_tile: give me one. From rank 0: a number, or
// no_tile: there are no more.
std::vector<std::byte> message(std::size_t tile, const std::vector<float>& values) {
    std::vector<std::byte> bytes(sizeof tile + values.size() * sizeof(float));
    std::memcpy(bytes.data(), &tile, sizeof tile);
    if (!values.empty()) {
        std::memcpy(bytes.data() + sizeof tile, values.data(), values.size() * sizeof(float));
    }
    return bytes;
}

MadeTile tile_of(const std::vector<std::byte>& bytes) {
    MadeTile tile;
    std::memcpy(&tile.tile, bytes.data(), sizeof tile.tile);
    tile.values.resize((bytes.size() - sizeof tile.tile) / sizeof(float));
    if (!tile.values.empty()) {
        std::memcpy(tile.values.data(), bytes.data() + sizeof tile.tile, tile.values.size() * sizeof(float));
    }
    return tile;
}

/// Rank 0's book: what is still to be handed out, and what is under way.
class Book {
  public:
    explicit Book(const std::vector<bool>& done) {
        for (std::size_t tile = 0; tile < done.size(); ++tile) {
            if (!done[tile]) {
                open_.push_back(tile);
            }
        }
        missing_ = open_.size();
    }
    std::size_t next() {
        if (open_.empty()) {
            return no_tile;
        }
        const std::size_t tile = open_.front();
        open_.pop_front();
        ++under_way_;
        return tile;
    }
    void close() { open_.clear(); }
    void came_back(bool made) {
        --under_way_;
        missing_ -= made ? 1 : 0;
    }
    bool idle() const { return under_way_ == 0 && open_.empty(); }
    bool complete() const { return missing_ == 0; }

  private:
    std::deque<std::size_t> open_;
    std::size_t under_way_ = 0;
    std::size_t missing_ = 0;
};

} // namespace

bool farm_tiles(const std::vector<bool>& done, int threads, const MakeTile& make, const TileStore* store,
                RankLink* link, const TileProgress& progress) {
    Book book(done);
    Workers workers(threads, make);
    std::exception_ptr trouble;
    // Each rank asks as often as it has threads and stops when each request was refused.
    int serving = link == nullptr ? 0 : link->count() - 1;
    const auto keep = [&](const MadeTile& tile) {
        book.came_back(tile.trouble == nullptr);
        if (tile.trouble) {
            trouble = trouble ? trouble : tile.trouble;
            book.close();
        } else {
            store->store(tile.tile, tile.values);
            progress.finished(tile.tile);
        }
    };
    const auto give = [&] {
        if (const std::size_t tile = book.next(); tile != no_tile) {
            workers.give(tile);
        }
    };
    for (int i = 0; i < threads; ++i) {
        give();
    }
    auto last_report = std::chrono::steady_clock::now();
    while (!book.idle() || serving > 0) {
        if (progress.stop()) {
            book.close();
        }
        bool quiet = true;
        if (const std::optional<MadeTile> tile = workers.take()) {
            keep(*tile);
            give();
            quiet = false;
        }
        if (link != nullptr) {
            if (const std::optional<RankMessage> request = link->receive()) {
                quiet = false;
                if (request->bytes.empty()) { // this rank's last word
                    --serving;
                } else {
                    const MadeTile tile = tile_of(request->bytes);
                    if (tile.tile != no_tile) {
                        keep(tile);
                    }
                    link->send(request->from, message(book.next(), {}));
                }
            }
        }
        const auto now = std::chrono::steady_clock::now();
        if (now - last_report > std::chrono::milliseconds(250)) {
            progress.waiting();
            last_report = now;
        }
        if (quiet) {
            std::this_thread::sleep_for(nap);
        }
    }
    if (trouble) {
        std::rethrow_exception(trouble);
    }
    return book.complete();
}

void serve_tiles(int threads, const MakeTile& make, RankLink& link) {
    Workers workers(threads, make);
    int open_requests = 0;
    for (; open_requests < threads; ++open_requests) {
        link.send(0, message(no_tile, {}));
    }
    int at_work = 0;
    while (open_requests > 0 || at_work > 0) {
        bool quiet = true;
        if (const std::optional<RankMessage> order = link.receive()) {
            quiet = false;
            --open_requests;
            if (const std::size_t tile = tile_of(order->bytes).tile; tile != no_tile) {
                workers.give(tile);
                ++at_work;
            }
        }
        if (const std::optional<MadeTile> tile = workers.take()) {
            quiet = false;
            --at_work;
            if (tile->trouble) {
                std::rethrow_exception(tile->trouble);
            }
            link.send(0, message(tile->tile, tile->values));
            ++open_requests;
        }
        if (quiet) {
            std::this_thread::sleep_for(nap);
        }
    }
    link.send(0, {});
}

} // namespace engine
