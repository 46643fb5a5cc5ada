#pragma once

// From what a case says of its whole block to the problem that is solved: which
// mesh, made of what, held how.

#include "cases/types/case.hpp"
#include "fem/block/block_problem.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::fem {

/// What names one whole block: enough for another process to build the same.
struct FullRequest {
  std::string case_text; ///< Case::text
  std::string case_path; ///< Case::path, where its relative paths start
  std::string method;    ///< name of a method with solver = "full"
  Grid grid;             ///< of the method's surface
  cases::Scales scales;
};

/// The block of a method: graded layers, hanging cubes or gmsh's mesh as the
/// case has it, sound or refused.
/// @param mesh  the mesh, where another process has made it
/// @throws std::domain_error  the mesh cannot be made or is refused, in words;
///                            a parameter is outside its range
/// @throws cases::CaseError   the text or a file it names is no good
BlockProblem problem_of_case(const FullRequest& request,
                             std::optional<meshes::BlockMesh> mesh = {});

/// The layers of cells of a laterally uniform block with [fem]'s growth, a face
/// on each interface of the material's layers.
/// @param own  below these
LayeredBlock layered_block(const cases::FemSettings& settings,
                           const std::vector<cases::MaterialLayer>& layers,
                           const cases::BodyModuli& own, const Grid& grid,
                           const cases::Scales& scales);

} // namespace asperity::fem
