#pragma once

// Plain text: UTF-8 without control characters, which can be printed, plotted
// and written to scripts, JSON, HTML, XML and HDF5. It owns the limits of names
// and one-line texts that one command writes and others read.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace asperity {

/// Position of the first byte that is not valid UTF-8 or that is a control
/// character other than tab, line feed and carriage return; npos if the text is
/// plain. Unassigned code points are plain, surrogates are not.
std::size_t find_not_plain(std::string_view text);

/// `text` in a form that can be shown in a message: at most `longest` bytes,
/// followed by "..." if there were more. A byte that is not plain is taken for
/// a letter of Latin-1, or replaced by '?' if it is none or may be part of a
/// letter that was cut, as is each line end. It is the
/// form in which a name is written for another program.
std::string printable(std::string_view text, std::size_t longest = 60);

/// `text` with '?' for each byte that is not plain; line ends stay.
std::string plain_text(std::string_view text);

/// The largest name of a method, table, column or problem [bytes].
inline constexpr std::size_t longest_name = 100;

/// Whether a name has 1 to longest_name characters, each of them a letter A-Z
/// or a-z, a digit, a blank or one of . _ + -
bool is_good_name(std::string_view name);

/// `text` as a good name: each other byte is replaced by '-', and what exceeds
/// the limit is cut off. An empty text becomes "-".
std::string good_name(std::string_view text);

/// The largest text on one line: a title, author, version or comment [bytes].
inline constexpr std::size_t longest_line = 1000;

/// Why a text is not one line of plain text of 1 to `longest` bytes, as "must
/// be ..."; empty if it is.
std::string line_mistake(std::string_view text,
                         std::size_t longest = longest_line);

/// `text` without the blanks and tabs at its ends.
std::string trimmed(std::string_view text);

/// The number with which a text begins, written with a decimal point, and what
/// follows it; NaN and the whole text if there is none that a double can hold.
std::pair<double, std::string_view> number_and_rest(std::string_view text);

} // namespace asperity
