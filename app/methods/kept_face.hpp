#pragma once

// The operator of a block's face between two runs.

#include "app/cache/cache.hpp"
#include "fem/plugin.hpp"

#include <string>

namespace asperity::app {

/// Reads and writes the entry `key`; the CPU time that the operator cost stands
/// before its bytes.
/// @param threads           that set-up uses, which begins now
/// @param saved_setup_time  [s], set when the entry is read; outlives the
/// keeper
fem::Keeper keeper_in(Cache& cache, const std::string& key, int threads,
                      double& saved_setup_time);

} // namespace asperity::app
