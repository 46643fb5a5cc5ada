#pragma once

// Whether the program was started by mpirun, and what its processes then do.

namespace asperity::app {

/// Under mpirun with several processes: rank 0 returns false and runs the
/// program; the others return true when it has ended, having shared the work of
/// its whole blocks. Alone: false, and nothing of MPI is touched.
bool has_followed_rank_0();

} // namespace asperity::app
