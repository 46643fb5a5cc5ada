#pragma once

// Converts the description of a full 3-D block in a case to the problem that is
// solved: its mesh, its materials and its boundary conditions.

#include "cases/types/case.hpp"
#include "fem/block/block_problem.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::fem {

/// Identifies one full 3-D block, with enough information for another process
/// to build the same block.
struct FullRequest {
  std::string case_text; ///< Case::text
  std::string case_path; ///< Case::path, the base of relative paths
  std::string method;    ///< name of a method with solver = "full"
  Grid grid;             ///< of the surface of the method
  cases::Scales scales;
};

/// Builds the problem of a method with the mesh that the case requests: graded
/// layers, cubes with hanging nodes or a gmsh mesh. An invalid mesh is refused.
/// @param mesh  the mesh, if another process has generated it
/// @throws std::domain_error  the mesh cannot be generated or is refused, with
///                            the reason; or a parameter is outside its range
/// @throws input::InputError  the text or a file that it names is invalid
BlockProblem problem_of_case(const FullRequest& request,
                             std::optional<meshes::BlockMesh> mesh = {});

/// Cell layers of a laterally uniform block with the grading ratio of [fem] and
/// a cell face on each interface between the material's layers.
/// @param own  moduli of the material below these layers
LayeredBlock layered_block(const cases::FemSettings& settings,
                           const std::vector<cases::MaterialLayer>& layers,
                           const cases::BodyModuli& own, const Grid& grid,
                           const cases::Scales& scales);

} // namespace asperity::fem
