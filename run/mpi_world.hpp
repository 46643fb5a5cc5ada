#pragma once

// Detects whether the program was started by mpirun and manages the worker
// ranks.

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// Returns false on rank 0 of several MPI processes, which then runs the
/// program. On the other ranks it returns true after the program has ended;
/// until then they take part in the runs of cases whose methods all ranks share
/// (run_case.hpp) and in run_on_ranks(). In a single process it returns false
/// without initialising MPI.
bool has_followed_rank_0();

/// Ends all processes of mpirun, if there are several, without the last work of
/// libraries: after a file that could not be written, HDF5 crashes when MPI is
/// finalised.
void end_at_once_of_several(int exit_code);

/// Returns the number of MPI processes; 1 without initialising MPI in a single
/// process.
int n_mpi_ranks();

/// Returns the number of MPI processes on this machine, as mpirun tells it,
/// otherwise n_mpi_ranks().
int n_ranks_on_machine();

/// One command of this program for each rank; with fewer commands than ranks,
/// the last ranks have none.
struct RankedRun {
  std::vector<std::string> words;          ///< those that all ranks share
  std::vector<std::string> last_words;     ///< one more for each rank
  std::vector<std::filesystem::path> logs; ///< receives the output of each
};

/// To be called on rank 0. Each rank runs its command as a child process, which
/// takes no part in MPI; returns when all of them have ended, however they do.
void run_on_ranks(const RankedRun& run);

} // namespace asperity::run
