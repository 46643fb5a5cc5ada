#include "ranks/workers.hpp"

#include "base/require.hpp"
#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

namespace asperity {
namespace {

std::size_t rows_in_unit(const Grid& grid) {
  return NodeChunks(grid).rows_to_share(grid);
}

/// Bounds after multiples of `step` rows.
std::vector<int> bounds_at(const Grid& grid, std::size_t n_ranks,
                           std::size_t step) {
  const auto rows = static_cast<std::size_t>(grid.points_y);
  const std::size_t steps = (rows + step - 1) / step;
  std::vector<int> bounds(n_ranks + 1);
  for (std::size_t r = 0; r < n_ranks; ++r)
    bounds[r] = static_cast<int>(steps * r / n_ranks * step);
  bounds[n_ranks] = grid.points_y;
  return bounds;
}

/// Whether no rank holds more than 17/16 of the mean number of rows.
bool are_nearly_equal(std::span<const int> bounds) {
  int most = 0;
  for (std::size_t r = 0; r + 1 < bounds.size(); ++r)
    most = std::max(most, bounds[r + 1] - bounds[r]);
  const auto n_ranks = static_cast<long>(bounds.size() - 1);
  return 16 * n_ranks * most <= 17L * bounds.back();
}

/// Rows after which a rank may end: a multiple of those of a unit by a power of
/// four, which makes whole groups on as many coarser grids, if the shares of
/// the ranks stay equal, or nearly so.
std::size_t rows_in_step(const Grid& grid, std::size_t n_ranks) {
  const auto rows = static_cast<std::size_t>(grid.points_y);
  std::size_t step = rows_in_unit(grid);
  for (std::size_t next = 4 * step; next < rows && next * n_ranks < rows + next;
       next *= 4)
    if (are_nearly_equal(bounds_at(grid, n_ranks, next)))
      step = next;
  return step;
}

} // namespace

int most_ranks(const Grid& grid) {
  const auto rows = static_cast<std::size_t>(grid.points_y);
  const std::size_t unit = rows_in_unit(grid);
  return static_cast<int>(std::max<std::size_t>(1, (rows + unit - 1) / unit));
}

std::vector<int> row_bounds(const Grid& grid, int n_ranks) {
  if (n_ranks < 1 || n_ranks > most_ranks(grid))
    refuse_argument("number of ranks", n_ranks,
                    "1 to " + std::to_string(most_ranks(grid)) +
                        " for a grid of " + std::to_string(grid.points_x) +
                        " by " + std::to_string(grid.points_y) + " points");
  const auto ranks = static_cast<std::size_t>(n_ranks);
  return bounds_at(grid, ranks, rows_in_step(grid, ranks));
}

bool holds_whole_groups(const Grid& grid, std::span<const int> bounds) {
  const int unit = static_cast<int>(rows_in_unit(grid));
  return std::ranges::all_of(bounds.first(bounds.size() - 1),
                             [=](int bound) { return bound % unit == 0; }) &&
         std::ranges::adjacent_find(bounds, std::greater_equal<>()) ==
             bounds.end();
}

SharedRows coarse_rows(const SharedRows& rows, const Grid& coarse) {
  std::vector<int> bounds = rows.bounds();
  for (int& bound : bounds)
    bound /= 2;
  if (rows.ranks() == nullptr || !holds_whole_groups(coarse, bounds))
    return SharedRows(coarse);
  return {coarse, *rows.ranks(), bounds};
}

std::vector<std::byte> gathered_sums(const SharedRows& rows,
                                     std::span<const std::byte> own,
                                     std::size_t bytes) {
  const NodeChunks chunks(rows.grid());
  std::vector<std::size_t> counts;
  counts.reserve(rows.bounds().size());
  std::size_t all = 0;
  for (std::size_t r = 0; r + 1 < rows.bounds().size(); ++r) {
    const std::size_t nodes =
        static_cast<std::size_t>(rows.bounds()[r + 1] - rows.bounds()[r]) *
        rows.width();
    counts.push_back(chunks.groups(nodes, rows.grid().size()) * bytes);
    all += counts.back();
  }
  std::vector<std::byte> sums(all);
  rows.ranks()->gather_to_all(own, counts, sums);
  return sums;
}

std::size_t total_count(const Workers& workers, std::size_t own) {
  if (workers.rows == nullptr)
    return own;
  const std::vector<std::size_t> all = values_of_ranks<std::size_t>(
      workers.rows->ranks(), std::span<const std::size_t>(&own, 1));
  return std::accumulate(all.begin(), all.end(), std::size_t{0});
}

} // namespace asperity
