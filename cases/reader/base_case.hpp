#pragma once

// A case that stands on another: `base = "../polymer/case.toml"`. Owns the way
// from the two files to one text that needs neither again.

#include "cases/text/case_error.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// A key laid over a text, and the place of it that messages name.
struct LaidOver {
  std::string entry; ///< "key.path=value" on one line
  Place place;
};

/// The text at the bottom of a chain of cases and what the others lay over it,
/// the nearest to the bottom first.
struct StackedText {
  std::string text; ///< of the file without a base, byte for byte
  std::string path; ///< of that file
  std::vector<LaidOver> overrides;
};

/// Read the case file at `path` and what it stands on.
///
/// A file whose first key is `base` is nothing but changes to the case of that
/// name, a path relative to the file itself. Each of its other keys becomes an
/// override; `key = ""` takes the key, or a whole table, away. A relative path
/// that the base names is rewritten so that it starts at this file's folder.
///
/// @throws CaseError  a file cannot be opened or is no TOML; base is not the
///                    first key, not a text, or leads in a circle
StackedText read_stacked(const std::string& path);

} // namespace asperity::cases
