#include "surfaces/formats/number_table.hpp"

#include "base/plain_text.hpp"
#include "cases/text/case_error.hpp"
#include "cases/text/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace asperity::surfaces {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";
constexpr std::string_view separators = " \t\r\f\v,;";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Whether a line separates its numbers by something other than commas and yet
/// has a comma directly between two characters: "1,5  2,5".
bool has_ambiguous_comma(std::string_view line) {
  if (line.find_first_of(" \t;") == std::string_view::npos)
    return false;
  for (std::size_t at = line.find(','); at != std::string_view::npos;
       at = line.find(',', at + 1)) {
    const bool parts_left =
        at == 0 || separators.find(line[at - 1]) != std::string_view::npos;
    const bool parts_right =
        at + 1 == line.size() ||
        separators.find(line[at + 1]) != std::string_view::npos;
    if (!parts_left && !parts_right)
      return true;
  }
  return false;
}

/// The number represented by the whole word, or NaN.
double parse_number(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-')
    word.remove_prefix(1);
  double number = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc{} || stop != end)
    return std::nan("");
  return number;
}

class TableReader {
public:
  explicit TableReader(const std::string& name) { table_.name = name; }

  void take(std::string_view line) {
    ++line_number_;
    if (line_number_ == 1 && line.substr(0, 3) == "\xEF\xBB\xBF")
      line.remove_prefix(3);
    line = trimmed(line);
    if (line.empty())
      return;
    if (line.front() == '#')
      table_.comments.push_back(
          {line_number_, std::string(trimmed(line.substr(1)))});
    else
      take_row(line);
  }

  NumberTable finish() {
    if (table_.lines.empty())
      throw cases::CaseError(table_.name + ": contains no numbers");
    return std::move(table_);
  }

private:
  void take_row(std::string_view line) {
    if (has_ambiguous_comma(line))
      refuse_line(
          table_.name, line_number_,
          "found a comma within a column; use a dot as the decimal separator");
    std::size_t column = 0;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(separators, at)) !=
           std::string_view::npos) {
      const std::size_t end =
          std::min(line.find_first_of(separators, at), line.size());
      take_word(line.substr(at, end - at), ++column);
      at = end;
    }
    finish_row(column);
  }

  void take_word(std::string_view word, std::size_t column) {
    const double number = parse_number(word);
    if (!std::isfinite(number))
      refuse_line(table_.name, line_number_,
                  fmt::format("column {}: found '{}', but must be a finite "
                              "number",
                              column, printable(word)));
    table_.numbers.push_back(number);
  }

  void finish_row(std::size_t columns) {
    if (table_.lines.empty())
      table_.columns = columns;
    if (columns != table_.columns)
      refuse_line(table_.name, line_number_,
                  fmt::format("{} numbers in this row, but {} in line {}; "
                              "every row must have the same number",
                              columns, table_.columns, table_.lines.front()));
    table_.lines.push_back(line_number_);
  }

  NumberTable table_;
  int line_number_ = 0;
};

} // namespace

void refuse_line(const std::string& name, int line, const std::string& what) {
  throw cases::CaseError(fmt::format("{}:{}: {}", name, line, what));
}

NumberTable read_number_text(std::string_view text, const std::string& name) {
  TableReader reader(name);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.finish();
}

NumberTable read_number_file(const std::string& path) {
  return read_number_text(
      cases::read_input_file(path, cases::largest_number_file), path);
}

} // namespace asperity::surfaces
