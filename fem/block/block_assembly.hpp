#pragma once

// Cell matrices into a distributed matrix of the block, and the matrix that
// stands for second-order cells in a preconditioner.
// Include from .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/cell_matrices.hpp"

#include <deal.II/base/table.h>

namespace asperity::fem {

/// Sums a matrix a cell under the block's constraints, with room for springs
/// at the points of contact. Collective.
/// @param couples  which unknowns of a cell share an entry; empty for all
void assemble(const BlockSystem& system, CellMatrices& matrices,
              const dealii::Table<2, bool>& couples,
              dealii::TrilinosWrappers::SparseMatrix& matrix);

/// Whether the block is of second-order hexahedra.
bool has_low_order(const BlockSpace& space);

/// The stiffness K_1 of first-order cells, eight in each second-order
/// hexahedron, between its 27 nodes and under the same constraints. On each
/// cell, and so on the whole block at any size of cells,
///
///     c u.K_1 u <= u.K u <= C u.K_1 u                               (F.4)
///
/// with c, C of order one, and K_1 has two fifths of K's entries: what stands
/// for K in a preconditioner. Collective.
/// @see  S. A. Orszag, J. Comput. Phys. 37, 70 (1980)
void assemble_low_order(const BlockSystem& system,
                        dealii::TrilinosWrappers::SparseMatrix& matrix);

} // namespace asperity::fem
