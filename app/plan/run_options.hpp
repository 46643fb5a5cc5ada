#pragma once

// What a run is asked for besides its case.

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

class Cache;

struct RunOptions {
  std::filesystem::path folder;     ///< of result.h5
  std::vector<std::string> methods; ///< names or kinds; empty: all
  bool resume = false;
  int threads = 0;            ///< 0: as many as the machine has
  std::string reference = {}; ///< text of the case's reference.csv, or empty
  Cache* cache = nullptr;     ///< null: all is computed, nothing is kept
  bool is_exact = false; ///< `methods` are names alone: "fem" is not "fem.hard"
};

} // namespace asperity::app
