#pragma once

// Locates cases: files, folders, and cases shipped with the program, single or
// in collections.

#include "input/types/case.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::run {

/// A case file and the name of its folder below out/, such as "polymer" or
/// "paper/polymer". If the name is empty, the name of the case is used.
struct FoundCase {
  std::filesystem::path file;
  std::string name;
};

/// The cases that an argument of the command line refers to. A collection is a
/// folder without a case.toml of its own, whose sub-folders have one.
struct FoundCases {
  std::string collection; ///< name of the collection; empty: a single case
  std::filesystem::path folder; ///< folder of the collection
  std::vector<FoundCase> cases; ///< parts in the order of collection.toml, or
                                ///< by name if there is no such file
  std::map<std::string, std::vector<std::string>> figures; ///< shown by each
                                                           ///< part
};

/// Returns true for a folder with a case.toml, and for a collection.
bool is_folder_of_cases(const std::filesystem::path& folder);

/// Returns true for the name of a shipped case or collection.
bool is_shipped(const std::string& word);

/// Finds the cases that an argument refers to: a file, a folder with a
/// case.toml, the name of a shipped case ("polymer", "paper/polymer"), or a
/// collection, which is a folder or a shipped one ("paper").
///
/// @throws input::InputError  none of these; the message names the nearest
///                            shipped case
FoundCases find_cases(const std::string& word);

/// Returns the text of reference.csv beside the case file; empty if there is
/// none.
///
/// @throws input::InputError  the file cannot be read, or is invalid; all
///                            mistakes are listed
std::string reference_text_of(const cases::Case& read);

/// Returns the text of a file; empty if there is none.
///
/// @throws input::InputError  the file cannot be read
std::string text_of_file(const std::filesystem::path& file);

/// Returns the "key=value" lines of quick.set beside a case file, without empty
/// lines and comments (#); none if there is no such file.
std::vector<std::string> quick_overrides(const std::filesystem::path& file);

struct ShippedCase {
  std::string name;
  std::string title;
};

/// Returns the folders of cases/ that contain a case.toml, sorted by name, then
/// each collection followed by its parts. The title of a case that cannot be
/// read says so.
std::vector<ShippedCase> shipped_cases();

/// Returns the folder of the shipped cases: share/asperity/cases beside the
/// folder of the running program if it exists, else cases/ of the source tree.
///
/// @throws std::runtime_error  neither exists; the message names both
std::filesystem::path shipped_cases_folder();

/// Returns the folder of the documentation: share/doc/asperity beside the
/// folder of the running program if it has an index, else docs/ of the source
/// tree; empty if neither exists.
std::filesystem::path documentation_folder();

} // namespace asperity::run
