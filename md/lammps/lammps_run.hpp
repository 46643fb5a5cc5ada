#pragma once

// The program lmp as a child process: found, started, watched, ended. Owns
// everything about processes; knows nothing of atoms.

#include <filesystem>
#include <functional>
#include <string>

namespace asperity::md {

struct LammpsProgram {
  std::filesystem::path lmp;
  std::filesystem::path mpirun; ///< empty for one rank
  int ranks = 1;
  std::string version; ///< as lmp says it: "29 Sep 2021 - Update 2"
};

/// The programs a run needs, their version not yet asked for; touches no file.
/// @throws cases::CaseError  one of them is not installed
LammpsProgram require_lammps(int ranks);

/// Looks along PATH.
/// @param folder  for what lmp says of itself
/// @throws cases::CaseError  no lmp there, or one that does not start; no
///                           mpirun for more than one rank
LammpsProgram find_lammps(int ranks, const std::filesystem::path& folder);

struct LammpsRun {
  bool finished = false;
  std::string note; ///< why not: LAMMPS' own line and where its log is, or
                    ///< that it was stopped
};

/// Runs `input` in `folder` and waits for its end; LAMMPS' log goes to `log`
/// and what else it says to `log` + ".out". The child ends with this process,
/// however that ends.
///
/// @param go_on  asked some times a second with the log so far; false stops
///               the child
LammpsRun run_lammps(const LammpsProgram& program,
                     const std::filesystem::path& folder,
                     const std::string& input, const std::string& log,
                     const std::function<bool(const std::string&)>& go_on = {});

} // namespace asperity::md
