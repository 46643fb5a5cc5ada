#pragma once

// The text of a case with its overrides: what was run, in one string. Owns the
// "#--set" lines at the end of a text.

#include <string>
#include <vector>

namespace asperity::cases {

/// The text followed by a line "#--set key.path=value" for each override: a
/// comment to TOML, an order to the reader. Reading the result again gives the
/// same case.
std::string text_with_overrides(const std::string& text,
                                const std::vector<std::string>& overrides);

/// The overrides in the "#--set" lines that end a text, in order. Such a line
/// anywhere else is a comment.
std::vector<std::string> overrides_in(const std::string& text);

} // namespace asperity::cases
