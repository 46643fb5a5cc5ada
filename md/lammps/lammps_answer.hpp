#pragma once

// Reads the output of LAMMPS after a load step and converts it to SI units.

#include "md/lammps/lammps_block.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::md {

struct LammpsAnswer {
  BlockVectors positions;   ///< [m]
  BlockVectors forces;      ///< residual force on every atom [N]
  BlockVectors contact;     ///< force of the substrate on the lowest layer [N]
  double bond_energy = 0.0; ///< [J]
  double pair_energy = 0.0; ///< [J]
};

/// Progress of a minimisation, from the LAMMPS log.
struct LammpsProgress {
  int iterations = 0;      ///< since LAMMPS started
  double energy = 0.0;     ///< [J]
  double force_norm = 0.0; ///< over all components [N]
  double push = 0.0;       ///< normal force of the substrate on the block [N]
};

/// Returns the contents of a file; empty if it does not exist.
std::string file_text(const std::filesystem::path& path);

/// Reads the results of a load step.
/// @throws std::runtime_error  a file is missing, truncated or not as expected
LammpsAnswer read_answer(const LammpsBlock& block,
                         const std::filesystem::path& folder);

/// Returns the last complete line of numbers in a log that may still be written
/// to, if there is one.
std::optional<LammpsProgress> progress_in(const std::string& log);

/// Returns the number of force evaluations, summed over the minimisations in a
/// log.
int evaluations_in(const std::string& log);

/// Returns the error message of LAMMPS; empty if the log contains none.
std::string error_in(const std::string& log);

} // namespace asperity::md
