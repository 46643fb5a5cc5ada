#pragma once

// Where cases are: files, folders, and the names of those shipped with the
// program, alone or in collections.

#include "cases/types/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

/// A case file, and what its folder below out/ is called: "polymer",
/// "paper/polymer"; empty: as the case.
struct FoundCase {
  std::filesystem::path file;
  std::string name;
};

/// What a word on the command line means. A collection is a folder without a
/// case.toml of its own whose sub-folders have one.
struct FoundCases {
  std::string collection;       ///< its name; empty: a single case
  std::filesystem::path folder; ///< of the collection
  std::vector<FoundCase> cases; ///< a collection's in the order in which its
                                ///< README.md names them, `part`, then the rest
};

/// The cases that a word means: a file, a folder that holds case.toml, the name
/// of a shipped case ("polymer", "paper/polymer"); or a collection, a folder or
/// a shipped one ("paper").
/// @throws cases::CaseError  none of these; names the nearest shipped one
FoundCases find_cases(const std::string& word);

/// The text of reference.csv beside the case file; empty if there is none.
/// @throws cases::CaseError  it cannot be read, or has mistakes: all of them
std::string reference_text_of(const cases::Case& read);

/// The text of a file, empty if there is none.
/// @throws cases::CaseError  it cannot be read
std::string text_of_file(const std::filesystem::path& file);

/// The lines of quick.set beside a case file, "key=value" each, without empty
/// ones and comments (#); none if there is no such file.
std::vector<std::string> quick_overrides(const std::filesystem::path& file);

struct ShippedCase {
  std::string name;
  std::string title;
};

/// Every folder of cases/ with a case.toml, by name, and every collection
/// followed by its parts.
std::vector<ShippedCase> shipped_cases();

} // namespace asperity::app
