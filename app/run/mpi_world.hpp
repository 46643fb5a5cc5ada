#pragma once

// Detects whether the program was started by mpirun and manages the worker
// ranks.

namespace asperity::app {

/// Returns false on rank 0 of several MPI processes, which then runs the
/// program. On the other ranks it returns true after the program has ended;
/// until then they share the work of the full blocks. In a single process it
/// returns false without initialising MPI.
bool has_followed_rank_0();

} // namespace asperity::app
