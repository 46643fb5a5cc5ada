#pragma once

// Runs the program lmp as a child process. It finds, starts, monitors and ends
// the process, and does not depend on the atomistic model.

#include <filesystem>
#include <functional>
#include <string>

namespace asperity::md {

struct LammpsProgram {
  std::filesystem::path lmp;
  std::filesystem::path mpirun; ///< empty for one rank
  int ranks = 1;
  std::string version; ///< as reported by lmp: "29 Sep 2021 - Update 2"
};

/// Finds the programs that a run needs, without determining their version. It
/// accesses no file of the run.
/// @throws input::InputError  a program is not installed
LammpsProgram require_lammps(int ranks);

/// Searches PATH for the programs and determines the version of lmp.
/// @param folder  working folder for the output of `lmp -h`
/// @throws input::InputError  lmp is not found or does not start, or mpirun is
///                            not found although more than one rank is
///                            requested
LammpsProgram find_lammps(int ranks, const std::filesystem::path& folder);

struct LammpsRun {
  bool finished = false;
  std::string note; ///< why not: the error message of LAMMPS and the location
                    ///< of its log, or that it was stopped
};

/// Runs `input` in `folder` and waits for its end. The log of LAMMPS is written
/// to `log`, and its other output to `log` + ".out". The child process ends
/// with this process, even if this process is killed.
///
/// @param go_on  called several times per second with the log so far; the
///               return value false stops the child process
LammpsRun run_lammps(const LammpsProgram& program,
                     const std::filesystem::path& folder,
                     const std::string& input, const std::string& log,
                     const std::function<bool(const std::string&)>& go_on = {});

} // namespace asperity::md
