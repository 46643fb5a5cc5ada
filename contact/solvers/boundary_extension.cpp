#include "contact/solvers/boundary_extension.hpp"

#include "base/parallel_rows.hpp"

#include <algorithm>
#include <utility>

namespace asperity::contact {
namespace {

static_assert(rows_in_cell == std::size_t{1} << BoundaryExtension::levels);

constexpr int rows_a_turn = 16;

/// Weights of bilinear interpolation between the centres of cells, in one
/// direction: of the cell that contains a place, and of the nearest other one.
constexpr float own_weight = 0.75F;
constexpr float other_weight = 0.25F;

int halved(int points) {
  return (points + 1) / 2;
}

/// The cells of two nodes per side. The last one of an odd number of points is
/// half as wide.
SharedRows cells_of(const SharedRows& fine) {
  const Grid& grid = fine.grid();
  const Grid coarse{halved(grid.points_x), halved(grid.points_y), grid.length_x,
                    grid.length_y};
  if (fine.ranks() == nullptr)
    return SharedRows(coarse);
  std::vector<int> bounds = fine.bounds();
  for (int& bound : bounds)
    bound = halved(bound);
  return {coarse, *fine.ranks(), std::move(bounds)};
}

float counted(float value) {
  return value;
}

float counted(std::uint8_t freedom) {
  return freedom > 0 ? 1.0F : 0.0F;
}

/// Adds the nodes 2p and 2p + 1 of a row to sums[p].
template <class Value>
void add_pairs(std::size_t points, const Value* nodes, float* sums) {
  const std::size_t pairs = points / 2;
  for (std::size_t p = 0; p < pairs; ++p)
    sums[p] += counted(nodes[2 * p]) + counted(nodes[2 * p + 1]);
  if (points % 2 != 0)
    sums[pairs] += counted(nodes[points - 1]);
}

/// fine[x] = interpolation along x of a row of cells.
void widen(const float* cells, std::size_t points, float* fine) {
  const std::size_t n = (points + 1) / 2;
  const auto put = [&](std::size_t p, float before, float after) {
    const float own = own_weight * cells[p];
    fine[2 * p] = own + other_weight * before;
    if (2 * p + 1 < points)
      fine[2 * p + 1] = own + other_weight * after;
  };
  put(0, cells[n - 1], cells[n > 1 ? 1 : 0]);
  for (std::size_t p = 1; p + 1 < n; ++p) {
    const float own = own_weight * cells[p];
    fine[2 * p] = own + other_weight * cells[p - 1];
    fine[2 * p + 1] = own + other_weight * cells[p + 1];
  }
  if (n > 1)
    put(n - 1, cells[n - 2], cells[0]);
}

/// The transpose of widen().
void narrow(const float* fine, std::size_t points, float* cells) {
  const std::size_t n = (points + 1) / 2;
  const auto at_end = [&](std::size_t p) {
    float own = fine[2 * p];
    if (2 * p + 1 < points)
      own += fine[2 * p + 1];
    float other = fine[p + 1 < n ? 2 * p + 2 : 0];
    if (p > 0)
      other += fine[2 * p - 1];
    else if (points % 2 == 0)
      other += fine[points - 1];
    cells[p] = own_weight * own + other_weight * other;
  };
  at_end(0);
  for (std::size_t p = 1; p + 1 < n; ++p)
    cells[p] = own_weight * (fine[2 * p] + fine[2 * p + 1]) +
               other_weight * (fine[2 * p - 1] + fine[2 * p + 2]);
  if (n > 1)
    at_end(n - 1);
}

} // namespace

BoundaryExtension::Level::Level(const SharedRows& rows_)
    : rows(rows_),
      inverse(rows.size()),
      values(rows.size() + 2 * rows.width()),
      outside(values.size()) {}

BoundaryExtension::BoundaryExtension(const Grid& grid, const Workers& workers)
    : rows_(workers.rows != nullptr ? *workers.rows : SharedRows(grid)),
      threads_(workers.threads),
      outside_(rows_.size() + 2 * rows_.width()) {
  for (std::size_t l = 0; l < levels; ++l)
    levels_.emplace_back(cells_of(l == 0 ? rows_ : levels_.back().rows));
}

/// Calls do_row(iy, scratch) for each row of this process; `scratch` keeps its
/// size from row to row.
template <class DoRow>
void BoundaryExtension::each_row(const SharedRows& rows,
                                 const DoRow& do_row) const {
  const int n_turns = (rows.count() + rows_a_turn - 1) / rows_a_turn;
  parallel_rows(n_turns, threads_, [&](int turn) {
    std::vector<float> scratch;
    const int end = std::min(rows.count(), (turn + 1) * rows_a_turn);
    for (int iy = turn * rows_a_turn; iy < end; ++iy)
      do_row(iy, scratch);
  });
}

/// Sums of the nodes, or cells, of a level over the cells of the next one.
/// @param nodes  the first of this process
template <class Value>
void BoundaryExtension::sum_cells(const SharedRows& fine, const Value* nodes,
                                  const SharedRows& cells, float* sums) const {
  each_row(cells, [&](int iy, std::vector<float>&) {
    float* const own = sums + cells.grid().index(0, iy);
    std::fill_n(own, cells.width(), 0.0F);
    const int end = std::min(2 * iy + 2, fine.count());
    for (int row = 2 * iy; row < end; ++row)
      add_pairs(fine.width(), nodes + fine.grid().index(0, row), own);
  });
}

void BoundaryExtension::build(std::span<const std::uint8_t> is_free) {
  // First the counts, which are exact in single precision.
  sum_cells(rows_, is_free.data(), levels_[0].rows, levels_[0].inverse.data());
  for (std::size_t l = 1; l < levels; ++l)
    sum_cells(levels_[l - 1].rows, levels_[l - 1].inverse.data(),
              levels_[l].rows, levels_[l].inverse.data());
  for (Level& level : levels_)
    each_row(level.rows, [&](int iy, std::vector<float>&) {
      float* const inverse = &level.inverse[level.rows.grid().index(0, iy)];
      for (std::size_t i = 0; i < level.rows.width(); ++i)
        inverse[i] = inverse[i] > 0.0F ? 1.0F / inverse[i] : 0.0F;
    });
}

/// fine = share gain (interpolation of the values of level `coarse`) on a row.
void BoundaryExtension::interpolate(std::size_t coarse, double share, int iy,
                                    std::vector<float>& scratch, float* fine) {
  Level& level = levels_[coarse];
  const SharedRows& fine_rows = coarse == 0 ? rows_ : levels_[coarse - 1].rows;
  const std::size_t n = level.rows.width();
  scratch.resize(n);
  const float gain = static_cast<float>(share) * gains[coarse];
  const float* const own = level.row(level.values, iy / 2);
  const float* const other =
      level.row(level.values, iy % 2 == 0 ? iy / 2 - 1 : iy / 2 + 1);
  for (std::size_t p = 0; p < n; ++p)
    scratch[p] = gain * (own_weight * own[p] + other_weight * other[p]);
  widen(scratch.data(), fine_rows.width(), fine);
}

void BoundaryExtension::extend(double share,
                               std::span<const std::uint8_t> is_free,
                               std::span<const float> residual,
                               std::span<float> extended) {
  const auto sums = [this](std::size_t l) {
    return levels_[l].row(levels_[l].values, 0);
  };
  sum_cells(rows_, residual.data(), levels_[0].rows, sums(0));
  for (std::size_t l = 1; l < levels; ++l)
    sum_cells(levels_[l - 1].rows, sums(l - 1), levels_[l].rows, sums(l));
  for (std::size_t l = levels; l-- > 0;) {
    Level& level = levels_[l];
    each_row(level.rows, [&](int iy, std::vector<float>& scratch) {
      const std::size_t n = level.rows.width();
      const float* const inverse =
          &level.inverse[level.rows.grid().index(0, iy)];
      float* const values = level.row(level.values, iy);
      float* const beyond = level.row(level.outside, iy);
      if (l + 1 < levels)
        interpolate(l + 1, share, iy, scratch, beyond);
      else
        std::fill_n(beyond, n, 0.0F);
      for (std::size_t i = 0; i < n; ++i)
        values[i] = inverse[i] > 0.0F ? inverse[i] * values[i] : beyond[i];
    });
    level.rows.fill_ghost_rows(std::span(level.values));
  }
  each_row(rows_, [&](int iy, std::vector<float>& scratch) {
    const std::size_t first = rows_.grid().index(0, iy);
    float* const own = &extended[first];
    interpolate(0, share, iy, scratch, own);
    for (std::size_t i = 0; i < rows_.width(); ++i)
      own[i] = is_free[first + i] > 0 ? residual[first + i] : own[i];
  });
}

/// values of level `coarse` = the transpose of interpolate().
/// @param outside  with ghost rows
void BoundaryExtension::gather(std::size_t coarse, double share,
                               const SharedRows& fine_rows,
                               const std::vector<float>& outside) {
  Level& level = levels_[coarse];
  const std::size_t width = fine_rows.width();
  const float gain = static_cast<float>(share) * gains[coarse];
  const bool has_row_before = // that has a cell of this process as neighbour
      fine_rows.first() > 0 || fine_rows.grid().points_y % 2 == 0;
  each_row(level.rows, [&](int iy, std::vector<float>& scratch) {
    scratch.resize(width);
    const auto row = [&](int fine) {
      return outside.data() + static_cast<std::size_t>(fine + 1) * width;
    };
    const bool has_second = 2 * iy + 1 < fine_rows.count();
    const float* const first = row(2 * iy);
    const float* const second = row(2 * iy + (has_second ? 1 : 0));
    const float* const before = row(2 * iy - 1);
    const float* const after = row(2 * iy + (has_second ? 2 : 1));
    const float second_weight = has_second ? own_weight : 0.0F;
    const float before_weight = iy > 0 || has_row_before ? other_weight : 0.0F;
    for (std::size_t i = 0; i < width; ++i)
      scratch[i] = gain * (own_weight * first[i] + second_weight * second[i] +
                           before_weight * before[i] + other_weight * after[i]);
    narrow(scratch.data(), width, level.row(level.values, iy));
  });
}

void BoundaryExtension::fold(double share,
                             std::span<const std::uint8_t> is_free,
                             std::span<float> field) {
  each_row(rows_, [&](int iy, std::vector<float>&) {
    const std::size_t first = rows_.grid().index(0, iy);
    float* const outside = outside_.data() + first + rows_.width();
    for (std::size_t i = 0; i < rows_.width(); ++i)
      outside[i] = is_free[first + i] > 0 ? 0.0F : field[first + i];
  });
  rows_.fill_ghost_rows(std::span(outside_));
  gather(0, share, rows_, outside_);
  for (std::size_t l = 0; l + 1 < levels; ++l) {
    Level& level = levels_[l];
    each_row(level.rows, [&](int iy, std::vector<float>&) {
      const float* const inverse =
          &level.inverse[level.rows.grid().index(0, iy)];
      const float* const values = level.row(level.values, iy);
      float* const outside = level.row(level.outside, iy);
      for (std::size_t i = 0; i < level.rows.width(); ++i)
        outside[i] = inverse[i] > 0.0F ? 0.0F : values[i];
    });
    level.rows.fill_ghost_rows(std::span(level.outside));
    gather(l + 1, share, level.rows, level.outside);
  }
  for (std::size_t l = levels; l-- > 0;) { // what each active node takes
    Level& level = levels_[l];
    each_row(level.rows, [&](int iy, std::vector<float>&) {
      const float* const inverse =
          &level.inverse[level.rows.grid().index(0, iy)];
      float* const values = level.row(level.values, iy);
      const float* const above =
          l + 1 < levels ? levels_[l + 1].row(levels_[l + 1].values, iy / 2)
                         : nullptr;
      for (std::size_t i = 0; i < level.rows.width(); ++i)
        values[i] =
            inverse[i] * values[i] + (above != nullptr ? above[i / 2] : 0.0F);
    });
  }
  each_row(rows_, [&](int iy, std::vector<float>&) {
    float* const own = &field[rows_.grid().index(0, iy)];
    const float* const above = levels_[0].row(levels_[0].values, iy / 2);
    for (std::size_t i = 0; i < rows_.width(); ++i)
      own[i] += above[i / 2];
  });
}

} // namespace asperity::contact
