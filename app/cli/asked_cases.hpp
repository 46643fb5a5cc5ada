#pragma once

// What a word of the command line asks for: cases, read with what stands
// beside their files before anything runs.

#include "app/run/case_library.hpp"
#include "cases/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::app {

/// A case with what stands beside its file.
struct ReadCase {
  FoundCase found;
  cases::Case rough_case;
  std::string reference; ///< text of reference.csv
  std::vector<std::string> overrides = {};
};

/// What one word of the command line asked for.
struct Asked {
  FoundCases found;
  std::vector<ReadCase> cases;
};

/// @param word       case file, folder, shipped case or collection
/// @param overrides  "key.path=value", laid over every case
/// @param is_quick   the case's quick.set below the overrides
/// @throws cases::CaseError
Asked read_asked(const std::string& word,
                 const std::vector<std::string>& overrides = {},
                 bool is_quick = false);

} // namespace asperity::app
