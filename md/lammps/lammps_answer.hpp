#pragma once

// What LAMMPS leaves behind after a load step, read back into SI.

#include "md/lammps/lammps_block.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::md {

struct LammpsAnswer {
  BlockVectors positions;   ///< [m]
  BlockVectors forces;      ///< left over on every atom [N]
  BlockVectors contact;     ///< of the substrate on the lowest layer [N]
  double bond_energy = 0.0; ///< [J]
  double pair_energy = 0.0; ///< [J]
};

/// Where a minimiser is, from LAMMPS' log.
struct LammpsProgress {
  int iterations = 0;      ///< since LAMMPS started
  double energy = 0.0;     ///< [J]
  double force_norm = 0.0; ///< over all components [N]
  double push = 0.0;       ///< normal force of the substrate on the block [N]
};

/// The whole file; empty if there is none.
std::string file_text(const std::filesystem::path& path);

/// @throws std::runtime_error  a file is missing, cut short or not as asked for
LammpsAnswer read_answer(const LammpsBlock& block,
                         const std::filesystem::path& folder);

/// The last line of numbers in a log that may still be written, if any.
std::optional<LammpsProgress> progress_in(const std::string& log);

/// Evaluations of the forces, summed over the minimisations in a log.
int evaluations_in(const std::string& log);

/// LAMMPS' own words on why it ended; empty if the log holds none.
std::string error_in(const std::string& log);

} // namespace asperity::md
