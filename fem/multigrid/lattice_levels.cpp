#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

/// A merged cell is at most this much longer than the intended width.
constexpr double most_stretch = 1.5;

/// A lattice with at most this many unknowns is solved exactly.
constexpr std::size_t most_exact_unknowns = 250;

/// Merges neighbouring layers up to a thickness.
std::vector<double> merged_layers(const std::vector<double>& thickness,
                                  double most) {
  std::vector<double> merged;
  for (std::size_t i = 0; i < thickness.size(); ++i) {
    const bool has_next = i + 1 < thickness.size();
    if (has_next && thickness[i] + thickness[i + 1] <= most) {
      merged.push_back(thickness[i] + thickness[i + 1]);
      ++i;
    } else {
      merged.push_back(thickness[i]);
    }
  }
  return merged;
}

int halved(int cells, double width, double most) {
  return cells > 1 && 2.0 * width <= most ? (cells + 1) / 2 : cells;
}

/// Means of the moduli over the fine cells that each coarse cell covers.
void average_moduli(const BoxLattice& fine, BoxLattice& coarse) {
  const auto from = axes_of(fine);
  const auto to = axes_of(coarse);
  const SparseRows z = coverage(to[2], from[2]);
  const SparseRows y = coverage(to[1], from[1]);
  const SparseRows x = coverage(to[0], from[0]);
  const auto add = [](CellModuli& sum, double weight, const CellModuli& own) {
    sum.lame += weight * own.lame;
    sum.shear += weight * own.shear;
  };
  coarse.moduli.clear();
  for (std::size_t k = 0; k < z.rows(); ++k)
    for (std::size_t j = 0; j < (fine.is_layered() ? 1 : y.rows()); ++j)
      for (std::size_t i = 0; i < (fine.is_layered() ? 1 : x.rows()); ++i) {
        CellModuli sum;
        for (std::size_t c = z.start[k]; c < z.start[k + 1]; ++c)
          for (std::size_t b = y.start[j]; b < y.start[j + 1]; ++b)
            for (std::size_t a = x.start[i]; a < x.start[i + 1]; ++a)
              add(sum, x.weight[a] * y.weight[b] * z.weight[c],
                  fine.moduli_of(static_cast<int>(x.column[a]),
                                 static_cast<int>(y.column[b]),
                                 static_cast<int>(z.column[c])));
        coarse.moduli.push_back(sum);
      }
}

LatticeAxis even_axis(const BoxLattice& lattice, int cells, double length) {
  LatticeAxis axis{lattice.degree, lattice.is_periodic, {}};
  for (int i = 0; i <= cells; ++i)
    axis.sides.push_back(length * i / cells);
  return axis;
}

bool can_coarsen(const BoxLattice& lattice) {
  return lattice.cells_x > 1 || lattice.cells_y > 1 || lattice.layers() > 1;
}

} // namespace

std::array<LatticeAxis, 3> axes_of(const BoxLattice& lattice) {
  LatticeAxis z{lattice.degree, false, {0.0}};
  for (const double thickness : lattice.thickness)
    z.sides.push_back(z.sides.back() + thickness);
  return {even_axis(lattice, lattice.cells_x, lattice.length_x),
          even_axis(lattice, lattice.cells_y, lattice.length_y), z};
}

bool has_coarser(const BoxLattice& lattice) {
  const NodeLayout layout(lattice);
  return can_coarsen(lattice) &&
         3 * layout.planes() * static_cast<std::size_t>(layout.nodes_x()) *
                 static_cast<std::size_t>(layout.nodes_y()) >
             most_exact_unknowns;
}

BoxLattice coarser(const BoxLattice& lattice) {
  BoxLattice coarse = lattice;
  double width =
      *std::min_element(lattice.thickness.begin(), lattice.thickness.end());
  if (lattice.cells_x > 1)
    width = std::min(width, lattice.width_x());
  if (lattice.cells_y > 1)
    width = std::min(width, lattice.width_y());
  const auto is_same = [&] {
    return coarse.cells_x == lattice.cells_x &&
           coarse.cells_y == lattice.cells_y &&
           coarse.thickness.size() == lattice.thickness.size();
  };
  for (double most = 2.0 * most_stretch * width;
       is_same() && can_coarsen(lattice); most *= 2.0) {
    coarse.cells_x = halved(lattice.cells_x, lattice.width_x(), most);
    coarse.cells_y = halved(lattice.cells_y, lattice.width_y(), most);
    coarse.thickness = merged_layers(lattice.thickness, most);
  }
  average_moduli(lattice, coarse);
  return coarse;
}

} // namespace asperity::fem
