#pragma once

// Rows of numbers in a text file, as instruments and scripts write them. Owns
// separators, comments and the messages about what is not a number.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// A line that begins with '#', without that sign.
struct CommentLine {
  int line = 0; ///< from 1
  std::string text;
};

/// A rectangular table of finite numbers, row by row.
struct NumberTable {
  std::string name; ///< of the file, for messages
  std::size_t columns = 0;
  std::vector<double> numbers; ///< columns * lines.size() of them
  std::vector<int> lines;      ///< where each row stood, from 1
  std::vector<CommentLine> comments;

  std::size_t rows() const { return lines.size(); }

  double number(std::size_t row, std::size_t column) const {
    return numbers[row * columns + column];
  }
};

/// Reads a whole text. Numbers are parted by blanks, tabs, commas
/// or semicolons and written with a dot, whatever the locale; empty lines are
/// skipped, lines that begin with '#' are comments, Windows line ends and a
/// UTF-8 byte order mark are taken. A comma inside a column that is parted by
/// something else is refused: it may be a decimal comma.
/// @throws cases::CaseError  name:line: of the first thing that is not a finite
///                           number, of a row of another length than the first,
///                           or that there are no numbers at all
NumberTable read_number_text(std::string_view text, const std::string& name);

/// @throws cases::CaseError  the same, and what is no regular file or is larger
///                           than cases::largest_number_file
NumberTable read_number_file(const std::string& path);

/// @throws cases::CaseError  "name:line: what"
[[noreturn]] void refuse_line(const std::string& name, int line,
                              const std::string& what);

} // namespace asperity::surfaces
