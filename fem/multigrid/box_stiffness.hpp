#pragma once

// Stiffness matrices of a box-shaped cell and the small blocks into which the
// reflections of the box split them.

#include "fem/multigrid/box_grid.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace asperity::fem {

/// The places of a cell's unknowns after the reflections. Along one axis the
/// values u_0, u_1 (degree 1) are replaced by u_0 + u_1 and u_1 - u_0; the
/// values u_0, u_1, u_2 (degree 2) by u_0 + u_2, u_1 and u_2 - u_0. All but the
/// last are even under the reflection of the axis. A displacement component
/// changes its sign under the reflection of its own axis. The stiffness of a
/// homogeneous isotropic box couples only unknowns of the same three parities,
/// hence eight blocks: 3 x 3 for degree 1; of 6, 9 and 12 rows for degree 2.
template <int degree>
struct ParitySlots {
  static constexpr int nodes = degree + 1;
  static constexpr int most = degree == 1 ? 3 : 12; ///< rows of a block
  static constexpr int size = 3 * nodes * nodes * nodes;

  std::array<int, 8> count{};                 ///< rows of each block
  std::array<int, 8> start{};                 ///< of the block's entries
  std::array<std::array<int, most>, 8> row{}; ///< ((c n + k) n + j) n + i
  int entries = 0;                            ///< of all blocks

  constexpr ParitySlots() {
    for (int block = 0; block < 8; ++block) {
      for (int c = 0; c < 3; ++c)
        add_component(block, c);
      start[static_cast<std::size_t>(block)] = entries;
      entries += count[static_cast<std::size_t>(block)] *
                 count[static_cast<std::size_t>(block)];
    }
  }

private:
  constexpr void add_component(int block, int c) {
    const int parity = block ^ (1 << c);
    for (int k = 0; k < nodes; ++k)
      for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) {
          const int own = (i == degree ? 1 : 0) + (j == degree ? 2 : 0) +
                          (k == degree ? 4 : 0);
          if (own == parity) {
            const auto b = static_cast<std::size_t>(block);
            row[b][static_cast<std::size_t>(count[b]++)] =
                ((c * nodes + k) * nodes + j) * nodes + i;
          }
        }
  }
};

/// The stiffness matrix [N/m] of one cell with FE_Q(degree), integrated
/// exactly:
///
///     K_(a,i),(b,j) = int lambda d_i phi_a d_j phi_b
///        + mu (delta_ij grad phi_a . grad phi_b + d_j phi_a d_i phi_b) dV
///
/// Rows and columns are numbered ((c n + k) n + j) n + i for component c of the
/// node (i, j, k), n = degree + 1; row-major.
/// @param size  side lengths [m] > 0
std::vector<double> box_stiffness(int degree, const std::array<double, 3>& size,
                                  const CellModuli& moduli);

/// The blocks of a cell matrix K = T^T B T one after the other, each row-major,
/// where T replaces the values of a node by those of ParitySlots.
std::vector<double> parity_blocks(int degree,
                                  const std::vector<double>& stiffness);

/// The largest eigenvalue of diag(K)^-1 K of one cell. The largest over all
/// cells bounds that of the assembled matrix.
double jacobi_bound(int degree, const std::vector<double>& stiffness);

} // namespace asperity::fem
