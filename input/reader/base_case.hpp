#pragma once

// Cases that are based on another case: `base = "../polymer/case.toml"`.
// Combines the files into one text that does not depend on any of them.

#include "input/input_error.hpp"
#include "input/text/node.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// An override of a key, and its place for messages.
struct LaidOver {
  std::string entry; ///< "key.path=value" on one line
  Place place;
};

/// The text of the first case in a chain of bases and the overrides of the
/// cases that build on it, in the order of application.
struct StackedText {
  std::string text; ///< text of the file without a base, byte for byte
  std::string path; ///< path of that file
  std::vector<LaidOver> overrides;
};

/// Reads the case file at `path` and the cases on which it is based.
///
/// A file whose first key is `base` contains only changes to the case of that
/// path, which is relative to the file itself. Each of its other keys becomes
/// an override; `key = ""` removes the key or a whole table. Relative paths in
/// the base are rewritten to start at the folder of this file.
///
/// @throws input::InputError  a file cannot be opened or is not TOML; `base` is
///                            not the first key, is not a string, refers back
///                            to itself, or the chain has more than 50 files
StackedText read_stacked(const std::string& path);

/// Returns the parsed text of a case without its overrides. The last one is
/// kept, because all points of a sweep are read from one text, which may name a
/// thousand maps.
/// @throws input::InputError  the text is not TOML
Node parsed_file(const std::string& text, const std::string& path);

/// Returns the parsed text with all overrides applied, for inspection. An
/// override that cannot be applied is left out; reading the case reports it.
///
/// @throws input::InputError  the text is not TOML
Node parsed(const StackedText& stacked);

} // namespace asperity::cases
