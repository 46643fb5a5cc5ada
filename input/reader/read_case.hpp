#pragma once

// Reads a case file into a Case. All parameters enter the program through these
// functions.

#include "input/input_error.hpp"
#include "input/types/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::cases {

struct StackedText;

/// Value for `fields = "all"`; it exceeds the number of steps of any loading
/// path.
inline constexpr int all_fields = 1000000;

/// Reads the case file at `path` and the case given by its `base`, if any
/// (base_case.hpp). The text of the result is then that of the base with one
/// "#--set" line per changed key, and does not depend on other case files.
///
/// @param overrides  "key.path=value" entries in the format of --set, applied
///                   to the file in order before it is interpreted. The value
///                   is TOML or otherwise a string ("surface.length=20 um"
///                   needs no quotes); an empty value removes the key.
/// @throws input::InputError  the file cannot be opened, is not TOML, or has
///                            mistakes, which are all listed, one per line. It
///                            is also thrown if a map or spectrum file named in
///                            the case does not exist.
Case read_case(const std::string& path,
               const std::vector<std::string>& overrides = {});

/// Returns the name of the case in a file: that of its folder if the file is
/// called case.toml, otherwise that of the file without ending. It is printable
/// and at most longest_name bytes long (base/plain_text.hpp).
std::string case_name(const std::filesystem::path& path);

/// Reads the case that base_case.hpp has put together for the file at `path`.
///
/// @throws input::InputError  as read_case()
Case read_stacked_case(const StackedText& stacked, const std::string& path);

/// Reads a case from a text. `path` determines the folder of relative file
/// names, the name of the case and the place in messages; nothing is opened.
/// The "#--set" lines of the text (case_text.hpp) are applied before
/// `overrides`. The text of the result contains both, so read_case_text(c.text,
/// c.path) reproduces c.
Case read_case_text(const std::string& text, const std::string& path,
                    const std::vector<std::string>& overrides = {});

} // namespace asperity::cases
