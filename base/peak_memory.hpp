#pragma once

namespace asperity {

/// The largest resident set of this program so far [B]; NaN where the system
/// does not say. getrusage would count what its parent held when it started
/// this process.
double peak_memory();

} // namespace asperity
