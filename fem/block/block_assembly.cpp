#include "fem/block/block_assembly.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q_iso_q1.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

using dealii::types::global_dof_index;

/// The unknowns that this rank may write to: those of its cells, the master
/// unknowns of their constraints and those that its contact points need.
dealii::IndexSet writable(const BlockSystem& system) {
  const BlockSpace& space = system.space();
  std::vector<global_dof_index> roots;
  for (const auto& line : space.constraints().get_lines())
    for (const auto& entry : line.entries)
      if (!space.relevant().is_element(entry.first))
        roots.push_back(entry.first);
  std::sort(roots.begin(), roots.end());
  dealii::IndexSet set = space.relevant();
  set.add_indices(roots.begin(), roots.end());
  set.add_indices(system.contact().needed());
  set.compress();
  return set;
}

/// Table of whether the nodes of two unknowns are vertices of a common cell
/// among the eight small cells.
dealii::Table<2, bool> neighbours(const dealii::FiniteElement<3>& element) {
  const auto& places = element.get_unit_support_points();
  dealii::Table<2, bool> couples(places.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < places.size(); ++j) {
      double farthest = 0.0;
      for (unsigned int axis = 0; axis < 3; ++axis)
        farthest =
            std::max(farthest, std::abs(places[i][axis] - places[j][axis]));
      couples(i, j) = farthest < 0.75;
    }
  return couples;
}

} // namespace

void assemble(const BlockSystem& system, CellMatrices& matrices,
              const dealii::Table<2, bool>& couples,
              dealii::TrilinosWrappers::SparseMatrix& matrix) {
  const BlockSpace& space = system.space();
  const auto for_own_cells = [&](const auto& take) {
    std::vector<global_dof_index> unknowns(space.element().n_dofs_per_cell());
    for (const auto& cell : space.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned()) {
        cell->get_dof_indices(unknowns);
        take(cell, unknowns);
      }
  };
  dealii::TrilinosWrappers::SparsityPattern pattern(
      space.owned(), space.owned(), writable(system), MPI_COMM_WORLD);
  for_own_cells([&](const auto&, const auto& unknowns) {
    space.constraints().add_entries_local_to_global(unknowns, pattern, false,
                                                    couples);
  });
  system.contact().reserve(pattern);
  pattern.compress();
  matrix.reinit(pattern);
  for_own_cells([&](const auto& cell, const auto& unknowns) {
    space.constraints().distribute_local_to_global(
        matrices.of(cell, system.moduli_of(cell)), unknowns, matrix);
  });
  matrix.compress(dealii::VectorOperation::add);
}

bool has_low_order(const BlockSpace& space) {
  return space.element().degree == 2 &&
         space.triangulation().all_reference_cells_are_hyper_cube();
}

void assemble_low_order(const BlockSystem& system,
                        dealii::TrilinosWrappers::SparseMatrix& matrix) {
  const dealii::FESystem<3> element(dealii::FE_Q_iso_Q1<3>(2), 3);
  CellMatrices matrices(
      system.space(), element,
      dealii::QIterated<3>(dealii::QGauss<1>(2), 2)); // exact on box-shaped
                                                      // cells
  assemble(system, matrices, neighbours(element), matrix);
}

} // namespace asperity::fem
