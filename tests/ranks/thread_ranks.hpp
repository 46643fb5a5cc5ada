#pragma once

// Ranks that are threads of one process, so that the code for shared rows can
// be tested without MPI.

#include "base/ranks/root_work.hpp"

#include <gtest/gtest.h>

#include <condition_variable>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace asperity::tests {

/// The place where the threads of a group meet. If one has failed, the others
/// throw instead of waiting for it.
class MeetingPlace {
public:
  explicit MeetingPlace(int size)
      : size_(size), data_(static_cast<std::size_t>(size)) {}

  int size() const { return size_; }

  void wait() {
    std::unique_lock lock(mutex_);
    const int meeting = meetings_;
    if (++arrived_ == size_) {
      arrived_ = 0;
      ++meetings_;
      all_here_.notify_all();
    }
    all_here_.wait(lock, [&] { return meetings_ != meeting || has_failed_; });
    if (has_failed_)
      throw std::runtime_error("another rank failed");
  }

  void fail() {
    const std::lock_guard lock(mutex_);
    has_failed_ = true;
    all_here_.notify_all();
  }

  /// What each rank shows to the others between two calls of wait().
  std::vector<std::vector<std::span<const std::byte>>>& data() { return data_; }

private:
  int size_;
  std::mutex mutex_;
  std::condition_variable all_here_;
  int arrived_ = 0, meetings_ = 0;
  bool has_failed_ = false;
  std::vector<std::vector<std::span<const std::byte>>> data_;
};

class ThreadRank final : public ProgramRanks {
public:
  ThreadRank(MeetingPlace& place, int rank) : place_(place), rank_(rank) {}

  int rank() const override { return rank_; }

  int size() const override { return place_.size(); }

  void gather_to_all(std::span<const std::byte> own,
                     std::span<const std::size_t> counts,
                     std::span<std::byte> all) override {
    show({own});
    std::size_t at = 0;
    for (std::size_t r = 0; r < counts.size(); ++r) {
      copy(place_.data()[r][0], all.subspan(at, counts[r]));
      at += counts[r];
    }
    place_.wait();
  }

  void exchange(std::span<const std::byte> sent,
                std::span<const std::size_t> sent_counts,
                std::span<std::byte> received,
                std::span<const std::size_t> received_counts) override {
    std::vector<std::span<const std::byte>> parts;
    std::size_t at = 0;
    for (const std::size_t count : sent_counts) {
      parts.push_back(sent.subspan(at, count));
      at += count;
    }
    show(std::move(parts));
    at = 0;
    for (std::size_t r = 0; r < received_counts.size(); ++r) {
      copy(place_.data()[r][static_cast<std::size_t>(rank_)],
           received.subspan(at, received_counts[r]));
      at += received_counts[r];
    }
    place_.wait();
  }

  void pass(Direction direction, std::span<const std::byte> sent,
            std::span<std::byte> received) override {
    show({sent});
    const auto n = static_cast<std::size_t>(size());
    const auto own = static_cast<std::size_t>(rank_);
    const std::size_t from =
        direction == Direction::forwards ? own + n - 1 : own + 1;
    copy(place_.data()[from % n][0], received);
    place_.wait();
  }

  void from_rank_0(std::span<std::byte> bytes) override {
    show({bytes});
    if (rank_ != 0)
      copy(place_.data()[0][0], bytes);
    place_.wait();
  }

  void make_transforms(const Grid&, int,
                       std::shared_ptr<SlabTransforms<float>>&) override {
    throw std::logic_error("threads have no transforms on slabs");
  }

  void make_transforms(const Grid&, int,
                       std::shared_ptr<SlabTransforms<double>>&) override {
    throw std::logic_error("threads have no transforms on slabs");
  }

private:
  void show(std::vector<std::span<const std::byte>> data) {
    place_.data()[static_cast<std::size_t>(rank_)] = std::move(data);
    place_.wait();
  }

  static void copy(std::span<const std::byte> from, std::span<std::byte> to) {
    if (from.size() != to.size())
      throw std::logic_error("sent and received sizes differ");
    if (!from.empty())
      std::memcpy(to.data(), from.data(), from.size());
  }

  MeetingPlace& place_;
  int rank_;
};

/// Calls act(rank) on n threads at a time; a failure of any is a failure of the
/// test.
inline void on_thread_ranks(int n,
                            const std::function<void(ProgramRanks&)>& act) {
  MeetingPlace place(n);
  std::vector<std::thread> threads;
  for (int r = 0; r < n; ++r)
    threads.emplace_back([&place, &act, r] {
      ThreadRank rank(place, r);
      try {
        act(rank);
      } catch (const std::exception& error) {
        ADD_FAILURE() << "rank " << r << ": " << error.what();
        place.fail();
      }
    });
  for (std::thread& thread : threads)
    thread.join();
}

} // namespace asperity::tests
