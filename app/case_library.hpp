#pragma once

// Where cases are: files, folders, and the names of those shipped with the
// program.

#include "cases/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

/// The case file that a word on the command line means: a file, a folder that
/// holds case.toml, or the name of a shipped case.
/// @throws cases::CaseError  none of these; names the nearest shipped case
std::filesystem::path find_case(const std::string& word);

/// The text of reference.csv beside the case file; empty if there is none.
/// @throws cases::CaseError  it cannot be read, or has mistakes: all of them
std::string reference_text_of(const cases::Case& read);

struct ShippedCase {
  std::string name;
  std::string title;
};

/// Every folder of cases/ with a case.toml, by name.
std::vector<ShippedCase> shipped_cases();

} // namespace asperity::app
