#pragma once

// MPI for libraries that will not work without it.

namespace asperity::fem {

/// Initialises MPI once, unless the host program has done so: all processes of
/// an mpirun together, one process alone without. Calls may come from any one
/// thread at a time (MPI_THREAD_SERIALIZED). What was started here is finalised
/// when the program ends.
/// @throws std::runtime_error  the host program started MPI for less
void start_mpi();

} // namespace asperity::fem
