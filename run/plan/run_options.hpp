#pragma once

// The options of a run that are not part of its case.

#include "run/methods/chosen.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace asperity::methods {
class Cache;
}

namespace asperity::run {

struct RunOptions {
  std::filesystem::path folder = {}; ///< folder of result.h5
  methods::AskedMethods methods = {};
  bool resume = false;
  int threads = 0;            ///< 0: all hardware threads
  std::string reference = {}; ///< text of the case's reference.csv, or empty
  methods::Cache* cache =
      nullptr; ///< null: compute everything and cache nothing
  std::set<int> realizations = {}; ///< only these; empty: all of the case
  bool has_report = true;   ///< the result is read again when it is complete
  int ranks = 1;            ///< of mpirun, that may share the rows of a surface
  int ranks_on_machine = 1; ///< of these, on this machine
};

} // namespace asperity::run
