#include "ranks/shared_rows.hpp"

#include "base/require.hpp"

#include <functional>
#include <utility>

namespace asperity {

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
    bytes.push_back(static_cast<std::size_t>(bounds_[r + 1] - bounds_[r]) *
                    width() * sizeof(double));
  return bytes;
}

std::vector<std::size_t> SharedRows::bytes_of_rank_0(std::size_t bytes) const {
  std::vector<std::size_t> all(bounds_.size() - 1, 0);
  all.front() = bytes;
  return all;
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

std::vector<double>
SharedRows::gathered_on_rank_0(std::span<const double> own) const {
  if (ranks_ == nullptr)
    return gathered(own);
  std::vector<double> all(own_ == 0 ? grid_.size() : 0);
  ranks_->exchange(std::as_bytes(own), bytes_of_rank_0(own.size_bytes()),
                   std::as_writable_bytes(std::span(all)),
                   own_ == 0 ? bytes_of_ranks() : bytes_of_rank_0(0));
  return all;
}

std::vector<double> SharedRows::scattered(std::span<const double> all) const {
  if (ranks_ == nullptr)
    return {all.begin(), all.end()};
  if (own_ == 0 && all.size() != grid_.size())
    refuse_argument("all.size()", static_cast<double>(all.size()),
                    "the number of nodes of the grid");
  std::vector<double> own(size());
  ranks_->exchange(std::as_bytes(own_ == 0 ? all : std::span<const double>()),
                   own_ == 0 ? bytes_of_ranks() : bytes_of_rank_0(0),
                   std::as_writable_bytes(std::span(own)),
                   bytes_of_rank_0(size() * sizeof(double)));
  return own;
}

} // namespace asperity
