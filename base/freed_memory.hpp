#pragma once

namespace asperity {

/// Lets the process keep freed memory, up to 256 MB, for its next arrays.
/// Without this, a solver that allocates the same fields at every step has each
/// page returned to the system and cleared again, which takes a twentieth of
/// the time of a step. To be called from main(); it has no effect if the C
/// library is not glibc.
void keep_freed_memory();

} // namespace asperity
