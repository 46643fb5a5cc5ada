#pragma once

// Assembly of cell matrices into a distributed matrix of the block, and the
// matrix of first-order cells that replaces the one of second-order cells in a
// preconditioner.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/cell_matrices.hpp"

#include <deal.II/base/table.h>
#include <deal.II/lac/trilinos_precondition.h>

#include <span>

namespace asperity::fem {

/// Sums one matrix per cell under the block's constraints. The sparsity pattern
/// reserves entries for springs at the contact points. This call is collective.
/// @param couples  which pairs of unknowns of a cell share an entry; empty for
///                 all
void assemble(const BlockSystem& system, CellMatrices& matrices,
              const dealii::Table<2, bool>& couples,
              dealii::TrilinosWrappers::SparseMatrix& matrix);

/// Sets the rows and columns of unknowns of this rank to zero except for their
/// diagonal. This call is collective.
void hold(dealii::TrilinosWrappers::SparseMatrix& matrix,
          const BlockSpace& space,
          std::span<const dealii::types::global_dof_index> unknowns);

/// Memory of the matrices of a hierarchy on this rank, except for that of the
/// matrix it was set up for [bytes]; the hierarchy's own function does not
/// count them.
std::size_t
hierarchy_bytes(const dealii::TrilinosWrappers::PreconditionAMG& multigrid);

/// Whether the block consists of second-order hexahedra.
bool has_low_order(const BlockSpace& space);

/// Assembles the stiffness K_1 of first-order cells, eight in each second-order
/// hexahedron, on its 27 nodes and under the same constraints. On each cell,
/// and therefore on the full block for any cell size,
///
///     c u.K_1 u <= u.K u <= C u.K_1 u                               (F.4)
///
/// with c and C of order one. K_1 has two fifths of the entries of K and
/// replaces K in a preconditioner. This call is collective.
/// @see  S. A. Orszag, J. Comput. Phys. 37, 70 (1980)
void assemble_low_order(const BlockSystem& system,
                        dealii::TrilinosWrappers::SparseMatrix& matrix);

} // namespace asperity::fem
