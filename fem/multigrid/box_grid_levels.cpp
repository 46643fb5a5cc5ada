#include "fem/multigrid/box_grid_levels.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

/// A merged cell is at most this much longer than the intended width.
constexpr double most_stretch = 1.5;

/// A grid of boxes with at most this many unknowns is solved exactly.
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
void average_moduli(const BoxGrid& fine, BoxGrid& coarse) {
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

BoxGridAxis even_axis(const BoxGrid& box_grid, int cells, double length) {
  BoxGridAxis axis{box_grid.degree, box_grid.is_periodic, {}};
  for (int i = 0; i <= cells; ++i)
    axis.sides.push_back(length * i / cells);
  return axis;
}

bool can_coarsen(const BoxGrid& box_grid) {
  return box_grid.cells_x > 1 || box_grid.cells_y > 1 || box_grid.layers() > 1;
}

} // namespace

std::array<BoxGridAxis, 3> axes_of(const BoxGrid& box_grid) {
  BoxGridAxis z{box_grid.degree, false, {0.0}};
  for (const double thickness : box_grid.thickness)
    z.sides.push_back(z.sides.back() + thickness);
  return {even_axis(box_grid, box_grid.cells_x, box_grid.length_x),
          even_axis(box_grid, box_grid.cells_y, box_grid.length_y), z};
}

bool has_coarser(const BoxGrid& box_grid) {
  const NodeLayout layout(box_grid);
  return can_coarsen(box_grid) &&
         3 * layout.planes() * static_cast<std::size_t>(layout.nodes_x()) *
                 static_cast<std::size_t>(layout.nodes_y()) >
             most_exact_unknowns;
}

BoxGrid coarser(const BoxGrid& box_grid) {
  BoxGrid coarse = box_grid;
  double width =
      *std::min_element(box_grid.thickness.begin(), box_grid.thickness.end());
  if (box_grid.cells_x > 1)
    width = std::min(width, box_grid.width_x());
  if (box_grid.cells_y > 1)
    width = std::min(width, box_grid.width_y());
  const auto is_same = [&] {
    return coarse.cells_x == box_grid.cells_x &&
           coarse.cells_y == box_grid.cells_y &&
           coarse.thickness.size() == box_grid.thickness.size();
  };
  for (double most = 2.0 * most_stretch * width;
       is_same() && can_coarsen(box_grid); most *= 2.0) {
    coarse.cells_x = halved(box_grid.cells_x, box_grid.width_x(), most);
    coarse.cells_y = halved(box_grid.cells_y, box_grid.width_y(), most);
    coarse.thickness = merged_layers(box_grid.thickness, most);
  }
  average_moduli(box_grid, coarse);
  return coarse;
}

} // namespace asperity::fem
