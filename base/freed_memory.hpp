#pragma once

namespace asperity {

/// Lets the process keep the memory that it frees, up to 256 MB, for its next
/// arrays: a solver that allocates the same fields at every step otherwise
/// has each page given back and cleared anew, a twentieth of a step's time.
/// For a program's main(); does nothing where the C library is not glibc's.
void keep_freed_memory();

} // namespace asperity
