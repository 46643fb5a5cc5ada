#pragma once

// What a method needs before it runs: its unknowns, which are counted, and its
// memory, which follows from them and from the fields on its grid.

#include "fem/plugin.hpp"
#include "input/types/case.hpp"

namespace asperity::run {

/// Factor by which a predicted memory may be off in either direction [1].
inline constexpr double memory_factor = 2.0;

struct MethodNeeds {
  double unknowns = 0.0; ///< per load step
  double memory = 0.0;   ///< per running realisation [B]
};

/// What fem/ expects of the block of a method with solver = "full", before it
/// is meshed.
/// @param grid   that the method presses
/// @param ranks  number of processes that share the block
/// @throws std::domain_error, input::InputError  the mesh would be refused
fem::BlockTraits block_of(const cases::Case& contact_case,
                          const cases::MethodSpec& method, const Grid& grid,
                          int ranks);

/// Predicts what a method needs on a surface with this grid;
/// docs/numerics/skip.md compares the memory with that of runs.
/// @param ranks  number of processes, which chooses the linear solver of a full
///               block
MethodNeeds needs_of(const cases::Case& contact_case,
                     const cases::MethodSpec& method, const Grid& grid,
                     int ranks = 1);

/// Predicts the memory of each of several ranks that share the rows of a
/// method, without that of the program [B].
double memory_of_rank(const cases::MethodSpec& method, const Grid& grid,
                      int ranks);

/// Returns the memory of the program alone, with the finite-element library
/// loaded, or with a full block [B].
double base_memory(bool uses_fem, bool has_full_block = false);

/// Predicts the compressed size of a map of pressure and gap in a result file
/// [B].
double map_bytes(const Grid& grid);

} // namespace asperity::run
