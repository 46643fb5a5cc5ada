#include "fem/waves/condensed_q1.hpp"

#include "base/parallel_rows.hpp"
#include "fem/waves/block_symbol.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

namespace asperity::fem {
namespace {

/// Unknowns of a plane of nodes at one wavevector, and their place in a symbol:
/// S_bb and S_tt as lower triangles by columns, then S_tb by rows, where b is
/// the plane below a layer and t the one on its top.
constexpr std::size_t n_plane_q1 = 3;
constexpr std::size_t top_packs = triangle(n_plane_q1);
constexpr std::size_t to_lower_packs = top_packs + triangle(n_plane_q1);
constexpr std::size_t packs_q1 = to_lower_packs + n_plane_q1 * n_plane_q1;

LayerSymbol::Target layout_q1(std::size_t row, std::size_t column) {
  if (row < column)
    return {};
  if (row < n_plane_q1)
    return {in_triangle(n_plane_q1, row, column)};
  if (column >= n_plane_q1)
    return {top_packs +
            in_triangle(n_plane_q1, row - n_plane_q1, column - n_plane_q1)};
  return {to_lower_packs + (row - n_plane_q1) * n_plane_q1 + column};
}

/// Writes rows of the identity for the components that the far boundary holds.
void hold_top(mechanics::FarBoundary far_boundary, SimdBatch* matrix,
              SimdBatch* to_lower) {
  for (std::size_t row = 0; row < n_plane_q1; ++row) {
    if (!holds(far_boundary, row))
      continue;
    for (std::size_t j = 0; j < n_plane_q1; ++j)
      matrix[in_triangle(n_plane_q1, std::max(row, j), std::min(row, j))] =
          SimdBatch{};
    matrix[in_triangle(n_plane_q1, row, row)] += 1.0;
    std::fill_n(to_lower + row * n_plane_q1, n_plane_q1, SimdBatch{});
  }
}

/// Applies (Q1.2): T_(l+1) in `stiffness` becomes T_l.
/// @param symbol        of layer l, overwritten
/// @param far_boundary  the one on the top of this layer, or null
void take_layer_q1(SimdBatch* symbol,
                   const mechanics::FarBoundary* far_boundary,
                   SimdBatch* stiffness) {
  SimdBatch* const matrix = symbol + top_packs;
  SimdBatch* const to_lower = symbol + to_lower_packs;
  for (std::size_t i = 0; i < triangle(n_plane_q1); ++i)
    matrix[i] += stiffness[i];
  if (far_boundary)
    hold_top(*far_boundary, matrix, to_lower);
  factorise<n_plane_q1>(matrix);
  solve_lower<n_plane_q1, n_plane_q1>(matrix, to_lower);
  std::copy_n(symbol, triangle(n_plane_q1), stiffness);
  take_schur<n_plane_q1, n_plane_q1>(matrix, to_lower, stiffness);
}

/// The wavenumbers (jx, jy) of four modes.
struct FourModes {
  std::array<int, lanes> x, y;
};

/// Computes (T_0^-1)_zz of four modes [m/N].
void take_compliance(const BlockSymbol& layers,
                     mechanics::FarBoundary far_boundary, const Grid& grid,
                     const FourModes& modes, SimdBatch& compliance) {
  SimdBatch theta_x{}, theta_y{};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    theta_x[lane] = 2.0 * std::numbers::pi * modes.x[lane] / grid.points_x;
    theta_y[lane] = 2.0 * std::numbers::pi * modes.y[lane] / grid.points_y;
  }
  const SimdBatches materials = layers.at(theta_x, theta_y);
  std::array<SimdBatch, packs_q1> symbol;
  std::array<SimdBatch, triangle(n_plane_q1)> stiffness{};
  for (std::size_t l = layers.layers(); l-- > 0;) {
    layers.evaluate(l, materials.data(), symbol.data());
    take_layer_q1(symbol.data(), layers.is_last(l) ? &far_boundary : nullptr,
                  stiffness.data());
  }
  factorise<n_plane_q1>(stiffness.data());
  // L^-1 e_z is e_z, and the diagonal has the inverse of D.
  compliance = stiffness[in_triangle(n_plane_q1, 2, 2)];
}

/// Four neighbouring modes in y up to the last one. On a square grid they are
/// the mirror images with jx >= jy, as in condensed_compliance_q1().
FourModes along_y(const Grid& grid, int mode_x, int first, int last) {
  FourModes modes{};
  for (int lane = 0; lane < static_cast<int>(lanes); ++lane) {
    const int mode_y = std::min(first + lane, last);
    const bool is_mirrored = grid.is_square() && mode_y > mode_x;
    modes.x[static_cast<std::size_t>(lane)] = is_mirrored ? mode_y : mode_x;
    modes.y[static_cast<std::size_t>(lane)] = is_mirrored ? mode_x : mode_y;
  }
  return modes;
}

} // namespace

EvenColumn condensed_column_q1(const Grid& grid, const LayeredBlock& block) {
  require_cells(grid, 1);
  require_block(block);
  const auto layers =
      std::make_shared<const BlockSymbol>(grid, 1, block, packs_q1, layout_q1);
  return [=, far_boundary = block.far_boundary](int mode_x,
                                                std::span<double> of_jy) {
    const int n = static_cast<int>(of_jy.size());
    constexpr int step = static_cast<int>(lanes);
    for (int first = 0; first < n; first += step) {
      SimdBatch batch;
      take_compliance(*layers, far_boundary, grid,
                      along_y(grid, mode_x, first, n - 1), batch);
      for (int mode_y = first; mode_y < std::min(n, first + step); ++mode_y)
        of_jy[static_cast<std::size_t>(mode_y)] =
            grid.cell_area() * batch[mode_y - first];
    }
  };
}

std::vector<double> condensed_compliance_q1(const Grid& grid,
                                            const LayeredBlock& block,
                                            int threads) {
  const EvenColumn column = condensed_column_q1(grid, block);
  std::vector<double> compliance(grid.half_spectrum_size());
  const int columns = grid.points_x / 2 + 1, rows = grid.points_y / 2 + 1;
  const bool is_square = grid.is_square();
  const auto at = [&](int mode_x, int mode_y) -> double& {
    return compliance[static_cast<std::size_t>(mode_y) *
                          static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(mode_x)];
  };
  parallel_rows(columns, threads, [&](int mode_x) {
    const int n = is_square ? mode_x + 1 : rows;
    std::vector<double> of_jy(static_cast<std::size_t>(n));
    column(mode_x, of_jy);
    for (int mode_y = 0; mode_y < n; ++mode_y) {
      at(mode_x, mode_y) = of_jy[static_cast<std::size_t>(mode_y)];
      if (is_square) // (x, y) and (y, x) are mirror images
        at(mode_y, mode_x) = at(mode_x, mode_y);
    }
  });
  at(0, 0) = 0.0;
  for (int mode_y = rows; mode_y < grid.points_y; ++mode_y)
    for (int mode_x = 0; mode_x < columns; ++mode_x)
      at(mode_x, mode_y) = at(mode_x, grid.points_y - mode_y);
  return compliance;
}

} // namespace asperity::fem
