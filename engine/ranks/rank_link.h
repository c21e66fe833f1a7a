#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace engine {

/// Bytes from another process of the same run.
struct RankMessage {
    int from = 0;
    std::vector<std::byte> bytes;
};

/// The processes that one command line started on many machines, numbered from 0. To be used by one thread.
class RankLink {
  public:
    RankLink() = default;
    RankLink(const RankLink&) = delete;
    RankLink& operator=(const RankLink&) = delete;
    virtual ~RankLink() = default;

    virtual int rank() const = 0;
    virtual int count() const = 0;
    /// Returns when the bytes may be reused. Messages between two ranks keep their order.
    virtual void send(int to, std::span<const std::byte> bytes) = 0;
    /// A message that has arrived; does not wait for one.
    virtual std::optional<RankMessage> receive() = 0;
    /// Ends all ranks at once, with exit code 1: for a rank that cannot go on.
    virtual void abort() = 0;
};

/// The link to the other ranks when mpirun started this process, nullptr when it runs alone. The library that speaks
/// MPI is loaded only then, so the program runs where no MPI is installed. Throws sim::BadInput when mpirun started it
/// and that library was not built or cannot be loaded.
std::unique_ptr<RankLink> open_rank_link();

} // namespace engine
