#include "fem/mpi_session.hpp"

#include <deal.II/base/mpi.h>

namespace asperity::fem {

void start_mpi() {
  int is_running = 0;
  MPI_Initialized(&is_running);
  if (is_running)
    return;
  static int argc = 1;
  static char name[] = "asperity";
  static char* arguments[] = {name, nullptr};
  static char** argv = arguments;
  static const dealii::Utilities::MPI::MPI_InitFinalize session(argc, argv, 1);
}

} // namespace asperity::fem
