#pragma once

// Initialisation of MPI for the libraries that require it.

namespace asperity::fem {

/// Initialises MPI once, unless the host program has already done so. Under
/// mpirun all processes initialise it together; without mpirun the process runs
/// alone. Calls may come from any thread, one at a time
/// (MPI_THREAD_SERIALIZED). If MPI was initialised here, it is finalised when
/// the program ends. Signals that the program catches or ignores remain so.
/// @throws std::runtime_error  the host program initialised MPI with a lower
///                             thread level
void start_mpi();

} // namespace asperity::fem
