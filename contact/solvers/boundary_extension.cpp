#include "contact/solvers/boundary_extension.hpp"

#include "base/parallel_rows.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace asperity::contact {
namespace {

constexpr int rows_a_turn = 16;

/// Calls do_run(begin, end) for each run of active blocks of a row of n nodes,
/// the first of which is the node `first` of this process.
template <class DoRun>
void each_active_run(const BlockFlags& blocks, std::size_t first, std::size_t n,
                     const DoRun& do_run) {
  const std::size_t last = blocks_of(first + n);
  for (std::size_t block = first / block_nodes; block < last; ++block) {
    if (blocks[block] == 0)
      continue;
    const std::size_t begin = std::max(first, block * block_nodes) - first;
    while (block < last && blocks[block] != 0)
      ++block;
    do_run(begin, std::min(n, block * block_nodes - first));
  }
}

} // namespace

BoundaryExtension::BoundaryExtension(const Grid& grid, const Workers& workers,
                                     Continuation continuation)
    : rows_(workers.rows != nullptr ? *workers.rows : SharedRows(grid)),
      threads_(workers.threads),
      continuation_(continuation),
      levels_(extension_levels(rows_)) {}

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

/// Calls sum_row(its two rows of nodes, shares, values) for each row of cells.
/// @param nodes  or cells of the finer level, from the first of this process
template <class Value, class SumRow>
void BoundaryExtension::each_row_of_cells(const SharedRows& fine,
                                          const Value* nodes,
                                          ExtensionLevel& level,
                                          const SumRow& sum_row) const {
  each_row(level.own, [&](int iy, Scratch&) {
    const Value* const first = nodes + fine.grid().index(0, 2 * iy);
    const bool has_second = 2 * iy + 1 < fine.count();
    sum_row(RowPair<Value>{first, has_second ? first + fine.width() : nullptr},
            level.shares_row(level.offset() + iy),
            level.row(level.offset() + iy));
  });
  level.complete(level.stored_values());
}

/// The same on all levels, from the nodes to the coarsest one; calls
/// sum_row(level, points of the finer rows, these rows, shares, values).
template <class Value, class SumRow>
void BoundaryExtension::sum_levels(const Value* nodes, const SumRow& sum_row) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    ExtensionLevel& level = levels_[l];
    const SharedRows& fine = l == 0 ? rows_ : levels_[l - 1].stored;
    const auto sum = [&](const auto& rows, float* shares, float* values) {
      sum_row(level, fine.width(), rows, shares, values);
    };
    if (l == 0)
      each_row_of_cells(fine, nodes, level, sum);
    else
      each_row_of_cells(fine, std::as_const(levels_[l - 1]).row(0), level, sum);
  }
}

void BoundaryExtension::build(double share,
                              std::span<const std::uint8_t> is_free) {
  share_ = static_cast<float>(share);
  sum_levels(is_free.data(),
             [this](const ExtensionLevel& level, std::size_t points,
                    const auto& rows, float* shares, float* precision) {
               share_precision(points, rows, scale_of(level), level.variance,
                               precision, shares);
             });
  for (ExtensionLevel& level : levels_)
    level.complete(level.shares);
}

/// fine = interpolation of the values of a level on a row of the finer one.
/// @param scratch  for a row of the level
void BoundaryExtension::interpolate(ExtensionLevel& level, std::size_t points,
                                    int iy, std::vector<float>& scratch,
                                    float* fine) const {
  const std::size_t n = level.own.width();
  scratch.resize(n);
  const int cells = level.offset() + iy / 2;
  const float* const own = level.row(cells);
  const float* const other = level.row(iy % 2 == 0 ? cells - 1 : cells + 1);
  mix_rows(n, own, other, scratch.data());
  widen_row(scratch.data(), points, continuation_, fine);
}

/// Sets the rows beyond the first and the last one that this process stores.
void BoundaryExtension::fill_ghost_rows(ExtensionLevel& level) const {
  if (!is_mirrored()) {
    level.stored.fill_ghost_rows(std::span(level.values));
    return;
  }
  const int count = level.stored.count();
  std::copy_n(level.row(0), level.stored.width(), level.row(-1));
  std::copy_n(level.row(count - 1), level.stored.width(), level.row(count));
}

void BoundaryExtension::extend(const Active& active,
                               std::span<const float> residual,
                               std::span<float> extended) {
  sum_levels(residual.data(),
             [this](const ExtensionLevel& level, std::size_t points,
                    const auto& rows, const float* shares, float* sums) {
               sum_cells(points, rows, scale_of(level), shares, sums);
             });
  for (std::size_t l = levels_.size(); l-- > 0;) {
    ExtensionLevel& level = levels_[l];
    const std::size_t n = level.own.width();
    each_row(level.stored, [&](int iy, Scratch& scratch) {
      scratch.row.resize(n, 0.0F);
      if (l + 1 < levels_.size())
        interpolate(levels_[l + 1], n, iy, scratch.cells, scratch.row.data());
      add_beyond(n, level.variance, level.shares_row(iy), scratch.row.data(),
                 level.row(iy));
    });
    fill_ghost_rows(level);
  }
  each_row(rows_, [&](int iy, Scratch& scratch) {
    const std::size_t first = rows_.grid().index(0, iy);
    scratch.row.resize(rows_.width());
    float* const own = scratch.row.data();
    interpolate(levels_[0], rows_.width(), iy, scratch.cells, own);
    each_active_run(active.blocks, first, rows_.width(),
                    [&](std::size_t begin, std::size_t end) {
                      take_active(end - begin, &active.is_free[first + begin],
                                  &residual[first + begin], own + begin);
                    });
    std::ranges::copy(scratch.row, &extended[first]);
  });
}

/// values of a level = its shares times the transpose of interpolate().
/// @param row  row(iy, scratch): values of a row of nodes, or of cells of the
///             finer level, from the row before those of this process to the
///             one after them; called for one row after another
template <class Row>
void BoundaryExtension::gather(const SharedRows& fine, const Row& row,
                               ExtensionLevel& level) const {
  const std::size_t width = fine.width();
  const bool has_row_before = // that has a cell of this process as neighbour
      is_mirrored() || fine.first() > 0 || fine.grid().points_y % 2 == 0;
  each_row(level.own, [&](int iy, Scratch& scratch) {
    scratch.row.resize(width);
    const bool has_second = 2 * iy + 1 < fine.count();
    const bool has_before = iy > 0 || has_row_before;
    const bool has_after = has_second || !is_mirrored();
    const float* const before = row(2 * iy - 1, scratch);
    const float* const first = row(2 * iy, scratch);
    const float* const second = row(2 * iy + (has_second ? 1 : 0), scratch);
    const float* const after = row(2 * iy + (has_second ? 2 : 1), scratch);
    sum_rows(width, {first, second, before, after},
             {own_weight, has_second ? own_weight : 0.0F,
              has_before ? other_weight : 0.0F,
              has_after ? other_weight : 0.0F},
             scratch.row.data());
    narrow_row(scratch.row.data(), width, continuation_,
               level.shares_row(level.offset() + iy),
               level.row(level.offset() + iy));
  });
  level.complete(level.stored_values());
}

/// Receives the rows of other ranks beside those of this process, 0 at the
/// active nodes.
void BoundaryExtension::swap_edges(const Active& active,
                                   std::span<const float> field) {
  if (rows_.ranks() == nullptr)
    return;
  const std::size_t width = rows_.width();
  edges_.resize(4 * width);
  no_freedom_.resize(width, 0);
  const auto edge = [&](std::size_t i) {
    return std::span(edges_).subspan(i * width, width);
  };
  const std::size_t last = rows_.size() - width;
  take_inactive(width, {field.data(), active.is_free.data()}, edge(1).data());
  take_inactive(width, {&field[last], &active.is_free[last]}, edge(2).data());
  rows_.ranks()->swap_edges({std::as_bytes(edge(1)), std::as_bytes(edge(2)),
                             std::as_writable_bytes(edge(0)),
                             std::as_writable_bytes(edge(3))});
}

/// A row of a field, on the continuation of the grid.
MaskedRow BoundaryExtension::row_of(const Active& active, const float* field,
                                    int iy) const {
  const bool is_outside = iy < 0 || iy >= rows_.count();
  if (is_outside && rows_.ranks() != nullptr)
    return {edges_.data() + (iy < 0 ? 0 : 3 * rows_.width()),
            no_freedom_.data()};
  const int last = rows_.count() - 1;
  const int beyond = (iy < 0) == is_mirrored() ? 0 : last;
  const std::size_t first = rows_.grid().index(0, is_outside ? beyond : iy);
  return {field + first, &active.is_free[first]};
}

/// The same, 0 at the active nodes. The rows of a turn are asked for one after
/// another, so that each is computed once.
const float* BoundaryExtension::inactive_row(const Active& active,
                                             const float* field, int iy,
                                             Scratch& scratch) const {
  const std::size_t width = rows_.width();
  scratch.inactive.resize(4 * width);
  float* const place =
      scratch.inactive.data() + static_cast<std::size_t>(iy + 4) % 4 * width;
  if (iy > scratch.last_inactive) {
    take_inactive(width, row_of(active, field, iy), place);
    scratch.last_inactive = iy;
  }
  return place;
}

void BoundaryExtension::fold(const Active& active, std::span<float> field) {
  swap_edges(active, field);
  gather(
      rows_,
      [&](int iy, Scratch& scratch) {
        return inactive_row(active, field.data(), iy, scratch);
      },
      levels_[0]);
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
    fill_ghost_rows(levels_[l]);
    gather(
        levels_[l].stored,
        [&](int iy, Scratch&) { return std::as_const(levels_[l]).row(iy); },
        levels_[l + 1]);
  }
  for (std::size_t l = levels_.size(); l-- > 0;) // what each cell takes
    each_row(levels_[l].stored, [&](int iy, Scratch&) { pass_down_to(l, iy); });
  each_row(levels_[0].own, [&](int iy, Scratch&) {
    const float* const above = levels_[0].row(levels_[0].offset() + iy);
    const int end = std::min(2 * iy + 2, rows_.count());
    for (int row = 2 * iy; row < end; ++row) {
      const std::size_t first = rows_.grid().index(0, row);
      each_active_run(active.blocks, first, rows_.width(),
                      [&](std::size_t begin, std::size_t run_end) {
                        add_above(begin / 2 * 2, run_end, share_, above,
                                  &field[first]);
                      });
    }
  });
}

/// What the cells of a row take, from what their sums give to them and to the
/// cells above.
void BoundaryExtension::pass_down_to(std::size_t l, int iy) {
  ExtensionLevel& level = levels_[l];
  const float* const above =
      l + 1 < levels_.size()
          ? levels_[l + 1].row(levels_[l + 1].offset() + iy / 2)
          : nullptr;
  pass_down(level.own.width(), level.variance, level.shares_row(iy), above,
            level.row(iy));
}

} // namespace asperity::contact
