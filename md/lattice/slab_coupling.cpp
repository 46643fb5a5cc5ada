#include "md/lattice/slab_coupling.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::md {
namespace {

constexpr std::size_t cell_unknowns = 24;

bool is_odd(std::size_t axis, std::size_t i, std::size_t j) {
  return (i == axis) != (j == axis);
}

/// A row of a periodic grid with one periodic ghost value at either end, and
/// the sum and the difference of its two neighbouring rows.
struct RowTriple {
  std::vector<double> centre;
  std::vector<double> sum;        ///< row above + row below
  std::vector<double> difference; ///< row above - row below
};

void close_period(std::vector<double>& padded) {
  padded.front() = padded[padded.size() - 2];
  padded.back() = padded[1];
}

void load(const AtomPlane<const double>& plane, std::size_t axis, int iy,
          RowTriple& rows) {
  const auto n = static_cast<std::size_t>(plane.n_x);
  const double* centre = plane.row(axis, iy);
  const double* above = plane.row(axis, iy + 1 == plane.n_y ? 0 : iy + 1);
  const double* below = plane.row(axis, iy == 0 ? plane.n_y - 1 : iy - 1);
  for (std::size_t i = 0; i < n; ++i) {
    rows.centre[i + 1] = centre[i];
    rows.sum[i + 1] = above[i] + below[i];
    rows.difference[i + 1] = above[i] - below[i];
  }
  close_period(rows.centre);
  close_period(rows.sum);
  close_period(rows.difference);
}

/// The same component at the mirror image of the corner along the axis.
std::size_t mirror_unknown(std::size_t unknown, std::size_t axis) {
  return 3 * ((unknown / 3) ^ (std::size_t{1} << axis)) + unknown % 3;
}

/// Rejects a cell that differs from its mirror image in x or y.
void require_mirror_planes(const CellStiffness& cell) {
  const double largest = std::abs(
      *std::max_element(cell.begin(), cell.end(), [](double a, double b) {
        return std::abs(a) < std::abs(b);
      }));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t row = 0; row < cell_unknowns; ++row) {
      for (std::size_t column = 0; column < cell_unknowns; ++column) {
        const double sign = is_odd(axis, row % 3, column % 3) ? -1.0 : 1.0;
        const double difference =
            cell[row * cell_unknowns + column] -
            sign * cell[mirror_unknown(row, axis) * cell_unknowns +
                        mirror_unknown(column, axis)];
        if (!(std::abs(difference) <= 1e-12 * largest))
          refuse_argument("asymmetry of the cell's stiffness", difference,
                          "0: mirror planes across x and y [N/m]");
      }
    }
  }
}

} // namespace

void LayerCoupling::add(const CellStiffness& cell, int to, int from,
                        double factor) {
  for (std::size_t first = 0; first < 4; ++first) {
    for (std::size_t second = 0; second < 4; ++second) {
      const bool is_aside = ((first ^ second) & 1U) != 0;
      const bool is_behind = ((first ^ second) & 2U) != 0;
      const double sign_x = is_aside && (second & 1U) == 0 ? -1.0 : 1.0;
      const double sign_y = is_behind && (second & 2U) == 0 ? -1.0 : 1.0;
      // An offset of length one occurs with both signs but is stored once.
      const double share =
          factor * (is_aside ? 0.5 : 1.0) * (is_behind ? 0.5 : 1.0);
      const std::size_t row = 3 * (first + 4 * static_cast<std::size_t>(to));
      const std::size_t column =
          3 * (second + 4 * static_cast<std::size_t>(from));
      for (std::size_t entry = 0; entry < 9; ++entry) {
        const std::size_t i = entry / 3;
        const std::size_t j = entry % 3;
        const double sign =
            (is_odd(0, i, j) ? sign_x : 1.0) * (is_odd(1, i, j) ? sign_y : 1.0);
        // Odd contributions without an offset cancel between mirrored corners.
        if ((is_odd(0, i, j) && !is_aside) || (is_odd(1, i, j) && !is_behind))
          continue;
        entries_[i][j][is_behind ? 1 : 0][is_aside ? 1 : 0] +=
            sign * share * cell[(row + i) * cell_unknowns + column + j];
      }
    }
  }
}

void LayerCoupling::add_forces(const AtomPlane<const double>& displacements,
                               int iy, const AtomPlane<double>& forces) const {
  const auto n = static_cast<std::size_t>(displacements.n_x);
  RowTriple rows{std::vector<double>(n + 2), std::vector<double>(n + 2),
                 std::vector<double>(n + 2)};
  for (std::size_t j = 0; j < 3; ++j) {
    load(displacements, j, iy, rows);
    const double* const centre = rows.centre.data() + 1;
    const double* const sum = rows.sum.data() + 1;
    const double* const difference = rows.difference.data() + 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Entry& entry = entries_[i][j];
      const double straight = entry[0][0];
      const double aside = entry[0][1];
      const double behind = entry[1][0];
      const double diagonal = entry[1][1];
      double* const out = forces.row(i, iy);
      const bool is_odd_x = is_odd(0, i, j);
      const bool is_odd_y = is_odd(1, i, j);
      const double* const side = is_odd_y ? difference : sum;
      if (is_odd_x && is_odd_y) {
        for (std::size_t k = 0; k < n; ++k)
          out[k] -= diagonal * (side[k + 1] - (side - 1)[k]);
      } else if (is_odd_x) {
        for (std::size_t k = 0; k < n; ++k)
          out[k] -= aside * (centre[k + 1] - (centre - 1)[k]) +
                    diagonal * (side[k + 1] - (side - 1)[k]);
      } else if (is_odd_y) {
        for (std::size_t k = 0; k < n; ++k)
          out[k] -= behind * side[k] + diagonal * (side[k + 1] + (side - 1)[k]);
      } else {
        for (std::size_t k = 0; k < n; ++k)
          out[k] -= straight * centre[k] +
                    aside * (centre[k + 1] + (centre - 1)[k]) +
                    behind * side[k] + diagonal * (side[k + 1] + (side - 1)[k]);
      }
    }
  }
}

std::array<double, 9> LayerCoupling::symbol(double angle_x,
                                            double angle_y) const {
  std::array<double, 9> matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Entry& entry = entries_[i][j];
      const bool odd_x = is_odd(0, i, j);
      const bool odd_y = is_odd(1, i, j);
      const double along_x =
          2.0 * (odd_x ? std::sin(angle_x) : std::cos(angle_x));
      const double along_y =
          2.0 * (odd_y ? std::sin(angle_y) : std::cos(angle_y));
      const double sum = (odd_x || odd_y ? 0.0 : entry[0][0]) +
                         (odd_y ? 0.0 : along_x * entry[0][1]) +
                         (odd_x ? 0.0 : along_y * entry[1][0]) +
                         along_x * along_y * entry[1][1];
      // Each odd direction contributes a factor i, so two give i i = -1. A
      // single i is multiplied by -i (giving 1) if the lateral component is
      // that of the row, or by i (giving -1) if it is that of the column.
      const double turn =
          (odd_x && odd_y) || ((odd_x != odd_y) && i == 2) ? -1.0 : 1.0;
      matrix[3 * i + j] = turn * sum;
    }
  }
  return matrix;
}

SlabCouplings slab_couplings(const CellStiffness& cell, double factor) {
  require_mirror_planes(cell);
  SlabCouplings slab;
  slab.within_lower.add(cell, 0, 0, factor);
  slab.within_upper.add(cell, 1, 1, factor);
  slab.inside.add(cell, 0, 0, factor);
  slab.inside.add(cell, 1, 1, factor);
  slab.to_lower.add(cell, 0, 1, factor);
  slab.to_upper.add(cell, 1, 0, factor);
  return slab;
}

} // namespace asperity::md
