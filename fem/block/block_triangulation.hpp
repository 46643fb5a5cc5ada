#pragma once

// From plain mesh data to deal.II's distributed triangulation. Owns which
// boundary id a group of faces has and which kind of triangulation carries
// which cells. Include from .cpp files of fem/ only.

#include "meshes/block_mesh.hpp"

#include <deal.II/distributed/tria_base.h>

#include <memory>

namespace asperity::fem {

/// A face's boundary id is its FaceGroup as a number.
constexpr dealii::types::boundary_id boundary_of(meshes::FaceGroup group) {
  return static_cast<dealii::types::boundary_id>(group);
}

/// The mesh over all ranks. Hexahedra: parallel::distributed (p4est, a coarse
/// cell a tree), refined by mesh.refine_below. Tetrahedra: parallel::shared
/// (METIS), because deal.II 9.4's p4est knows hexahedra only: every rank holds
/// the whole mesh and owns a part of its cells.
///
/// @param has_counter  adds the mirror image (x, y, -z) below the contact
///                     face, disconnected: cells of negative z
/// @throws std::domain_error  no cells; refine_below of tetrahedra
std::unique_ptr<dealii::parallel::TriangulationBase<3>>
make_triangulation(const meshes::BlockMesh& mesh, bool has_counter);

} // namespace asperity::fem
