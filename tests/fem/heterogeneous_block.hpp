#pragma once

// A block with different cells: deal.II's cell matrices times one factor per
// cell, assembled in the numbering of the lattice solver, which is its
// preconditioner.

#include "fem/waves/cell_stiffness.hpp"
#include "fem/waves/lattice_solver.hpp"
#include "tests/fem/blocks.hpp"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <vector>

namespace asperity::fem {

/// The cells of a clamped block in turn: calls do_cell(layer, unknowns), with
/// the unknowns by row of the layer's cell matrix.
template <class DoCell>
void each_cell(const NodeLattice& lattice, std::size_t layers,
               const DoCell& do_cell) {
  const int degree = lattice.degree;
  const Grid& grid = lattice.grid;
  std::vector<unsigned int> unknowns;
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (int cell_y = 0; cell_y < grid.points_y; cell_y += degree)
      for (int cell_x = 0; cell_x < grid.points_x; cell_x += degree) {
        unknowns.clear();
        for (int k = 0; k <= degree; ++k)
          for (int b = 0; b <= degree; ++b)
            for (int a = 0; a <= degree; ++a)
              for (std::size_t c = 0; c < 3; ++c)
                unknowns.push_back(static_cast<unsigned int>(
                    lattice.index(layer * static_cast<std::size_t>(degree) +
                                      static_cast<std::size_t>(k),
                                  c,
                                  grid.index((cell_x + a) % grid.points_x,
                                             (cell_y + b) % grid.points_y))));
        do_cell(layer, unknowns);
      }
}

/// Stiffness plus springs; the clamped far boundary has unit rows.
class HeterogeneousBlock {
public:
  /// @param spread  cell moduli lie evenly in 1 -+ spread times their layer's
  /// @param springs of the nodes of the contact surface [N/m], or empty
  HeterogeneousBlock(const Grid& grid, int degree, const LayeredBlock& block,
                     double spread, unsigned int seed,
                     const std::vector<double>& springs)
      : lattice_{grid, degree,
                 block.layers.size() * static_cast<std::size_t>(degree) + 1} {
    const auto size = static_cast<unsigned int>(lattice_.size());
    const std::size_t first_held = lattice_.index(lattice_.planes - 1, 0, 0);
    const unsigned int most = degree == 1 ? 81 : 375;
    pattern_.reinit(size, size, most);
    each_cell(lattice_, block.layers.size(),
              [&](std::size_t, const auto& rows) {
                for (const unsigned int row : rows)
                  for (const unsigned int column : rows)
                    if (row < first_held && column < first_held)
                      pattern_.add(row, column);
              });
    pattern_.compress();
    matrix_.reinit(pattern_);
    std::vector<CellStiffness> cells;
    for (const ElasticLayer& layer : block.layers)
      cells.push_back(cell_stiffness(degree, degree * grid.spacing_x(),
                                     degree * grid.spacing_y(), layer));
    const std::vector<double> chance = random_field(
        grid.size() / static_cast<std::size_t>(degree * degree) * cells.size(),
        seed);
    std::size_t cell = 0;
    each_cell(lattice_, cells.size(), [&](std::size_t layer, const auto& rows) {
      const double factor = 1.0 + spread * (2.0 * chance[cell++] - 1.0);
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = 0; j < rows.size(); ++j)
          if (rows[i] < first_held && rows[j] < first_held)
            matrix_.add(rows[i], rows[j], factor * cells[layer].at(i, j));
    });
    for (auto row = static_cast<unsigned int>(first_held); row < size; ++row)
      matrix_.set(row, row, matrix_.diag_element(0));
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const auto row = static_cast<unsigned int>(lattice_.index(0, 2, i));
      matrix_.add(row, row, springs[i]);
    }
  }

  const NodeLattice& lattice() const { return lattice_; }

  const dealii::SparseMatrix<double>& matrix() const { return matrix_; }

  /// Independent loads on all nodes except the clamped ones.
  dealii::Vector<double> loads(unsigned int seed) const {
    const std::vector<double> chance = random_field(lattice_.size(), seed);
    dealii::Vector<double> force(static_cast<unsigned int>(lattice_.size()));
    for (unsigned int i = 0; i < lattice_.index(lattice_.planes - 1, 0, 0); ++i)
      force(i) = chance[i] - 0.5;
    return force;
  }

private:
  NodeLattice lattice_;
  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
};

/// The lattice solver as a preconditioner of deal.II's solvers.
class LatticePreconditioner {
public:
  LatticePreconditioner(LatticeSolver& solver, double tolerance)
      : solver_(solver), tolerance_(tolerance) {}

  void vmult(dealii::Vector<double>& to,
             const dealii::Vector<double>& from) const {
    inner_iterations_ +=
        solver_
            .solve_with_springs({from.begin(), from.size()},
                                {to.begin(), to.size()}, tolerance_)
            .iterations;
  }

  int inner_iterations() const { return inner_iterations_; }

private:
  LatticeSolver& solver_;
  double tolerance_;
  mutable int inner_iterations_ = 0;
};

/// Contact of the highest parts of a surface of some waves.
inline std::vector<double>
springs_under_peaks(const Grid& grid, double fraction, double stiffness) {
  const std::vector<double> phases = random_field(49, 21);
  std::vector<double> heights(grid.size(), 0.0);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      for (int j = 1; j < 49; ++j)
        heights[grid.index(ix, iy)] +=
            std::cos(6.283185307179586 *
                     ((j % 7) * static_cast<double>(ix) / grid.points_x +
                      (j / 7 - 3) * static_cast<double>(iy) / grid.points_y +
                      phases[static_cast<std::size_t>(j)])) /
            (1.0 + j % 7 + std::abs(j / 7 - 3));
  std::vector<double> sorted = heights;
  std::sort(sorted.begin(), sorted.end());
  const double level = sorted[static_cast<std::size_t>(
      (1.0 - fraction) * static_cast<double>(grid.size()))];
  std::vector<double> springs(grid.size(), 0.0);
  for (std::size_t i = 0; i < springs.size(); ++i)
    if (heights[i] >= level)
      springs[i] = stiffness;
  return springs;
}

} // namespace asperity::fem
