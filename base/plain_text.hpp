#pragma once

// What counts as text from outside: UTF-8 without control characters, so that
// it can be printed, plotted and written into JSON, HTML and XML.

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// Where the first byte stands that is no part of UTF-8 or is a control
/// character other than tab, line feed and carriage return; npos if the text is
/// plain. Unassigned code points are plain, surrogates are not.
std::size_t find_not_plain(std::string_view text);

/// `text` as a message may show it: at most `longest` bytes and "..." behind
/// them if there were more, '?' for each byte that is not plain and for each
/// line end.
std::string printable(std::string_view text, std::size_t longest = 60);

/// `text` without the blanks and tabs at its ends.
std::string trimmed(std::string_view text);

} // namespace asperity
