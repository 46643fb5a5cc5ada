#include "app/run/mpi_world.hpp"

#include "fem/plugin.hpp"

#include <cstdlib>
#include <string>

namespace asperity::app {
namespace {

/// Reads the environment variables that mpirun sets: the first is that of Open
/// MPI, the second that of MPICH and related implementations.
bool is_one_of_several() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name))
      return std::string(size) != "1";
  return false;
}

} // namespace

bool has_followed_rank_0() {
  return is_one_of_several() && fem::load_fem_module().has_followed();
}

} // namespace asperity::app
