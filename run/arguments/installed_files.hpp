#pragma once

// Locates the files that belong to the program: shipped cases and
// documentation, of an installation or of the source tree.

#include <filesystem>

namespace asperity::run {

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
