#include "fem/waves/condensed_q2.hpp"

#include "base/parallel_rows.hpp"
#include "fem/waves/cell_stiffness.hpp"
#include "fem/waves/mirrored_q2.hpp"

#include <algorithm>
#include <numbers>

namespace asperity::fem {
namespace {

/// The block of the wavevector mirrored about the diagonal, which exchanges
/// x-edges and y-edges.
NodeClassBlock mirrored(const NodeClassBlock& block) {
  constexpr std::array<std::size_t, 4> image{0, 2, 1, 3};
  NodeClassBlock mirror{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      mirror[4 * image[i] + image[j]] = block[4 * i + j];
  return mirror;
}

/// Computes four neighbouring blocks in jx; those beyond the last column repeat
/// it.
void fill_blocks(const MirroredQ2& layers, double spring, int first, int mode_y,
                 const Q2Compliance& compliance,
                 std::array<NodeClassBlock, lanes>& blocks) {
  const Grid& grid = compliance.grid;
  SimdBatch theta_x{}, theta_y{}, on_uniform_mode{};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int mode_x =
        std::min(first + static_cast<int>(lane), compliance.columns() - 1);
    theta_x[lane] = 2.0 * std::numbers::pi * mode_x / grid.points_x;
    theta_y[lane] = 2.0 * std::numbers::pi * mode_y / grid.points_y;
  }
  if (first == 0 && mode_y == 0)
    on_uniform_mode[0] = spring;
  std::array<SimdBatch, node_classes * node_classes> packs;
  layers.face_compliance(theta_x, theta_y, on_uniform_mode, packs.data());
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t i = 0; i < packs.size(); ++i)
      blocks[lane][i] = grid.cell_area() * packs[i][lane];
}

} // namespace

Q2Compliance condensed_compliance_q2(const Grid& grid,
                                     const LayeredBlock& block, int threads) {
  require_cells(grid, 2);
  require_block(block);
  const MirroredQ2 layers(grid, block);
  Q2Compliance compliance{grid, {}, relative_nodal_areas(2)};
  const int columns = compliance.columns();
  const bool is_square = grid.is_square();
  compliance.blocks.resize(static_cast<std::size_t>(columns) *
                           static_cast<std::size_t>(compliance.rows()));
  const auto at = [&](int mode_x, int mode_y) -> NodeClassBlock& {
    return compliance.blocks[static_cast<std::size_t>(mode_y) *
                                 static_cast<std::size_t>(columns) +
                             static_cast<std::size_t>(mode_x)];
  };
  const double spring = block.layers.back().shear_modulus * grid.spacing_x();
  parallel_rows(compliance.rows(), threads, [&](int mode_y) {
    constexpr int step = static_cast<int>(lanes);
    std::array<NodeClassBlock, lanes> blocks;
    for (int first = is_square ? mode_y : 0; first < columns; first += step) {
      fill_blocks(layers, spring, first, mode_y, compliance, blocks);
      for (int mode_x = first; mode_x < std::min(columns, first + step);
           ++mode_x) {
        at(mode_x, mode_y) = blocks[static_cast<std::size_t>(mode_x - first)];
        if (is_square && mode_x != mode_y)
          at(mode_y, mode_x) = mirrored(at(mode_x, mode_y));
      }
    }
  });
  return compliance;
}

} // namespace asperity::fem
