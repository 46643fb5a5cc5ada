#include "fem/parallel/mpi_group.hpp"

#include "base/array_memory.hpp"
#include "fem/parallel/ranks.hpp"
#include "fem/parallel/slab_fftw.hpp"

#include <mpi.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace asperity::fem {
namespace {

/// The sizes of adjacent parts of a message, in the integers of MPI.
struct MessageParts {
  std::vector<int> counts, starts;

  explicit MessageParts(std::span<const std::size_t> sizes) {
    counts.reserve(sizes.size());
    starts.reserve(sizes.size());
    std::size_t at = 0;
    for (const std::size_t size : sizes) {
      starts.push_back(mpi_count(at, "bytes of a message"));
      counts.push_back(mpi_count(size, "bytes of a message"));
      at += size;
    }
  }
};

class MpiGroup final : public ProgramRanks {
public:
  MpiGroup() : rank_(own_rank()), size_(n_ranks()) {
    MPI_Comm_dup(MPI_COMM_WORLD, &ranks_);
    // Open MPI lets the process keep all memory in one heap. Between the large
    // fields of a contact problem it had gaps of a tenth of its size.
    keep_freed_memory();
  }

  int rank() const override { return rank_; }

  int size() const override { return size_; }

  void gather_to_all(std::span<const std::byte> own,
                     std::span<const std::size_t> counts,
                     std::span<std::byte> all) override {
    constexpr std::size_t most = std::numeric_limits<int>::max();
    if (all.size() > most) {
      for (std::size_t r = 0, at = 0; r < counts.size(); at += counts[r++]) {
        const std::span<std::byte> part = all.subspan(at, counts[r]);
        if (static_cast<int>(r) == rank_)
          std::ranges::copy(own, part.begin());
        broadcast(part, static_cast<int>(r));
      }
      return;
    }
    const MessageParts parts(counts);
    MPI_Allgatherv(own.data(), mpi_count(own.size(), "bytes of a message"),
                   MPI_BYTE, all.data(), parts.counts.data(),
                   parts.starts.data(), MPI_BYTE, ranks_);
  }

  void exchange(std::span<const std::byte> sent,
                std::span<const std::size_t> sent_counts,
                std::span<std::byte> received,
                std::span<const std::size_t> received_counts) override {
    const MessageParts from(sent_counts), to(received_counts);
    MPI_Alltoallv(sent.data(), from.counts.data(), from.starts.data(), MPI_BYTE,
                  received.data(), to.counts.data(), to.starts.data(), MPI_BYTE,
                  ranks_);
  }

  void pass(Direction direction, std::span<const std::byte> sent,
            std::span<std::byte> received) override {
    const int before = (rank_ + size_ - 1) % size_;
    const int after = (rank_ + 1) % size_;
    const bool is_forwards = direction == Direction::forwards;
    const int tag = static_cast<int>(direction);
    MPI_Sendrecv(sent.data(), mpi_count(sent.size(), "bytes of a row"),
                 MPI_BYTE, is_forwards ? after : before, tag, received.data(),
                 mpi_count(received.size(), "bytes of a row"), MPI_BYTE,
                 is_forwards ? before : after, tag, ranks_, MPI_STATUS_IGNORE);
  }

  void make_transforms(const Grid& grid, int rows,
                       std::shared_ptr<SlabTransforms<float>>& made) override {
    made = slab_transforms<float>(grid, rows, ranks_);
  }

  void make_transforms(const Grid& grid, int rows,
                       std::shared_ptr<SlabTransforms<double>>& made) override {
    made = slab_transforms<double>(grid, rows, ranks_);
  }

  void from_rank_0(std::span<std::byte> bytes) override {
    broadcast_from_rank_0(bytes);
  }

private:
  int rank_, size_;
  MPI_Comm ranks_ = MPI_COMM_NULL;
};

} // namespace

ProgramRanks& mpi_group() {
  static MpiGroup group;
  return group;
}

} // namespace asperity::fem
