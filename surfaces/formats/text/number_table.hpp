#pragma once

// Reads tables of numbers from text files, as written by instruments and
// scripts. It defines separators, comments and the error messages about invalid
// numbers.

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::surfaces {

/// A line that begins with '#' or '%', without this character, or a header
/// line.
struct CommentLine {
  int line = 0; ///< line number, from 1
  std::string text;
};

/// How the numbers of a file are written.
enum class NumberStyle {
  strict,     ///< finite numbers with a decimal point
  instrument, ///< also decimal commas, words for missing points, and header
              ///< lines before the first row
  profile     ///< as instrument; lines before the first row that begin with a
              ///< letter are headers, too: "Profile 1"
};

/// How precisely the numbers of a column are printed: the place of the last
/// digit among the numbers with the most digits, because %g drops zeros at the
/// end.
class PrintedDigits {
public:
  /// @param word  a number; others have no effect
  void take(std::string_view word);

  /// Largest error of a printed number [unit of the column]; 0 if there is
  /// none.
  double rounding() const { return 0.5 * place_; }

private:
  int most_ = 0; ///< significant digits
  double place_ = 0.0;
};

/// A rectangular table of numbers, row by row.
struct NumberTable {
  std::string name; ///< name of the file, for messages
  std::size_t columns = 0;
  std::vector<double> numbers; ///< columns * lines.size() values, finite except
                               ///< for NaN at the missing points of an
                               ///< instrument
  std::vector<int> lines;      ///< line number of each row, from 1
  std::vector<CommentLine> comments;
  /// Of the first two columns, where positions are, if there are at most three.
  std::array<PrintedDigits, 2> digits = {};

  std::size_t rows() const { return lines.size(); }

  double number(std::size_t row, std::size_t column) const {
    return numbers[row * columns + column];
  }
};

/// Reads a text line by line, as read_number_text() does.
class NumberTableReader {
public:
  NumberTableReader(const std::string& name, NumberStyle style)
      : style_(style) {
    table_.name = name;
  }

  /// @param line  without its end
  /// @throws input::InputError  as read_number_text()
  void take(std::string_view line);

  std::size_t rows() const { return table_.rows(); }

  /// The numbers of the rows since the last call.
  std::vector<double> numbers_so_far() {
    return std::exchange(table_.numbers, {});
  }

  /// @throws input::InputError  the text contains no numbers
  NumberTable finish();

private:
  bool is_header(std::string_view line) const;
  void take_row(std::string_view line);
  void take_word(std::string_view word, std::size_t column);
  void take_empty_cell(std::size_t column);
  /// The columns of the first row, which ends with empty cells: those that are
  /// below a cell of the header line above it are columns.
  std::size_t headed_columns(std::size_t words, std::size_t n_empty) const;
  /// What separates the cells of a row; ' ' for blanks and tabs.
  char separator_of(std::string_view line, bool has_decimal_comma) const;
  /// Whether a line has the tabs of a row, which is empty if it has no more.
  bool is_empty_row(std::string_view line) const;
  void finish_row(std::size_t columns);

  NumberStyle style_;
  NumberTable table_;
  bool has_commas_ = false; ///< a decimal comma was found
  bool has_points_ = false; ///< a decimal point was found
  int line_number_ = 0;
};

/// Returns the cells of a line, some of which are in quotes, without these.
/// They are separated by the first of semicolon, tab and comma that stands
/// outside of quotes.
std::vector<std::string> quoted_cells(std::string_view line);

/// Returns the parts of a line that have none of the characters `between`.
std::vector<std::string_view> words_of(std::string_view line,
                                       std::string_view between);

/// Calls take(line) for the lines of a text, which end with LF, CR LF or CR,
/// until it returns false.
void each_line(std::string_view text,
               const std::function<bool(std::string_view)>& take);

/// Reads a whole text. Numbers are separated by blanks, tabs, commas or
/// semicolons and written with a decimal point, whatever the locale. Lines end
/// with LF, CR LF or CR. Empty lines are skipped, lines that begin with '#' or
/// '%' are comments; a UTF-8 byte order mark is accepted. A comma inside a
/// column is rejected if the columns are separated by something else, because
/// it may be a decimal comma.
///
/// The separator of a row is the first of semicolon, comma and tab that it has,
/// else blanks; tabs may stand beside a comma or semicolon. Nothing between two
/// separators, or before the first one, is an empty cell, which never moves the
/// columns behind it. Empty cells at the end of the first row are no columns,
/// unless the header line above them has them, and may be there in other rows,
/// too.
///
/// In the style of instruments, cells may be in quotes, between which a comma
/// is a decimal comma; empty cells and the words nan, bad, void, *** and ---
/// are missing points in any case of letters; a comma inside a column is a
/// decimal comma unless the line has a decimal point, too; and lines before the
/// first row that contain '=' or no number are kept with the comments.
/// @throws input::InputError  name:line: of the first entry that is not a
///                            finite number, or of a row whose length differs
///                            from the first, or the text contains no numbers
NumberTable read_number_text(std::string_view text, const std::string& name,
                             NumberStyle style = NumberStyle::strict);

/// Reads a whole file in the same way.
/// @throws input::InputError  as above, or the file is not a regular file or is
///                            larger than input::largest_number_file
NumberTable read_number_file(const std::string& path);

/// Reports an error in a line of a file.
/// @throws input::InputError  "name:line: what"
[[noreturn]] void refuse_line(const std::string& name, int line,
                              const std::string& what);

} // namespace asperity::surfaces
