#pragma once

// Change of the mesh of a block: equal flags on periodic sides, and transfer of
// the displacement.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/trilinos_vector.h>

#include <functional>
#include <memory>
#include <vector>

namespace asperity::fem {

/// What is to become of a cell.
enum class CellChange : char { none, refine, coarsen };

/// The number of cells that a mesh change refines and coarsens.
struct ChangedCells {
  std::size_t refined = 0;
  std::size_t coarsened = 0; ///< cells that vanish, eight per new one
};

/// One change of the mesh of a box of hexahedra on one rank.
///
/// Cells that differ by one level across a face, an edge or a vertex at most
/// remain so: cells are refined for that, and others not coarsened. With
/// periodic sides both cells at a pair of faces change alike, so that opposite
/// sides match.
class MeshChange {
public:
  using Mesh = dealii::parallel::distributed::Triangulation<3>;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Sets the flags of the mesh.
  /// @param problem  whose box the mesh fills
  /// @param changes  by active cell index
  MeshChange(const BlockProblem& problem, Mesh& mesh,
             const std::vector<CellChange>& changes);

  /// What will change after all rules.
  ChangedCells count() const;

  /// Changes the mesh and returns the displacement on the new one, over the
  /// unknowns that BlockSpace of `problem` will have.
  /// @param displacement   u at all unknowns of the old mesh, constrained ones
  ///                       included [m]; it is interpolated on refined cells
  ///                       and kept at the remaining nodes of coarsened ones
  /// @param before_change  destroys what depends on the old mesh
  Vector execute(const Vector& displacement,
                 const std::function<void()>& before_change);

private:
  using Cell = Mesh::active_cell_iterator;

  void find_pairs();
  bool make_pairs_equal();

  const BlockProblem& problem_;
  Mesh& mesh_;
  std::vector<std::pair<Cell, Cell>> pairs_; ///< at periodic sides
};

} // namespace asperity::fem
