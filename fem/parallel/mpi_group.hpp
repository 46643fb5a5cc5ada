#pragma once

// The ranks of an mpirun as a group that shares the rows of fields.

#include "base/ranks/root_work.hpp"

namespace asperity::fem {

/// All ranks of MPI_COMM_WORLD, on a communicator of their own. The first call
/// is collective. Calls of the group throw std::domain_error for messages of
/// 2^31 bytes or more; errors of MPI itself end all ranks.
ProgramRanks& mpi_group();

} // namespace asperity::fem
