#include "fem/waves/condensed_q1.hpp"

#include "base/parallel_rows.hpp"
#include "fem/waves/layer_elimination.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

namespace asperity::fem {
namespace {

using Elimination = LayerElimination<1>;

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
  std::array<SimdBatch, Elimination::packs> symbol;
  std::array<SimdBatch, triangle(Elimination::plane)> stiffness{};
  for (std::size_t l = layers.layers(); l-- > 0;) {
    layers.evaluate(l, materials.data(), symbol.data());
    Elimination::take_layer(symbol.data(),
                            layers.is_last(l) ? &far_boundary : nullptr,
                            SimdBatch{}, stiffness.data());
  }
  factorise<Elimination::plane>(stiffness.data());
  Elimination::face_compliance(stiffness.data(), &compliance);
}

BlockSymbol symbol_of(const Grid& grid, const LayeredBlock& block) {
  require_cells(grid, 1);
  require_block(block);
  return {grid, 1, block, Elimination::packs, Elimination::layout};
}

/// Four neighbouring modes in x; those beyond the last column repeat it.
FourModes along_x(const Grid& grid, int first, int mode_y) {
  FourModes modes{};
  for (int lane = 0; lane < static_cast<int>(lanes); ++lane) {
    modes.x[static_cast<std::size_t>(lane)] =
        std::min(first + lane, grid.points_x / 2);
    modes.y[static_cast<std::size_t>(lane)] = mode_y;
  }
  return modes;
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
  const auto layers =
      std::make_shared<const BlockSymbol>(symbol_of(grid, block));
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
  const BlockSymbol layers = symbol_of(grid, block);
  std::vector<double> compliance(grid.half_spectrum_size());
  const int columns = grid.points_x / 2 + 1;
  const bool is_square = grid.is_square();
  const auto at = [&](int mode_x, int mode_y) -> double& {
    return compliance[static_cast<std::size_t>(mode_y) *
                          static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(mode_x)];
  };
  parallel_rows(grid.points_y / 2 + 1, threads, [&](int mode_y) {
    constexpr int step = static_cast<int>(lanes);
    for (int first = is_square ? mode_y : 0; first < columns; first += step) {
      SimdBatch batch;
      take_compliance(layers, block.far_boundary, grid,
                      along_x(grid, first, mode_y), batch);
      for (int mode_x = first; mode_x < std::min(columns, first + step);
           ++mode_x) {
        at(mode_x, mode_y) = grid.cell_area() * batch[mode_x - first];
        if (is_square) // (x, y) and (y, x) are mirror images
          at(mode_y, mode_x) = at(mode_x, mode_y);
      }
    }
  });
  at(0, 0) = 0.0;
  for (int mode_y = grid.points_y / 2 + 1; mode_y < grid.points_y; ++mode_y)
    for (int mode_x = 0; mode_x < columns; ++mode_x)
      at(mode_x, mode_y) = at(mode_x, grid.points_y - mode_y);
  return compliance;
}

} // namespace asperity::fem
