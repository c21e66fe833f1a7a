#include "engine/ranks/rank_link.h"

#include <limits>
#include <mpi.h>
#include <stdexcept>

namespace engine {
namespace {

/// MPI's world; only the thread that opened it calls MPI (MPI_THREAD_FUNNELED).
class MpiRankLink : public RankLink {
  public:
    MpiRankLink() {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        if (provided < MPI_THREAD_FUNNELED) {
            throw std::runtime_error("this MPI cannot live with threads");
        }
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
    }
    ~MpiRankLink() override { MPI_Finalize(); }
    MpiRankLink(const MpiRankLink&) = delete;
    MpiRankLink& operator=(const MpiRankLink&) = delete;

    int rank() const override { return rank_; }
    int count() const override { return count_; }
    void send(int to, std::span<const std::byte> bytes) override {
        if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
            throw std::runtime_error("a message to another rank is too long");
        }
        MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD);
    }
    std::optional<RankMessage> receive() override {
        int arrived = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &arrived, &status);
        if (arrived == 0) {
            return std::nullopt;
        }
        int size = 0;
        MPI_Get_count(&status, MPI_BYTE, &size);
        RankMessage message{status.MPI_SOURCE, std::vector<std::byte>(static_cast<std::size_t>(size))};
        MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        return message;
    }
    void abort() override { MPI_Abort(MPI_COMM_WORLD, 1); }

  private:
    int rank_ = 0;
    int count_ = 1;
};

} // namespace
} // namespace engine

/// What open_rank_link() looks for in this library; the caller owns the link.
extern "C" engine::RankLink* rapidity_open_rank_link() {
    return new engine::MpiRankLink();
}
