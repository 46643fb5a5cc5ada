#pragma once

// MPI for libraries that will not work without it.

namespace asperity::fem {

/// Initialises MPI once, on this process alone, unless the host program has
/// done so; what was started here is finalised when the program ends.
void start_mpi();

} // namespace asperity::fem
