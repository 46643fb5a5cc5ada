#pragma once

// What memory this process may still take. Owns where Linux says it.

#include <string>

namespace asperity {

/// The least of what the system has left, what the limits of its control groups
/// leave, and what the limit on the process' address space leaves [B];
/// infinite where none is known.
double available_memory();

/// "needs 8 TiB of memory, but 12 GiB are available" if `bytes` are more than
/// is available; empty if they are not (or not known: NaN).
std::string memory_shortage(double bytes);

} // namespace asperity
