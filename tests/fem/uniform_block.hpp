#pragma once

// deal.II's assembled stiffness of a uniform block in the numbering of the
// lattice solver, with springs and a direct solver: the reference of the
// lattice solver.

#include "fem/waves/lattice_solver.hpp"
#include "tests/fem/plain_block.hpp"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/sparse_direct.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace asperity::fem {

class UniformBlock {
public:
  UniformBlock(const Grid& grid, int degree, const LayeredBlock& block)
      : system_(grid, degree, block),
        lattice_{grid, degree,
                 block.layers.size() * static_cast<std::size_t>(degree) + 1},
        is_free_in_z_(block.far_boundary == mechanics::FarBoundary::pressure) {
    std::vector<double> height{0.0};
    for (const ElasticLayer& layer : block.layers)
      for (int i = 0; i < degree; ++i)
        height.push_back(height.back() + layer.thickness / degree);
    for (unsigned int component = 0; component < 3; ++component)
      find_places(component, height);
  }

  /// (K + springs)^-1 force; an infinite spring constrains its node. With a far
  /// boundary that is free in z, the springs determine its height, for which
  /// the pin carries nothing.
  std::vector<double> solve(const std::vector<double>& force,
                            const std::vector<double>& springs) const {
    dealii::Vector<double> loads(system_.n_unknowns());
    for (const auto& [unknown, place] : places_)
      loads(unknown) = force[place];
    const dealii::Vector<double> pinned = solve_pinned(loads, springs, 0.0);
    double height = 0.0;
    dealii::Vector<double> lowered(loads.size());
    if (is_free_in_z_ && !springs.empty()) {
      dealii::Vector<double> unit(loads.size());
      for (std::size_t i = 0; i < springs.size(); ++i)
        unit(system_.face_unknowns()[i]) = springs[i];
      lowered = solve_pinned(unit, springs, 1.0);
      height = (total_in_z(force) - borne(loads, pinned, springs)) /
               -borne(dealii::Vector<double>(loads.size()), lowered, springs);
    }
    std::vector<double> displacement(lattice_.size(), 0.0);
    for (std::size_t plane = 0; plane < lattice_.planes; ++plane)
      for (std::size_t i = 0; i < lattice_.grid.size(); ++i)
        displacement[lattice_.index(plane, 2, i)] = height;
    for (const auto& [unknown, place] : places_)
      displacement[place] += pinned(unknown) - height * lowered(unknown);
    return displacement;
  }

private:
  // Constrained unknowns (images, clamped, pinned) have only a diagonal entry.
  void find_places(unsigned int component, const std::vector<double>& height) {
    std::map<dealii::types::global_dof_index, dealii::Point<3>> points;
    dealii::ComponentMask mask(3, false);
    mask.set(component, true);
    dealii::DoFTools::map_dofs_to_support_points(
        dealii::MappingQ1<3>(), system_.dof_handler(), points, mask);
    const Grid& grid = lattice_.grid;
    for (const auto& [unknown, point] : points) {
      if (system_.sparsity().row_length(unknown) == 1)
        continue;
      const auto plane = std::min_element(
          height.begin(), height.end(), [&](double a, double b) {
            return std::abs(a - point[2]) < std::abs(b - point[2]);
          });
      const long ix = std::lround(point[0] / grid.spacing_x());
      const long iy = std::lround(point[1] / grid.spacing_y());
      places_[unknown] = lattice_.index(
          static_cast<std::size_t>(plane - height.begin()), component,
          grid.index(static_cast<int>(ix) % grid.points_x,
                     static_cast<int>(iy) % grid.points_y));
    }
  }

  /// Adds springs to the diagonal; the row of a constrained unknown states its
  /// value.
  dealii::Vector<double> solve_pinned(dealii::Vector<double> loads,
                                      const std::vector<double>& springs,
                                      double held_value) const {
    dealii::SparseMatrix<double> matrix(system_.sparsity());
    matrix.copy_from(system_.stiffness());
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const auto unknown = system_.face_unknowns()[i];
      if (std::isfinite(springs[i])) {
        matrix.add(unknown, unknown, springs[i]);
        continue;
      }
      const double scale = matrix.diag_element(unknown);
      for (auto entry = matrix.begin(unknown); entry != matrix.end(unknown);
           ++entry)
        entry->value() = entry->column() == unknown ? scale : 0.0;
      loads(unknown) = scale * held_value;
    }
    dealii::SparseDirectUMFPACK direct;
    direct.initialize(matrix);
    direct.solve(loads);
    return loads;
  }

  /// Sum of the forces of the springs, each being the load of its node minus K
  /// u.
  double borne(const dealii::Vector<double>& loads,
               const dealii::Vector<double>& displacement,
               const std::vector<double>& springs) const {
    dealii::Vector<double> elastic(loads.size());
    system_.stiffness().vmult(elastic, displacement);
    double sum = 0.0;
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const auto unknown = system_.face_unknowns()[i];
      if (springs[i] > 0.0)
        sum += loads(unknown) - elastic(unknown);
    }
    return sum;
  }

  double total_in_z(const std::vector<double>& force) const {
    double sum = 0.0;
    for (std::size_t plane = 0; plane < lattice_.planes; ++plane)
      for (std::size_t i = 0; i < lattice_.grid.size(); ++i)
        sum += force[lattice_.index(plane, 2, i)];
    return sum;
  }

  PlainBlock system_;
  NodeLattice lattice_;
  bool is_free_in_z_;
  std::map<dealii::types::global_dof_index, std::size_t> places_;
};

} // namespace asperity::fem
