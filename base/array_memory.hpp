#pragma once

// What becomes of the memory of freed arrays.

namespace asperity {

/// Lets the process keep freed memory, up to 256 MB, for its next arrays.
/// Without this, a solver that allocates the same fields at every step has each
/// page returned to the system and cleared again. To be called from main(); it
/// has no effect if the C library is not glibc.
void keep_freed_memory();

/// Frees the memory of vectors. The assignment of {} would keep it.
template <class... Vector>
void free_memory(Vector&... vectors) {
  ((vectors = Vector()), ...);
}

} // namespace asperity
