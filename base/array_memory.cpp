#include "base/array_memory.hpp"

#include <cstdlib> // defines __GLIBC__ where it is

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace asperity {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20, default_mappings = 65536;
  mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
  mallopt(M_MMAP_MAX, default_mappings);    // Open MPI sets it to 0
  mallopt(M_MMAP_THRESHOLD, 32 * megabyte); // the largest value accepted
#endif
}

} // namespace asperity
