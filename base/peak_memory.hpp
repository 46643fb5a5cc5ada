#pragma once

namespace asperity {

/// The largest resident set size of this program so far [B]; NaN if the system
/// does not provide it. getrusage would include the memory that the parent held
/// when it started this process.
double peak_memory();

} // namespace asperity
