#include "fem/parallel/mpi_session.hpp"

#include "base/kept_signals.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector_memory.h>

#include <stdexcept>

namespace asperity::fem {

void start_mpi() {
  int is_running = 0;
  MPI_Initialized(&is_running);
  if (!is_running) {
    static int argc = 1;
    static char name[] = "asperity";
    static char* arguments[] = {name, nullptr};
    static char** argv = arguments;
    // The session releases the memory pool of CG's vectors when it ends, so the
    // pool must be constructed before the session.
    const dealii::GrowingVectorMemory<dealii::TrilinosWrappers::MPI::Vector>
        pool;
    // PETSc, which the session initialises, gives SIGHUP and SIGTERM their
    // default again.
    const KeptSignals kept;
    // The session requests MPI_THREAD_SERIALIZED.
    static const dealii::Utilities::MPI::MPI_InitFinalize session(argc, argv,
                                                                  1);
  }
  int level = MPI_THREAD_SINGLE;
  MPI_Query_thread(&level);
  if (level < MPI_THREAD_SERIALIZED)
    throw std::runtime_error(
        "MPI must be started with at least MPI_THREAD_SERIALIZED: the full 3-D "
        "block may be solved by a thread other than the first");
}

} // namespace asperity::fem
