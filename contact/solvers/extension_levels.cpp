#include "contact/solvers/extension_levels.hpp"

#include <algorithm>
#include <utility>

namespace asperity::contact {
namespace {

/// Cells per side of the coarsest level, at most.
constexpr int coarsest_cells = 4;

/// Variance of the difference of cells of a level from those of the next one,
/// over that of the preceding level: C(q) is proportional to 1/q.
constexpr float variance_ratio = 0.5F;

/// Variance of the cells of the coarsest level, over that of their difference
/// from cells of twice the side. It is nearly without effect.
constexpr float coarsest_variance = 4.0F;

int halved(int points) {
  return (points + 1) / 2;
}

/// The cells of two nodes per side. The last one of an odd number of points is
/// half as wide.
Grid cells_of(const Grid& fine) {
  return {halved(fine.points_x), halved(fine.points_y), fine.length_x,
          fine.length_y};
}

/// The rows of cells of each rank; fine.bounds() are even, except for the last.
SharedRows cells_of(const SharedRows& fine) {
  const Grid coarse = cells_of(fine.grid());
  if (fine.ranks() == nullptr)
    return SharedRows(coarse);
  std::vector<int> bounds = fine.bounds();
  for (int& bound : bounds)
    bound = halved(bound);
  return {coarse, *fine.ranks(), std::move(bounds)};
}

/// Whether no cell of two rows belongs to two ranks.
bool has_even_bounds(const SharedRows& rows) {
  return std::ranges::all_of(
      std::span(rows.bounds()).first(rows.bounds().size() - 1),
      [](int bound) { return bound % 2 == 0; });
}

} // namespace

ExtensionLevel::ExtensionLevel(const SharedRows& own_,
                               const SharedRows& stored_, float variance_)
    : own(own_),
      stored(stored_),
      variance(variance_),
      shares(stored.size()),
      values(stored.size() + 2 * stored.width()) {}

void ExtensionLevel::complete(std::span<float> rows) const {
  if (own.ranks() == stored.ranks())
    return;
  const std::size_t width = own.width();
  const std::vector<int>& bounds = own.bounds();
  std::vector<std::size_t> bytes;
  for (std::size_t r = 0; r + 1 < bounds.size(); ++r)
    bytes.push_back(static_cast<std::size_t>(bounds[r + 1] - bounds[r]) *
                    width * sizeof(float));
  const std::span<const float> computed =
      rows.subspan(static_cast<std::size_t>(offset()) * width, own.size());
  const std::vector<float> sent(computed.begin(), computed.end());
  own.ranks()->gather_to_all(std::as_bytes(std::span(sent)), bytes,
                             std::as_writable_bytes(rows));
}

std::vector<ExtensionLevel> extension_levels(const SharedRows& rows) {
  std::vector<ExtensionLevel> levels;
  SharedRows fine = rows;
  float variance = variance_ratio;
  for (bool is_coarsest = false; !is_coarsest; variance *= variance_ratio) {
    const SharedRows cells = cells_of(fine);
    is_coarsest = std::max(cells.grid().points_x, cells.grid().points_y) <=
                  coarsest_cells;
    const bool is_shared =
        cells.ranks() != nullptr && !is_coarsest && has_even_bounds(cells);
    levels.emplace_back(cells, is_shared ? cells : SharedRows(cells.grid()),
                        is_coarsest ? coarsest_variance * variance : variance);
    fine = levels.back().stored;
  }
  return levels;
}

} // namespace asperity::contact
