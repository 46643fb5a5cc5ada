#include "contact/solvers/boundary_extension.hpp"

#include "base/parallel_rows.hpp"
#include "contact/solvers/extension_rows.hpp"

#include <algorithm>
#include <utility>

namespace asperity::contact {
namespace {

constexpr int rows_a_turn = 16;

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

BoundaryExtension::Level::Level(const SharedRows& own_,
                                const SharedRows& stored_, float variance_)
    : own(own_),
      stored(stored_),
      variance(variance_),
      shares(stored.size()),
      values(stored.size() + 2 * stored.width()) {}

BoundaryExtension::BoundaryExtension(const Grid& grid, const Workers& workers)
    : rows_(workers.rows != nullptr ? *workers.rows : SharedRows(grid)),
      threads_(workers.threads),
      outside_(rows_.size() + 2 * rows_.width()) {
  SharedRows fine = rows_;
  float variance = variance_ratio;
  for (bool is_coarsest = false; !is_coarsest; variance *= variance_ratio) {
    const SharedRows cells = cells_of(fine);
    is_coarsest = std::max(cells.grid().points_x, cells.grid().points_y) <=
                  coarsest_cells;
    const bool is_shared =
        cells.ranks() != nullptr && !is_coarsest && has_even_bounds(cells);
    levels_.emplace_back(cells, is_shared ? cells : SharedRows(cells.grid()),
                         is_coarsest ? coarsest_variance * variance : variance);
    fine = levels_.back().stored;
  }
}

/// Calls do_row(iy, scratch) for each row of this process; the arrays of
/// `scratch` keep their sizes from row to row.
template <class DoRow>
void BoundaryExtension::each_row(const SharedRows& rows,
                                 const DoRow& do_row) const {
  const int n_turns = (rows.count() + rows_a_turn - 1) / rows_a_turn;
  parallel_rows(n_turns, threads_, [&](int turn) {
    Scratch scratch;
    const int end = std::min(rows.count(), (turn + 1) * rows_a_turn);
    for (int iy = turn * rows_a_turn; iy < end; ++iy)
      do_row(iy, scratch);
  });
}

/// Gathers the rows of all ranks, where every rank stores all and computes its
/// own. Collective.
/// @param rows  the stored rows
void BoundaryExtension::complete(const Level& level, std::span<float> rows) {
  if (level.own.ranks() == level.stored.ranks())
    return;
  const std::size_t width = level.own.width();
  const std::vector<int>& bounds = level.own.bounds();
  std::vector<std::size_t> bytes;
  for (std::size_t r = 0; r + 1 < bounds.size(); ++r)
    bytes.push_back(static_cast<std::size_t>(bounds[r + 1] - bounds[r]) *
                    width * sizeof(float));
  const std::span<const float> own = rows.subspan(
      static_cast<std::size_t>(level.offset()) * width, level.own.size());
  const std::vector<float> sent(own.begin(), own.end());
  level.own.ranks()->gather_to_all(std::as_bytes(std::span(sent)), bytes,
                                   std::as_writable_bytes(rows));
}

/// values of a level = sums over its cells, to which finish(shares, sums) is
/// applied row by row.
/// @param nodes  or cells of the finer level, from the first of this process
template <class Value, class Finish>
void BoundaryExtension::sum_cells(const SharedRows& fine, const Value* nodes,
                                  Level& level, const Finish& finish) const {
  each_row(level.own, [&](int iy, Scratch&) {
    float* const sums = level.row(level.offset() + iy);
    std::fill_n(sums, level.own.width(), 0.0F);
    const int end = std::min(2 * iy + 2, fine.count());
    for (int row = 2 * iy; row < end; ++row)
      add_pairs(fine.width(), nodes + fine.grid().index(0, row), sums);
    finish(level.shares_row(level.offset() + iy), sums);
  });
  complete(level, level.stored_values());
}

/// The same on all levels, from the nodes to the coarsest one; calls
/// finish(level, shares, sums).
template <class Value, class Finish>
void BoundaryExtension::sum_levels(const Value* nodes, const Finish& finish) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    const auto finish_row = [&](float* shares, float* sums) {
      finish(level, shares, sums);
    };
    if (l == 0)
      sum_cells(rows_, nodes, level, finish_row);
    else
      sum_cells(levels_[l - 1].stored, levels_[l - 1].row(0), level,
                finish_row);
  }
}

void BoundaryExtension::build(double share,
                              std::span<const std::uint8_t> is_free) {
  share_ = static_cast<float>(share);
  sum_levels(is_free.data(),
             [this](const Level& level, float* shares, float* precision) {
               share_precision(level.own.width(), scale_of(level),
                               level.variance, precision, shares);
             });
  for (Level& level : levels_)
    complete(level, level.shares);
}

/// fine = interpolation of the values of a level on a row of the finer one.
/// @param scratch  for a row of the level
void BoundaryExtension::interpolate(Level& level, std::size_t points, int iy,
                                    std::vector<float>& scratch, float* fine) {
  const std::size_t n = level.own.width();
  scratch.resize(n);
  const int cells = level.offset() + iy / 2;
  const float* const own = level.row(cells);
  const float* const other = level.row(iy % 2 == 0 ? cells - 1 : cells + 1);
  mix_rows(n, own, other, scratch.data());
  widen_row(scratch.data(), points, fine);
}

void BoundaryExtension::extend(std::span<const std::uint8_t> is_free,
                               std::span<const float> residual,
                               std::span<float> extended) {
  sum_levels(residual.data(),
             [this](const Level& level, const float* shares, float* sums) {
               scale_row(level.own.width(), scale_of(level), shares, sums);
             });
  for (std::size_t l = levels_.size(); l-- > 0;) {
    Level& level = levels_[l];
    const std::size_t n = level.own.width();
    each_row(level.stored, [&](int iy, Scratch& scratch) {
      scratch.row.resize(n, 0.0F);
      if (l + 1 < levels_.size())
        interpolate(levels_[l + 1], n, iy, scratch.cells, scratch.row.data());
      add_beyond(n, level.variance, level.shares_row(iy), scratch.row.data(),
                 level.row(iy));
    });
    level.stored.fill_ghost_rows(std::span(level.values));
  }
  each_row(rows_, [&](int iy, Scratch& scratch) {
    const std::size_t first = rows_.grid().index(0, iy);
    float* const own = &extended[first];
    interpolate(levels_[0], rows_.width(), iy, scratch.cells, own);
    take_active(rows_.width(), &is_free[first], &residual[first], own);
  });
}

/// values of a level = its shares times the transpose of interpolate().
/// @param field  values of the nodes, or of the cells of the finer level, with
///               ghost rows
void BoundaryExtension::gather(const SharedRows& fine, const float* field,
                               Level& level) const {
  const std::size_t width = fine.width();
  const bool has_row_before = // that has a cell of this process as neighbour
      fine.first() > 0 || fine.grid().points_y % 2 == 0;
  each_row(level.own, [&](int iy, Scratch& scratch) {
    scratch.row.resize(width);
    const auto row = [&](int y) {
      return field + static_cast<std::size_t>(y + 1) * width;
    };
    const bool has_second = 2 * iy + 1 < fine.count();
    const bool has_before = iy > 0 || has_row_before;
    sum_rows(width,
             {row(2 * iy), row(2 * iy + (has_second ? 1 : 0)), row(2 * iy - 1),
              row(2 * iy + (has_second ? 2 : 1))},
             {own_weight, has_second ? own_weight : 0.0F,
              has_before ? other_weight : 0.0F, other_weight},
             scratch.row.data());
    float* const values = level.row(level.offset() + iy);
    narrow_row(scratch.row.data(), width, values);
    scale_row(level.own.width(), 1.0F, level.shares_row(level.offset() + iy),
              values);
  });
  complete(level, level.stored_values());
}

void BoundaryExtension::fold(std::span<const std::uint8_t> is_free,
                             std::span<float> field) {
  each_row(rows_, [&](int iy, Scratch&) {
    const std::size_t first = rows_.grid().index(0, iy);
    take_inactive(rows_.width(), &is_free[first], &field[first],
                  outside_.data() + first + rows_.width());
  });
  rows_.fill_ghost_rows(std::span(outside_));
  gather(rows_, outside_.data(), levels_[0]);
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
    levels_[l].stored.fill_ghost_rows(std::span(levels_[l].values));
    gather(levels_[l].stored, levels_[l].values.data(), levels_[l + 1]);
  }
  for (std::size_t l = levels_.size(); l-- > 0;) { // what each cell takes
    Level& level = levels_[l];
    each_row(level.stored, [&](int iy, Scratch&) {
      const float* const above =
          l + 1 < levels_.size()
              ? levels_[l + 1].row(levels_[l + 1].offset() + iy / 2)
              : nullptr;
      pass_down(level.own.width(), level.variance, level.shares_row(iy), above,
                level.row(iy));
    });
  }
  each_row(rows_, [&](int iy, Scratch&) {
    add_above(rows_.width(), share_,
              levels_[0].row(levels_[0].offset() + iy / 2),
              &field[rows_.grid().index(0, iy)]);
  });
}

} // namespace asperity::contact
