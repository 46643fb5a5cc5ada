#pragma once

// Converts the description of a full 3-D block to the problem that is solved:
// its mesh, its materials and its boundary conditions.

#include "fem/block/block_problem.hpp"
#include "fem/linear/solver_choice.hpp"
#include "mechanics/fem_settings.hpp"
#include "mechanics/material.hpp"
#include "mechanics/mesh_spec.hpp"
#include "mechanics/quantity.hpp"

#include <optional>
#include <vector>

namespace asperity::fem {

/// Describes one full 3-D block.
struct FullRequest {
  Grid grid; ///< of the surface of the method
  mechanics::BlockSettings block;
  mechanics::FullBlockSettings full;
  mechanics::MaterialSpec material; ///< with poisson_ratio
  mechanics::MeshSpec mesh;
  mechanics::Scales scales;
  /// The mesh of the file that `mesh` names, with meshes::fit_sides; otherwise
  /// empty, and on other ranks than rank 0.
  std::optional<meshes::BlockMesh> file_mesh = {};
};

/// The moduli of the meshed body: the first of two bodies, or the single one
/// that represents both.
inline mechanics::BodyModuli own_moduli(const mechanics::MaterialSpec& material,
                                        int bodies) {
  return bodies == 2 ? material.first_body()
                     : mechanics::BodyModuli{material.block_youngs_modulus(),
                                             *material.poisson_ratio};
}

/// Builds the problem with the mesh that is requested: graded layers, cubes
/// with hanging nodes, the coarsest cells of an adaptive mesh or a gmsh mesh.
/// An invalid mesh is refused.
/// @param mesh  the mesh, if another process has generated it
/// @throws std::domain_error  the mesh cannot be generated or is refused, with
///                            the reason; or a parameter is outside its range
/// @throws input::InputError  a file that the request names is invalid
BlockProblem problem_of(const FullRequest& request,
                        std::optional<meshes::BlockMesh> mesh = {});

/// The same on all ranks of mpirun, of which rank 0 makes the mesh. Collective.
BlockProblem problem_on_ranks(const FullRequest& request);

/// What solver_of() will be asked with, before there is a mesh. The unknowns
/// are counted as the mesh generators count them (meshes/): exactly but for
/// tetrahedra, meshes of a file, those that follow the contact, and
/// counter-bodies whose cells have the size of the block's. Builds nothing, and
/// needs neither deal.II nor gmsh.
/// @param ranks  that share the block
/// @throws std::domain_error  the mesh itself would be refused
BlockTraits expected_block(const FullRequest& request, int ranks);

/// Cell layers of a laterally uniform block with the grading ratio of the
/// settings and a cell face on each interface between the material's layers.
/// @param own  moduli of the material below these layers
LayeredBlock layered_block(const mechanics::BlockSettings& settings,
                           const std::vector<mechanics::MaterialLayer>& layers,
                           const mechanics::BodyModuli& own, const Grid& grid,
                           const mechanics::Scales& scales);

} // namespace asperity::fem
