#pragma once

// Determines the memory that this process may still allocate, from the
// information that Linux provides.

#include <string>

namespace asperity {

/// The minimum [B] of the memory available in the system, the memory that the
/// limits of the control groups of the process allow, and the memory that the
/// limit on its address space allows; infinite if none is known.
double available_memory();

/// "needs 8 TiB of memory, but 12 GiB are available" if `bytes` exceeds the
/// available memory; empty otherwise, or if `bytes` is unknown (NaN).
std::string memory_shortage(double bytes);

} // namespace asperity
