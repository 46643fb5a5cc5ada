#pragma once

// This file defines plain text in external input: UTF-8 without control
// characters, which can be printed, plotted and written to JSON, HTML and XML.

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// Position of the first byte that is not valid UTF-8 or that is a control
/// character other than tab, line feed and carriage return; npos if the text is
/// plain. Unassigned code points are plain, surrogates are not.
std::size_t find_not_plain(std::string_view text);

/// `text` in a form that can be shown in a message: at most `longest` bytes,
/// followed by "..." if there were more. A byte that is not plain is taken for
/// a letter of Latin-1, or replaced by '?' if it is none or may be part of a
/// letter that was cut, as is each line end.
std::string printable(std::string_view text, std::size_t longest = 60);

/// `text` without the blanks and tabs at its ends.
std::string trimmed(std::string_view text);

} // namespace asperity
