#include "surfaces/formats/text/number_table.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/text/text_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace asperity::surfaces {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";
constexpr std::string_view separators = " \t\r\f\v,;";

std::string_view without_blanks(std::string_view text) {
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

bool is_missing_word(std::string_view word) {
  static constexpr std::string_view words[] = {
      "nan",     "-nan", "bad",     "void",    "***",    "---",
      "na",      "n/a",  "#n/a",    "null",    "nodata", "no_data",
      "missing", "--",   "1.#qnan", "-1.#ind", "1.#ind"};
  return std::find(std::begin(words), std::end(words), lower_case(word)) !=
         std::end(words);
}

/// The separator of a line of quoted cells: the first of semicolon, tab and
/// comma that it has outside of the quotes.
char separator_of_quoted(std::string_view line) {
  std::string outside;
  bool is_quoted = false;
  for (const char letter : line) {
    if (letter == '"')
      is_quoted = !is_quoted;
    else if (!is_quoted)
      outside += letter;
  }
  for (const char separator : {';', '\t'})
    if (outside.find(separator) != std::string::npos)
      return separator;
  return ',';
}

} // namespace

std::vector<std::string_view> words_of(std::string_view line,
                                       std::string_view between) {
  std::vector<std::string_view> words;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(between, at)) != std::string_view::npos) {
    const std::size_t end =
        std::min(line.find_first_of(between, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::vector<std::string> quoted_cells(std::string_view line) {
  const char separator = separator_of_quoted(line);
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (const char letter : line) {
    if (letter == '"')
      is_quoted = !is_quoted;
    else if (letter == separator && !is_quoted)
      cells.emplace_back();
    else
      cells.back() += letter;
  }
  for (std::string& cell : cells)
    cell = trimmed(cell);
  return cells;
}

void PrintedDigits::take(std::string_view word) {
  int digits = 0, decimals = 0, exponent = 0;
  bool is_behind_point = false;
  std::size_t at = 0;
  for (; at < word.size() && word[at] != 'e' && word[at] != 'E'; ++at) {
    is_behind_point = is_behind_point || word[at] == '.' || word[at] == ',';
    if (word[at] < '0' || word[at] > '9')
      continue;
    digits += digits > 0 || word[at] != '0' ? 1 : 0;
    decimals += is_behind_point ? 1 : 0;
  }
  if (at + 1 < word.size()) {
    word.remove_prefix(at + (word[at + 1] == '+' ? 2 : 1));
    std::from_chars(word.data(), word.data() + word.size(), exponent);
  }
  if (digits < most_ || digits == 0)
    return;
  const double place = std::pow(10.0, exponent - decimals);
  place_ = digits > most_ ? place : std::max(place_, place);
  most_ = digits;
}

void NumberTableReader::take(std::string_view line) {
  ++line_number_;
  if (line_number_ == 1 && line.substr(0, 3) == "\xEF\xBB\xBF")
    line.remove_prefix(3);
  const std::string_view text = without_blanks(line);
  if (text.empty() && !is_empty_row(line))
    return;
  if (text.starts_with('#') || text.starts_with('%'))
    table_.comments.push_back(
        {line_number_, std::string(without_blanks(text.substr(1)))});
  else if (!text.empty() && is_header(text))
    table_.comments.push_back({line_number_, std::string(text)});
  else
    take_row(line);
}

bool NumberTableReader::is_empty_row(std::string_view line) const {
  return !table_.lines.empty() && table_.columns > 1 &&
         static_cast<std::size_t>(std::ranges::count(line, '\t')) ==
             table_.columns - 1;
}

NumberTable NumberTableReader::finish() {
  if (table_.lines.empty())
    throw input::InputError(table_.name + ": contains no numbers");
  return std::move(table_);
}

bool NumberTableReader::is_header(std::string_view line) const {
  if (style_ == NumberStyle::strict || !table_.lines.empty())
    return false;
  if (line.find('=') != std::string_view::npos ||
      is_grid_key(line.substr(0, line.find_first_of(" \t"))))
    return true;
  const auto is_number = [](std::string_view word) {
    return !std::isnan(number_of_text(word)) || is_missing_word(word);
  };
  if (line.find('"') != std::string_view::npos) { // all numbers: no header
    const std::vector<std::string> cells = quoted_cells(line);
    return !std::ranges::all_of(cells, [&](const std::string& cell) {
      return cell.empty() || is_number(cell);
    });
  }
  const auto words = words_of(line, separators);
  if (style_ == NumberStyle::profile && !words.empty() &&
      std::isalpha(static_cast<unsigned char>(words.front().front())) != 0)
    return !is_number(words.front());
  return std::none_of(words.begin(), words.end(), is_number);
}

void NumberTableReader::take_row(std::string_view line) {
  if (style_ != NumberStyle::strict &&
      line.find('"') != std::string_view::npos) {
    take_row(fmt::format("{}", fmt::join(quoted_cells(line), ";")));
    return;
  }
  const bool has_decimal_comma = has_ambiguous_comma(line);
  const bool has_point = line.find('.') != std::string_view::npos;
  if (has_decimal_comma && style_ == NumberStyle::strict)
    refuse_line(
        table_.name, line_number_,
        "found a comma within a column; use a dot as the decimal separator");
  has_commas_ = has_commas_ || has_decimal_comma;
  has_points_ = has_points_ || has_point;
  if (has_commas_ && has_points_)
    refuse_line(table_.name, line_number_,
                "found decimal commas and decimal points in one file; use a "
                "dot as the decimal separator");
  const char separator = separator_of(line, has_decimal_comma);
  if (separator == ' ')
    line = without_blanks(line);
  std::size_t column = 0, n_empty = 0; // cells behind the last word
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(
        line.find(separator == ' ' ? '\n' : separator, begin), line.size());
    const auto words = words_of(line.substr(begin, end - begin), blanks);
    if (words.empty())
      ++n_empty;
    else
      for (; n_empty > 0; --n_empty)
        take_empty_cell(++column);
    for (const std::string_view word : words)
      take_word(word, ++column);
    begin = end + 1;
  }
  const std::size_t columns =
      table_.lines.empty() ? headed_columns(column, n_empty) : table_.columns;
  for (; n_empty > 0 && column < columns; --n_empty)
    take_empty_cell(++column);
  finish_row(column);
}

std::size_t NumberTableReader::headed_columns(std::size_t words,
                                              std::size_t n_empty) const {
  if (style_ == NumberStyle::strict || table_.comments.empty())
    return words;
  std::vector<std::string> heads = quoted_cells(table_.comments.back().text);
  while (!heads.empty() && heads.back().empty())
    heads.pop_back();
  return heads.size() <= words + n_empty ? std::max(heads.size(), words)
                                         : words;
}

char NumberTableReader::separator_of(std::string_view line,
                                     bool has_decimal_comma) const {
  if (line.find(';') != std::string_view::npos)
    return ';';
  if (!has_decimal_comma && line.find(',') != std::string_view::npos)
    return ',';
  const std::string_view text = without_blanks(line);
  const bool has_one_word =
      text.find_first_of(blanks) == std::string_view::npos;
  return text.find('\t') != std::string_view::npos ||
                 (has_one_word && is_empty_row(line))
             ? '\t'
             : ' ';
}

void NumberTableReader::take_empty_cell(std::size_t column) {
  if (style_ == NumberStyle::strict)
    refuse_line(table_.name, line_number_,
                fmt::format("column {}: found an empty cell, but must be a "
                            "finite number",
                            column));
  table_.numbers.push_back(std::nan(""));
}

void NumberTableReader::take_word(std::string_view word, std::size_t column) {
  const bool may_miss = style_ != NumberStyle::strict;
  const bool is_cut = word.front() == ',' || word.back() == ',';
  const double number = is_cut ? std::nan("") : number_of_text(word);
  if (!std::isfinite(number) && !(may_miss && is_missing_word(word)))
    refuse_line(table_.name, line_number_,
                fmt::format("column {}: found '{}', but must be a finite "
                            "number",
                            column, printable(word)));
  table_.numbers.push_back(number);
  if (column <= table_.digits.size() && table_.columns <= 3)
    table_.digits[column - 1].take(word);
}

void NumberTableReader::finish_row(std::size_t columns) {
  if (table_.lines.empty())
    table_.columns = columns;
  if (columns != table_.columns)
    refuse_line(table_.name, line_number_,
                fmt::format("{} numbers in this row, but {} in line {}; "
                            "every row must have the same number",
                            columns, table_.columns, table_.lines.front()));
  table_.lines.push_back(line_number_);
}

void refuse_line(const std::string& name, int line, const std::string& what) {
  throw input::InputError(fmt::format("{}:{}: {}", name, line, what));
}

void each_line(std::string_view text,
               const std::function<bool(std::string_view)>& take) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    if (!take(text.substr(0, end)))
      return;
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  }
}

NumberTable read_number_text(std::string_view text, const std::string& name,
                             NumberStyle style) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw input::InputError(name + ": is written in UTF-16; save it as CSV in "
                                   "UTF-8");
  NumberTableReader reader(name, style);
  each_line(text, [&](std::string_view line) {
    reader.take(line);
    return true;
  });
  return reader.finish();
}

NumberTable read_number_file(const std::string& path) {
  return read_number_text(
      input::read_input_file(path, input::largest_number_file), path);
}

} // namespace asperity::surfaces
