#include "fem/waves/condensed_q2.hpp"

#include "base/parallel_rows.hpp"
#include "fem/waves/cell_stiffness.hpp"
#include "fem/waves/mirrored_q2.hpp"

#include <algorithm>
#include <memory>
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

using FourBlocks = std::array<NodeClassBlock, lanes>;

/// The block of the body, and what does not depend on the wavevector.
struct Body {
  Grid grid;
  MirroredQ2 layers;
  double spring; ///< on the uniform mode [N/m]

  Body(const Grid& of_nodes, const LayeredBlock& block)
      : grid(of_nodes),
        layers(of_nodes, block),
        spring(block.layers.back().shear_modulus * of_nodes.spacing_x()) {}
};

/// Computes the blocks of four cell wavevectors.
FourBlocks four_blocks(const Body& body, const std::array<int, lanes>& modes_x,
                       const std::array<int, lanes>& modes_y) {
  const Grid& grid = body.grid;
  SimdBatch theta_x{}, theta_y{}, on_uniform_mode{};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    theta_x[lane] = 2.0 * std::numbers::pi * modes_x[lane] / grid.points_x;
    theta_y[lane] = 2.0 * std::numbers::pi * modes_y[lane] / grid.points_y;
    if (modes_x[lane] == 0 && modes_y[lane] == 0)
      on_uniform_mode[lane] = body.spring;
  }
  std::array<SimdBatch, node_classes * node_classes> packs;
  body.layers.face_compliance(theta_x, theta_y, on_uniform_mode, packs.data());
  FourBlocks blocks;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t i = 0; i < packs.size(); ++i)
      blocks[lane][i] = grid.cell_area() * packs[i][lane];
  return blocks;
}

/// Four neighbouring blocks in jy up to the last one. On a square grid those
/// with jy > jx are mirror images, as in condensed_compliance_q2().
FourBlocks along_jy(const Body& body, int mode_x, int first, int last) {
  std::array<int, lanes> modes_x{}, modes_y{};
  std::array<bool, lanes> is_mirrored{};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int mode_y = std::min(first + static_cast<int>(lane), last);
    is_mirrored[lane] = body.grid.is_square() && mode_y > mode_x;
    modes_x[lane] = is_mirrored[lane] ? mode_y : mode_x;
    modes_y[lane] = is_mirrored[lane] ? mode_x : mode_y;
  }
  FourBlocks blocks = four_blocks(body, modes_x, modes_y);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    if (is_mirrored[lane])
      blocks[lane] = mirrored(blocks[lane]);
  return blocks;
}

} // namespace

Q2Column condensed_column_q2(const Grid& grid, const LayeredBlock& block) {
  require_cells(grid, 2);
  require_block(block);
  return [body = std::make_shared<const Body>(grid, block)](
             int mode_x, std::span<NodeClassBlock> of_jy) {
    const int n = static_cast<int>(of_jy.size());
    constexpr int step = static_cast<int>(lanes);
    for (int first = 0; first < n; first += step) {
      const FourBlocks blocks = along_jy(*body, mode_x, first, n - 1);
      for (int mode_y = first; mode_y < std::min(n, first + step); ++mode_y)
        of_jy[static_cast<std::size_t>(mode_y)] =
            blocks[static_cast<std::size_t>(mode_y - first)];
    }
  };
}

Q2Compliance condensed_compliance_q2(const Grid& grid,
                                     const LayeredBlock& block, int threads) {
  const Q2Column column = condensed_column_q2(grid, block);
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
  parallel_rows(columns, threads, [&](int mode_x) {
    const int n = is_square ? mode_x + 1 : compliance.rows();
    std::vector<NodeClassBlock> of_jy(static_cast<std::size_t>(n));
    column(mode_x, of_jy);
    for (int mode_y = 0; mode_y < n; ++mode_y) {
      at(mode_x, mode_y) = of_jy[static_cast<std::size_t>(mode_y)];
      if (is_square && mode_x != mode_y)
        at(mode_y, mode_x) = mirrored(at(mode_x, mode_y));
    }
  });
  return compliance;
}

} // namespace asperity::fem
