#include "fem/multigrid/box_stiffness.hpp"

#include "base/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

constexpr std::size_t most_nodes = 3; ///< of one axis of a cell

using AxisMatrix = std::array<std::array<double, most_nodes>, most_nodes>;

/// Integrals over one axis of unit length.
struct AxisIntegrals {
  AxisMatrix mass{};   ///< phi_a phi_b
  AxisMatrix mixed{};  ///< phi_a' phi_b
  AxisMatrix slopes{}; ///< phi_a' phi_b'
};

void shape_values(std::size_t nodes, double x,
                  std::array<double, most_nodes>& value,
                  std::array<double, most_nodes>& slope) {
  if (nodes == 2) {
    value = {1.0 - x, x, 0.0};
    slope = {-1.0, 1.0, 0.0};
  } else {
    value = {(1.0 - x) * (1.0 - 2.0 * x), 4.0 * x * (1.0 - x),
             x * (2.0 * x - 1.0)};
    slope = {4.0 * x - 3.0, 4.0 - 8.0 * x, 4.0 * x - 1.0};
  }
}

/// By Gauss' formula with three points, exact for polynomials of degree 5.
AxisIntegrals integrate_axis(std::size_t nodes) {
  AxisIntegrals integrals;
  const std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  for (std::size_t q = 0; q < 3; ++q) {
    const double x =
        0.5 + 0.5 * (static_cast<double>(q) - 1.0) * std::sqrt(0.6);
    std::array<double, most_nodes> value{}, slope{};
    shape_values(nodes, x, value, slope);
    for (std::size_t a = 0; a < nodes; ++a)
      for (std::size_t b = 0; b < nodes; ++b) {
        integrals.mass[a][b] += weights[q] * value[a] * value[b];
        integrals.mixed[a][b] += weights[q] * slope[a] * value[b];
        integrals.slopes[a][b] += weights[q] * slope[a] * slope[b];
      }
  }
  return integrals;
}

/// A node of the cell by its places along the three axes.
using CellNode = std::array<std::size_t, 3>;

/// int d_i phi_a d_j phi_b dV [m].
double product_of_slopes(const AxisIntegrals& integrals,
                         const std::array<double, 3>& size, const CellNode& a,
                         const CellNode& b, std::size_t i, std::size_t j) {
  double product = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t at = a[axis], to = b[axis];
    if (axis == i && axis == j)
      product *= integrals.slopes[at][to] / size[axis];
    else if (axis == i)
      product *= integrals.mixed[at][to];
    else if (axis == j)
      product *= integrals.mixed[to][at];
    else
      product *= integrals.mass[at][to] * size[axis];
  }
  return product;
}

CellNode cell_node(std::size_t nodes, std::size_t number) {
  return {number % nodes, number / nodes % nodes, number / nodes / nodes};
}

/// Replaces the values along one axis, `step` apart, by T or by D^-1 T, where
/// T T^T = D.
void reflect(std::size_t nodes, std::size_t step, double share, double* v) {
  double& first = v[0];
  double& last = v[(nodes - 1) * step];
  const double sum = first + last, difference = last - first;
  first = share * sum;
  last = share * difference;
}

/// D^-1 T on all rows (stride 1 within a column) of a matrix of `size` columns.
void reflect_columns(std::size_t nodes, std::size_t size,
                     std::vector<double>& matrix, bool is_transposed) {
  const std::size_t along = is_transposed ? 1 : size;
  const std::size_t across = is_transposed ? size : 1;
  for (std::size_t column = 0; column < size; ++column)
    for (std::size_t axis = 0, step = 1; axis < 3; ++axis, step *= nodes)
      for (std::size_t row = 0; row < size; ++row)
        if (row / step % nodes == 0)
          reflect(nodes, step * along, 0.5,
                  &matrix[column * across + row * along]);
}

template <int degree>
std::vector<double> blocks_of(std::vector<double> matrix) {
  constexpr ParitySlots<degree> slots;
  constexpr std::size_t size = slots.size;
  reflect_columns(degree + 1, size, matrix, false);
  reflect_columns(degree + 1, size, matrix, true);
  std::vector<double> blocks;
  for (std::size_t block = 0; block < 8; ++block)
    for (int r = 0; r < slots.count[block]; ++r)
      for (int s = 0; s < slots.count[block]; ++s)
        blocks.push_back(
            matrix[static_cast<std::size_t>(
                       slots.row[block][static_cast<std::size_t>(r)]) *
                       size +
                   static_cast<std::size_t>(
                       slots.row[block][static_cast<std::size_t>(s)])]);
  return blocks;
}

template <int degree>
double bound_of(const std::vector<double>& stiffness) {
  constexpr ParitySlots<degree> slots;
  constexpr std::size_t size = slots.size, nodes = slots.nodes;
  const std::vector<double> blocks = parity_blocks(degree, stiffness);
  double largest = 0.0;
  for (std::size_t b = 0; b < 8; ++b) {
    const int n = slots.count[b];
    Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(
        &blocks[static_cast<std::size_t>(slots.start[b])], n, n);
    Eigen::VectorXd scale(n);
    for (int r = 0; r < n; ++r) {
      const auto row =
          static_cast<std::size_t>(slots.row[b][static_cast<std::size_t>(r)]);
      double diagonal =
          stiffness[row * (size + 1)]; // of D^-1 T diag(K) T^T D^-1
      for (std::size_t step = 1; step < nodes * nodes * nodes; step *= nodes)
        diagonal *= row / step % nodes % (nodes - 1) == 0 ? 0.5 : 1.0;
      scale[r] = 1.0 / std::sqrt(diagonal);
    }
    matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
    largest = std::max(largest, symmetric_eigen(matrix).values[n - 1]);
  }
  return largest;
}

} // namespace

std::vector<double> box_stiffness(int degree, const std::array<double, 3>& size,
                                  const CellModuli& moduli) {
  const auto nodes = static_cast<std::size_t>(degree) + 1;
  const std::size_t n_nodes = nodes * nodes * nodes;
  const AxisIntegrals integrals = integrate_axis(nodes);
  std::vector<double> stiffness(9 * n_nodes * n_nodes);
  std::array<std::array<double, 3>, 3> slopes{};
  for (std::size_t a = 0; a < n_nodes; ++a)
    for (std::size_t b = 0; b < n_nodes; ++b) {
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          slopes[i][j] = product_of_slopes(integrals, size, cell_node(nodes, a),
                                           cell_node(nodes, b), i, j);
      const double trace = slopes[0][0] + slopes[1][1] + slopes[2][2];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          stiffness[(i * n_nodes + a) * 3 * n_nodes + j * n_nodes + b] =
              moduli.lame * slopes[i][j] +
              moduli.shear * (slopes[j][i] + (i == j ? trace : 0.0));
    }
  return stiffness;
}

std::vector<double> parity_blocks(int degree,
                                  const std::vector<double>& stiffness) {
  return degree == 1 ? blocks_of<1>(stiffness) : blocks_of<2>(stiffness);
}

double jacobi_bound(int degree, const std::vector<double>& stiffness) {
  return degree == 1 ? bound_of<1>(stiffness) : bound_of<2>(stiffness);
}

} // namespace asperity::fem
