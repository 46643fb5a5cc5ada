#pragma once

// Caches the operator on the contact surface of a block between runs.

#include "fem/plugin.hpp"
#include "methods/cache/cache.hpp"

#include <string>

namespace asperity::methods {

/// Returns functions that read and write the cache entry `key`. The entry holds
/// the CPU time of the operator set-up, followed by the bytes of the operator.
///
/// @param threads           number of threads of the set-up; its time is
///                          measured from this call
/// @param saved_setup_time  [s], set when the entry is read; must outlive the
///                          returned functions
fem::OperatorCache operator_cache(Cache& cache, const std::string& key,
                                  int threads, double& saved_setup_time);

} // namespace asperity::methods
