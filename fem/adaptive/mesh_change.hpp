#pragma once

// Change of the mesh of a block: the flags of its cells, and transfer of the
// displacement.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"
#include "fem/refined/mesh_plan.hpp"

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/trilinos_vector.h>

#include <functional>
#include <memory>
#include <vector>

namespace asperity::fem {

/// One change of the mesh of a block of layers of boxes, the same on any number
/// of ranks (mesh_plan.hpp). Every rank knows all cells for that.
///
/// The rules of deal.II would follow cells that a rank does not know, so that
/// the mesh would depend on the ranks. The flags of the plan leave nothing to
/// these rules, because they include cells of other ranks.
class MeshChange {
public:
  using Mesh = dealii::parallel::distributed::Triangulation<3>;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Sets the flags of the mesh. This call is collective, as execute() is.
  /// @param problem  whose box the mesh fills
  /// @param changes  by active cell index; only those of this rank's cells are
  ///                 read
  MeshChange(const BlockProblem& problem, Mesh& mesh,
             const std::vector<CellChange>& changes);

  /// What will change after all rules, on all ranks.
  const ChangedCells& count() const { return plan_.count(); }

  /// Changes the mesh and returns the displacement on the new one, over the
  /// unknowns that BlockSpace of `problem` will have.
  /// @param displacement   u at all unknowns of the old mesh, constrained ones
  ///                       included [m]; it is interpolated on refined cells
  ///                       and kept at the remaining nodes of coarsened ones
  /// @param before_change  destroys what depends on the old mesh
  Vector execute(const Vector& displacement,
                 const std::function<void()>& before_change);

private:
  const BlockProblem& problem_;
  Mesh& mesh_;
  MeshPlan plan_;
};

} // namespace asperity::fem
