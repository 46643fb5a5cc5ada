#pragma once

// Conversion of plain mesh data to deal.II's distributed triangulation. This
// file defines the boundary id of each face group and the class of
// triangulation for each cell shape.
// Include this header in .cpp files of fem/ only.

#include "meshes/block_mesh.hpp"

#include <deal.II/distributed/tria_base.h>

#include <memory>
#include <optional>

namespace asperity::fem {

/// The boundary id of a face is its FaceGroup as a number.
constexpr dealii::types::boundary_id boundary_of(meshes::FaceGroup group) {
  return static_cast<dealii::types::boundary_id>(group);
}

/// Distributes the mesh over all ranks. Hexahedra use parallel::distributed
/// (p4est, one tree per coarse cell) and are refined by mesh.refine_below. For
/// one rank and a mesh that is not refined, ordering the trees would take
/// several times as long as the mesh, and parallel::shared is used. Tetrahedra
/// use parallel::shared (METIS) because p4est in deal.II 9.4 supports hexahedra
/// only: every rank stores the complete mesh and owns a part of its cells.
///
/// @param has_counter  adds a second body below the contact surface,
///                     disconnected from the first: the cells of negative z
/// @param counter      its mesh; empty for the mirror image (x, y, -z) of the
///                     first body. It is not refined.
/// @param is_fixed     whether the mesh is not going to be refined by others
/// @throws std::domain_error  the mesh has no cells, refine_below is set for
///                            tetrahedra, or the second mesh has other cells
std::unique_ptr<dealii::parallel::TriangulationBase<3>>
make_triangulation(const meshes::BlockMesh& mesh, bool has_counter,
                   const std::optional<meshes::BlockMesh>& counter = {},
                   bool is_fixed = false);

} // namespace asperity::fem
