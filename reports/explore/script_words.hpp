#pragma once

// Splits gnuplot scripts into commands and words. It is internal to this
// folder.

#include <string>
#include <vector>

namespace asperity::reports {

/// Returns the commands of a script: its lines, joined where one ends with a
/// backslash. Empty lines and comments are left out.
std::vector<std::string> commands_of(const std::string& script);

/// Splits at blanks and commas that are outside quotes, brackets and
/// parentheses. Quotes are kept: 'a b' is one word.
std::vector<std::string> words_of(const std::string& command);

/// Splits at a separator that is outside quotes and parentheses, and trims the
/// blanks around each part.
std::vector<std::string> split_outside(const std::string& text, char separator);

/// Removes the single quotes around a word.
std::string unquoted(const std::string& word);

} // namespace asperity::reports
