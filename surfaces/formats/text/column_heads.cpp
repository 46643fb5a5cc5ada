#include "surfaces/formats/text/column_heads.hpp"

#include "base/plain_text.hpp"
#include "input/units.hpp"
#include "surfaces/formats/length_units.hpp"

#include <algorithm>
#include <string_view>

namespace asperity::surfaces {
namespace {

/// Cells that end behind a bracket or before two blanks.
std::vector<std::string> cells_of_blanks(const std::string& line) {
  std::vector<std::string> cells(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_end =
        (line[i] == ' ' && line.substr(i, 2) == "  ") ||
        (i > 0 && (line[i - 1] == ']' || line[i - 1] == ')') && line[i] == ' ');
    if (!is_end)
      cells.back() += line[i];
    else if (!trimmed(cells.back()).empty())
      cells.emplace_back();
  }
  return cells;
}

std::vector<std::string> cells_of_head(const std::string& line,
                                       std::size_t columns) {
  if (columns == 1)
    return {quoted_cells(line + ';').front()};
  if (line.find_first_of(";,\t") != std::string::npos)
    return quoted_cells(line);
  std::vector<std::string> cells = cells_of_blanks(line);
  if (cells.size() != columns)
    if (const auto words = words_of(line, " \t\r\n\v\f");
        words.size() == columns)
      return {words.begin(), words.end()};
  return cells;
}

/// The head of a column as "name unit" without brackets.
ColumnHead head_without_brackets(const std::string& text) {
  for (const std::string_view between : {"/", " in ", ",", "_", " "}) {
    const std::size_t at =
        between == "/" ? text.find(between) : text.rfind(between);
    if (at == std::string::npos)
      continue;
    const std::string unit = trimmed(text.substr(at + between.size()));
    if (input::unit_called(unit) != nullptr)
      return {lower_case(trimmed(text.substr(0, at))), unit};
  }
  return {lower_case(text), ""};
}

ColumnHead head_of_cell(const std::string& cell) {
  const std::string text = trimmed(cell);
  const std::size_t open = text.find_first_of("[(");
  const std::size_t close = text.find_last_of("])");
  if (open == std::string::npos || close == std::string::npos || close < open)
    return head_without_brackets(text);
  return {lower_case(trimmed(text.substr(0, open))),
          trimmed(text.substr(open + 1, close - open - 1))};
}

} // namespace

std::vector<ColumnHead> column_heads(const std::string& line,
                                     std::size_t columns) {
  std::vector<ColumnHead> heads;
  for (const std::string& cell : cells_of_head(line, columns))
    heads.push_back(head_of_cell(cell));
  while (heads.size() > columns && heads.back().name.empty() &&
         heads.back().unit.empty())
    heads.pop_back();
  return heads;
}

std::vector<CommentLine> lines_above_numbers(const NumberTable& table) {
  std::vector<CommentLine> lines;
  for (const CommentLine& comment : table.comments)
    if (comment.line < table.lines.front())
      lines.push_back(comment);
  std::ranges::reverse(lines);
  return lines;
}

} // namespace asperity::surfaces
