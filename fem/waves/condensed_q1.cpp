#include "fem/waves/condensed_q1.hpp"

#include "base/parallel_rows.hpp"
#include "fem/waves/layer_elimination.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace asperity::fem {
namespace {

using Elimination = LayerElimination<1>;

/// Computes (T_0^-1)_zz of four neighbouring modes in x [m/N]; those beyond the
/// last column repeat it.
void take_compliance(const BlockSymbol& layers,
                     mechanics::FarBoundary far_boundary, const Grid& grid,
                     int first, int mode_y, SimdBatch& compliance) {
  SimdBatch theta_x{}, theta_y{};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int mode_x =
        std::min(first + static_cast<int>(lane), grid.points_x / 2);
    theta_x[lane] = 2.0 * std::numbers::pi * mode_x / grid.points_x;
    theta_y[lane] = 2.0 * std::numbers::pi * mode_y / grid.points_y;
  }
  const std::vector<SimdBatch> materials = layers.at(theta_x, theta_y);
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

} // namespace

std::vector<double> condensed_compliance_q1(const Grid& grid,
                                            const LayeredBlock& block,
                                            int threads) {
  require_cells(grid, 1);
  require_block(block);
  const BlockSymbol layers(grid, 1, block, Elimination::packs,
                           Elimination::layout);
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
      take_compliance(layers, block.far_boundary, grid, first, mode_y, batch);
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
