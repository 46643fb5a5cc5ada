#include "ranks/shared_rows.hpp"

#include "base/require.hpp"
#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace asperity {
namespace {

/// Most bytes that rank 0 sends or receives at a time: far below the 2^31 that
/// libraries of message passing count, and the memory of a copy.
constexpr std::size_t most_bytes = std::size_t{1} << 22;

/// Some adjacent rows of each rank, as values from the first of its rows.
struct Round {
  std::size_t begin = 0, end = 0;

  /// The part of a rank that holds so many values.
  std::size_t first(std::size_t held) const { return std::min(held, begin); }

  std::size_t count(std::size_t held) const {
    return std::min(held, end) - first(held);
  }
};

/// Values from begin to end - 1 of the whole field.
struct Part {
  std::size_t begin = 0, end = 0;

  std::size_t count() const { return end - begin; }
};

/// What two parts have in common; empty if that is nothing.
Part common(const Part& a, const Part& b) {
  const std::size_t begin = std::max(a.begin, b.begin);
  return {begin, std::max(begin, std::min(a.end, b.end))};
}

/// The rounds in which rank 0 exchanges a whole field with all ranks.
std::vector<Round> rounds_of(const SharedRows& rows) {
  const auto n = static_cast<std::size_t>(rows.ranks()->size());
  const std::size_t a_round =
      std::max<std::size_t>(1, most_bytes / sizeof(double) / n / rows.width());
  std::size_t most_rows = 0;
  for (std::size_t r = 0; r < n; ++r)
    most_rows =
        std::max(most_rows, static_cast<std::size_t>(rows.bounds()[r + 1] -
                                                     rows.bounds()[r]));
  std::vector<Round> rounds;
  for (std::size_t row = 0; row < most_rows; row += a_round)
    rounds.push_back({row * rows.width(), (row + a_round) * rows.width()});
  return rounds;
}

} // namespace

SharedRows::SharedRows(const Grid& grid)
    : grid_(grid), bounds_{0, grid.points_y} {}

SharedRows::SharedRows(const Grid& grid, RankGroup& ranks,
                       std::vector<int> bounds)
    : grid_(grid),
      ranks_(&ranks),
      bounds_(std::move(bounds)),
      own_(static_cast<std::size_t>(ranks.rank())) {
  if (bounds_.size() != static_cast<std::size_t>(ranks.size()) + 1)
    refuse_argument("bounds.size()", static_cast<double>(bounds_.size()),
                    "the number of ranks + 1");
  if (bounds_.front() != 0 || bounds_.back() != grid.points_y ||
      std::ranges::adjacent_find(bounds_, std::greater_equal<>()) !=
          bounds_.end())
    refuse_argument("the last of bounds", bounds_.back(),
                    "points_y, after increasing values from 0");
}

std::vector<std::size_t> SharedRows::bytes_of_ranks() const {
  std::vector<std::size_t> bytes;
  bytes.reserve(bounds_.size());
  for (std::size_t r = 0; r + 1 < bounds_.size(); ++r)
    bytes.push_back(size_of(r) * sizeof(double));
  return bytes;
}

std::vector<std::size_t> SharedRows::bytes_of_rank_0(std::size_t bytes) const {
  std::vector<std::size_t> all(bounds_.size() - 1, 0);
  all.front() = bytes;
  return all;
}

SharedRows::RowsBeside
SharedRows::rows_beside(std::span<const double> own) const {
  const std::span<const double> first = own.first(width());
  const std::span<const double> last = own.last(width());
  RowsBeside beside{{last.begin(), last.end()}, {first.begin(), first.end()}};
  if (ranks_ != nullptr)
    ranks_->swap_edges({std::as_bytes(first), std::as_bytes(last),
                        std::as_writable_bytes(std::span(beside.before)),
                        std::as_writable_bytes(std::span(beside.after))});
  return beside;
}

std::vector<double> SharedRows::row_after(std::span<const double> own) const {
  return rows_beside(own).after;
}

std::vector<double> SharedRows::rows_at(std::span<const double> own, int first,
                                        int count) const {
  const auto begin = static_cast<std::size_t>(first) * width();
  const Part wanted{begin, begin + static_cast<std::size_t>(count) * width()};
  if (ranks_ == nullptr) {
    const auto rows = own.subspan(begin, wanted.count());
    return {rows.begin(), rows.end()};
  }
  const std::vector<Part> all =
      values_of_ranks<Part>(ranks_, std::span(&wanted, 1));
  std::vector<double> result(wanted.count());
  std::vector<double> sent, received;
  for (const Round& round : rounds_of(*this)) {
    const auto part_of = [&](std::size_t r) {
      const std::size_t start = first_of(r) + round.first(size_of(r));
      return Part{start, start + round.count(size_of(r))};
    };
    std::vector<std::size_t> to, from;
    sent.clear();
    for (std::size_t r = 0; r < all.size(); ++r) {
      const Part part = common(all[r], part_of(own_));
      const auto values = own.subspan(
          part.count() > 0 ? part.begin - first_of(own_) : 0, part.count());
      sent.insert(sent.end(), values.begin(), values.end());
      to.push_back(values.size_bytes());
      from.push_back(common(wanted, part_of(r)).count() * sizeof(double));
    }
    received.resize(std::accumulate(from.begin(), from.end(), std::size_t{0}) /
                    sizeof(double));
    ranks_->exchange(std::as_bytes(std::span(sent)), to,
                     std::as_writable_bytes(std::span(received)), from);
    auto next = received.begin();
    for (std::size_t r = 0; r < all.size(); ++r) {
      const Part part = common(wanted, part_of(r));
      const auto n = static_cast<std::ptrdiff_t>(part.count());
      if (n > 0)
        std::copy_n(next, n,
                    result.begin() +
                        static_cast<std::ptrdiff_t>(part.begin - begin));
      next += n;
    }
  }
  return result;
}

std::vector<std::size_t> SharedRows::rows_on(const SharedRows& other) const {
  const auto row = [](int at) { return static_cast<std::size_t>(at); };
  const Part own{row(bounds_[own_]), row(bounds_[own_ + 1])};
  std::vector<std::size_t> counts;
  for (std::size_t r = 0; r + 1 < other.bounds_.size(); ++r)
    counts.push_back(
        common(own, {row(other.bounds_[r]), row(other.bounds_[r + 1])})
            .count());
  return counts;
}

std::vector<double> SharedRows::gathered(std::span<const double> own) const {
  if (own.size() != size())
    refuse_argument("own.size()", static_cast<double>(own.size()),
                    "the number of nodes of this process");
  if (ranks_ == nullptr)
    return {own.begin(), own.end()};
  std::vector<double> all(grid_.size());
  ranks_->gather_to_all(std::as_bytes(own), bytes_of_ranks(),
                        std::as_writable_bytes(std::span(all)));
  return all;
}

void SharedRows::pass_to_rank_0(
    std::span<const double> own,
    const std::function<void(std::span<const double>)>& take) const {
  const std::size_t n_ranks = ranks_ == nullptr ? 1 : bounds_.size() - 1;
  const std::size_t most =
      std::max<std::size_t>(1, most_bytes / sizeof(double) / width()) * width();
  std::vector<double> received;
  for (std::size_t r = 0; r < n_ranks; ++r)
    for (std::size_t at = 0; at < size_of(r); at += most) {
      const std::size_t n = std::min(most, size_of(r) - at);
      if (r == 0) {
        if (own_ == 0)
          take(own.subspan(at, n));
        continue;
      }
      const std::size_t sent = own_ == r ? n : 0;
      received.resize(own_ == 0 ? n : 0);
      std::vector<std::size_t> bytes(n_ranks, 0);
      bytes[r] = received.size() * sizeof(double);
      ranks_->exchange(std::as_bytes(own.subspan(sent > 0 ? at : 0, sent)),
                       bytes_of_rank_0(sent * sizeof(double)),
                       std::as_writable_bytes(std::span(received)), bytes);
      if (own_ == 0)
        take(received);
    }
}

std::vector<double> SharedRows::scattered(std::span<const double> all) const {
  if (ranks_ == nullptr)
    return {all.begin(), all.end()};
  if (own_ == 0 && all.size() != grid_.size())
    refuse_argument("all.size()", static_cast<double>(all.size()),
                    "the number of nodes of the grid");
  std::vector<double> own(size());
  std::vector<double> sent;
  for (const Round& round : rounds_of(*this)) {
    std::vector<std::size_t> bytes = bytes_of_rank_0(0);
    sent.clear();
    for (std::size_t r = 0; own_ == 0 && r < bytes.size(); ++r) {
      const auto part = all.subspan(first_of(r) + round.first(size_of(r)),
                                    round.count(size_of(r)));
      bytes[r] = part.size_bytes();
      sent.insert(sent.end(), part.begin(), part.end());
    }
    const std::span<double> received =
        std::span(own).subspan(round.first(size()), round.count(size()));
    ranks_->exchange(std::as_bytes(std::span(sent)), bytes,
                     std::as_writable_bytes(received),
                     bytes_of_rank_0(received.size_bytes()));
  }
  return own;
}

} // namespace asperity
