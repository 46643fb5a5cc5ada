#pragma once

// Where arrays lie in memory. Wherever this library is linked, operator new
// begins large arrays at a cache line, so that no vector of a processor touches
// two of them, and asks the system for huge pages for the largest, which take
// fewer page faults and address translations. No result depends on it.

#include <cstddef>

namespace asperity {

/// Size of a cache line, and of the widest vectors [bytes].
inline constexpr std::size_t cache_line = 64;

/// Arrays of this size and larger ones begin at a cache line; smaller ones are
/// too short for it to matter [bytes].
inline constexpr std::size_t smallest_aligned_array = 4096;

/// Whether operator new is the one of this library. The sanitizers have one of
/// their own.
bool has_aligned_arrays();

/// Lets the process keep freed memory, up to 256 MB, for its next arrays, and
/// asks for huge pages for it. Without this, a solver that allocates the same
/// fields at every step has each page returned to the system and cleared again,
/// which takes a twentieth of the time of a step. The addresses are taken at
/// once, unless RLIMIT_AS limits them. To be called from main(); it has no
/// effect if the C library is not glibc.
void keep_freed_memory();

/// Frees the memory of vectors. The assignment of {} would keep it.
template <class... Vector>
void free_memory(Vector&... vectors) {
  ((vectors = Vector()), ...);
}

} // namespace asperity
