#pragma once

// Selects the settings by which a benchmark compares full 3-D blocks: the same
// problem on uniform layers and by the condensed solver, and the mesh of the
// case on other numbers of points. It is internal to the plan.

#include "input/types/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::bench {

/// A method that a benchmark adds to those of the case.
struct AddedMethod {
  std::string name; ///< "fem.uniform"
  /// The overrides that define it relative to the method of the case.
  std::vector<std::string> overrides;
};

/// True for a full block on a [mesh] that is not made of uniform layers.
bool is_block_on_mesh(const cases::Case& contact_case,
                      const cases::MethodSpec& method);

/// Returns the methods that solve the same problem as a full block on the mesh
/// of the case: on uniform layers in full, and condensed. There are none for
/// variants, for methods without is_block_on_mesh(), and if the block is not
/// laterally uniform and periodic with node-wise contact of one body.
std::vector<AddedMethod> same_block_methods(const cases::Case& contact_case,
                                            const cases::MethodSpec& method);

/// Returns the overrides that refine or coarsen the mesh of the case as a whole
/// with the points of the surface: the coarsest mesh of an adaptive one stays,
/// and all cell sizes of a gmsh mesh are proportional to the node spacing. A
/// mesh from a file stays.
/// @param points  points per side, in place of those of the case
/// @return        nothing if an adaptive mesh cannot follow: the points are not
///                the case's times a power of two, or no halving would be left
std::optional<std::vector<std::string>>
mesh_overrides(const cases::Case& contact_case, int points);

/// Returns whether a method accepts so many points per side with the other
/// settings of the case: an adaptive mesh needs a multiple of p 2^halvings and
/// at least twice as many, where p is the order of the elements.
bool permits_points(const cases::Case& contact_case,
                    const cases::MethodSpec& method, int points);

} // namespace asperity::bench
